"""read_restart FILE: * in the name finds the largest step, % reads a set of files."""

from __future__ import annotations

from dataclasses import replace

from pylmp.io.restart.files import latest, read_restart
from pylmp.io.restart.layout import VERSION
from pylmp.io.restart.restore import restore
from pylmp.model.paths import readable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("read_restart")
def read_restart_command(sim: Simulation, args: Args) -> None:
    """Continue from a restart file, one of LAMMPS or one of pylmp."""
    if not 1 <= len(args) <= 2:
        args.illegal(args.owner, hint="read_restart FILE")
    if sim.has_box:
        args.fail("Cannot read_restart after simulation box is defined", args.owner, hint="clear starts anew")
    name = args.word()
    if len(args) and args.word().text != "remap":  # an old keyword, without effect
        args.illegal(hint="read_restart FILE")
    sim.console.both("Reading restart file ...\n")
    readable(sim, name)
    content = read_restart(latest(name.text) if "*" in name.text else name.text, lambda path: readable(sim, replace(name, text=path)))
    sim.console.both(f"  restart file = {content.header['version']}, LAMMPS = {VERSION}\n")
    restore(sim, content)
    sim.console.both("  read_restart CPU = 0.000 seconds\n")
