"""balance THRESHOLD STYLE arguments..."""

from __future__ import annotations

from pylmp.io.ready import initialise, wrap_atoms
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args

_WORDS = {"x": 1, "y": 1, "z": 1, "shift": 3, "rcb": 0}  # how many follow each style


@command("balance", needs_box=True)
def balance(sim: Simulation, args: Args) -> None:
    """Accepted, without effect: one process has all the work. Atoms are wrapped into the box, as in LAMMPS."""
    sim.console.both("Balancing ...\n")
    if len(args) < 2:
        args.missing()
    threshold, style = args.number(), args.word()
    if style.text not in _WORDS:
        args.fail(f"Unknown (fix) balance keyword {style.text}", style, hint=" ".join(_WORDS))
    if style.text == "rcb" and sim.communication == "brick":
        args.fail("Balance rcb cannot be used with comm_style brick", style, hint="comm_style tiled")
    args.need(_WORDS[style.text], style.text)
    if threshold < 1.0:
        raise Unsupported("LAMMPS balances one process with a threshold below 1, pylmp's native engines do not", style.span)
    initialise(sim)
    wrap_atoms(sim)
    sim.console.note("balance changes nothing: pylmp runs in one process")
