"""thermo N: a thermo line every N steps; thermo v_NAME: the next one at the step that a variable gives."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("thermo")
def thermo(sim: Simulation, args: Args) -> None:
    """Interval of the thermo table; 0: only the first and last step of a run."""
    if len(args) != 1:
        args.illegal(args.owner, hint="thermo N or thermo v_NAME")
    word = args.word()
    if word.text.startswith("v_"):
        sim.output.variable = word.text[2:]
        return
    every = args.as_integer(word)
    if every < 0:
        args.fail(f"Illegal thermo output frequency {every}", word, hint="0 or a positive number of steps")
    sim.output.every, sim.output.variable = every, ""
