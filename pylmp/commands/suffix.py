"""suffix on | off | STYLE | hybrid STYLE STYLE"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("suffix")
def suffix(sim: Simulation, args: Args) -> None:
    """Accepted, without effect: each style has one implementation here."""
    count = len(args)
    words = [word.text for word in args.rest()]
    if not words or (words[0] == "hybrid") != (count == 3) or count == 2:
        args.illegal(args.owner, hint="suffix on, off, a suffix, or hybrid and two suffixes")
    if words[0] == "on" and not sim.suffixed:
        args.fail("May only enable suffixes after defining one", hint="suffix omp")
    if words[0] not in ("on", "off"):
        sim.suffixed = True
    sim.console.note("suffix changes nothing: each style has one implementation here")
