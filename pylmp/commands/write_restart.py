"""write_restart FILE [fileper N] [nfile N] [noinit]: * in the name becomes the step; with % the atoms stand in a file of their own."""

from __future__ import annotations

from dataclasses import replace

from pylmp.io.ready import initialise, wrap_atoms
from pylmp.io.restart.files import write_restart
from pylmp.model.ghosts import Ghosts
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word


@command("write_restart", needs_box=True)
def write_restart_command(sim: Simulation, args: Args) -> None:
    """Write a restart file that LAMMPS continues from to the last bit, and read_restart here."""
    args.need(1)
    name = args.word()
    name = replace(name, text=name.text.replace("*", str(sim.step), 1))
    ready = False
    while len(args):
        key = args.word()
        if key.text == "noinit":
            ready = True
        else:
            read_pieces(args, key, "%" in name.text)
    if not ready:
        sim.console.both("System init for write_restart ...\n")
        initialise(sim)
        # IDs of new ghosts stay in the rows beyond the owned atoms: what bonds remember goes back to the slots of those whose ends
        # still are in the rows that the bond lists of the last run name, as in LAMMPS.
        wrap_atoms(sim, Ghosts(sim) if any(listed.memory for listed in sim.bond_lists) else None)
        sim.atoms.clear_ghosts()
    write_restart(sim, name)


def read_pieces(args: Args, key: Word, in_pieces: bool) -> None:
    """nfile N or fileper N: into how many pieces the processes of LAMMPS write; here there is one."""
    if key.text not in ("fileper", "nfile"):
        args.fail(f"Unknown write_restart keyword: {key.text}", key, hint="fileper nfile noinit")
    if not in_pieces:
        args.fail(f"Cannot use write_restart {key.text} without % in restart file name", key, hint="a name such as state.%.rst")
    if not len(args):
        args.fail(f"Illegal write_restart {key.text} command: missing argument(s)", key, hint=f"{key.text} N")
    count = args.integer()
    if count <= 0:
        says = f"Invalue write_restart fileper value {count}:" if key.text == "fileper" else f"Invalid write_restart nfile value {count}"
        args.fail(says, hint="1 or more")
