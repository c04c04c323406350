"""quit [CODE]"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.leave import Quit
from pylmp.text.words import Args


@command("quit")
def quit_(sim: Simulation, args: Args) -> None:
    """End the script with an exit code."""
    code = args.integer() if len(args) else 0
    if len(args):
        args.illegal(args.peek())
    raise Quit(code)
