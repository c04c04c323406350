"""run_style verlet"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import is_elsewhere, unsupported
from pylmp.text.words import Args


@command("run_style", needs_box=True)
def run_style(sim: Simulation, args: Args) -> None:
    """The time integrator: velocity Verlet."""
    if not len(args):
        args.missing()
    style = args.word()
    if is_elsewhere("integrate", style.text):
        raise unsupported("integrate", style)
    if style.text != "verlet":
        args.fail(f"Unknown integrate style {style.text}", style, hint="verlet")
    args.rest()
