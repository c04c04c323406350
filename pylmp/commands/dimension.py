"""dimension 2|3"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("dimension")
def dimension(sim: Simulation, args: Args) -> None:
    """Two or three dimensions."""
    if len(args) != 1:
        args.fail(f"Dimension command expects exactly 1 argument, but found {len(args)}", args.owner)
    if sim.has_box:
        args.fail("Dimension command after simulation box is defined", args.owner)
    word = args.word()
    value = args.as_integer(word)
    if value not in (2, 3):
        args.fail(f"Invalid dimension argument: {word.text}", word, hint="2 or 3")
    sim.dimension = value
    for compute in sim.computes.values():
        if hasattr(compute, "extra_dof"):
            compute.extra_dof = value
