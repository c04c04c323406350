"""partition yes|no N COMMAND..."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("partition")
def partition(sim: Simulation, args: Args) -> None:
    """Carry out a command on some partitions, or on all others: here there is partition 1 alone."""
    args.need(3)
    wanted = args.yes()
    inside = 1 in args.types(1)
    words = args.rest()
    if words[0].text == "partition":
        args.illegal(words[0])
    if inside == wanted:
        sim.script.execute_rest(words[0])
