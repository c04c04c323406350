"""undump ID"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("undump")
def undump(sim: Simulation, args: Args) -> None:
    """End a dump and close its file."""
    if len(args) != 1:
        args.illegal(args.owner, hint="undump ID")
    word = args.word()
    if word.text not in sim.output.dumps:
        args.fail(f"Could not find undump ID: {word.text}", word, hint=f"dumps: {' '.join(sim.output.dumps)}")
    sim.output.dumps.pop(word.text).close()
