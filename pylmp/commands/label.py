"""label NAME"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("label")
def label(sim: Simulation, args: Args) -> None:
    """A place to jump to; carrying it out does nothing."""
    if len(args) != 1:
        args.illegal(args.owner)
