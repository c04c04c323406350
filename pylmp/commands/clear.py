"""clear"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("clear")
def clear(sim: Simulation, args: Args) -> None:
    """Forget everything but variables, the log and the working directory."""
    if len(args):
        args.fail(f"Illegal clear command: unexpected arguments but found {len(args)}", args.peek())
    sim.finish()
    sim.script.variables.clear()
    sim.clear()
