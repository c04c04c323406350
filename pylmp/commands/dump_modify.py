"""dump_modify ID KEYWORD VALUE..."""

from __future__ import annotations

from pylmp.dumps.settings import modify
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("dump_modify")
def dump_modify(sim: Simulation, args: Args) -> None:
    """Change the settings of a dump."""
    args.need(2)
    word = args.word()
    if word.text not in sim.output.dumps:
        known = " ".join(sim.output.dumps)
        args.fail(
            f"Could not find dump_modify ID: {word.text}", word, hint=f"dumps: {known}" if known else "dump comes first"
        )
    modify(sim.output.dumps[word.text], sim, args)
