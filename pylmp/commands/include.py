"""include FILE"""

from __future__ import annotations

from pylmp.model.paths import readable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("include")
def include(sim: Simulation, args: Args) -> None:
    """Carry out the commands of another file, then go on."""
    if len(args) != 1:
        args.illegal(args.owner)
    word = args.word()
    sim.script.run_file(readable(sim, word), word.span)
