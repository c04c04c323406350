"""uncompute ID"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("uncompute")
def uncompute(sim: Simulation, args: Args) -> None:
    """Delete a compute."""
    if len(args) != 1:
        args.illegal(args.owner)
    word = args.word()
    if word.text not in sim.computes:
        args.fail(f"Could not find compute ID {word.text} to delete", word)
    sim.computes.pop(word.text).removed(sim)
