"""comm_style brick | tiled"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("comm_style")
def comm_style(sim: Simulation, args: Args) -> None:
    """Accepted, without effect: there is one process."""
    if not len(args):
        args.missing()
    style = args.word()
    if style.text not in ("brick", "tiled"):
        args.fail(f"Unknown comm_style argument: {style.text}", style, hint="brick or tiled")
    args.rest()
    if style.text == "brick" and sim.layout == "tiled":
        args.fail("Cannot change to comm_style brick from tiled layout", style, hint="before balance rcb")
    sim.communication = style.text
    if style.text == "tiled":
        sim.console.note("comm_style changes nothing: pylmp runs in one process")
