"""label NAME"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("label")
def label(sim: Simulation, args: Args) -> None:
    """A place to jump to; carrying it out does nothing."""
    args.expect(1, 1, "1 argument")
