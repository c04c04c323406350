"""next NAME..."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("next")
def next_(sim: Simulation, args: Args) -> None:
    """Advance variables; when they are used up they vanish, and the next jump is skipped."""
    if sim.script.variables.advance(args, sim.script.scope):
        sim.script.skip_next_jump()
