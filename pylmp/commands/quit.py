"""quit [CODE]"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.leave import Quit
from pylmp.text.words import Args


@command("quit")
def quit_(sim: Simulation, args: Args) -> None:
    """End the script with an exit code."""
    args.expect(0, 1, "0 or 1 argument")
    raise Quit((args.integer() if len(args) else 0) & 255)
