"""comm_modify cutoff R vel yes|no mode single"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.number import shortest
from pylmp.text.words import Args


@command("comm_modify")
def comm_modify(sim: Simulation, args: Args) -> None:
    """How far ghost atoms reach, and whether they carry velocities."""
    args.need(1)
    while len(args):
        key = args.word()
        if key.text == "cutoff":
            args.need(1, key.text)
            word = args.word()
            value = args.as_number(word)
            if value < 0.0:
                args.fail(f"Invalid cutoff {shortest(value)} in comm_modify command", word, hint="zero or more")
            sim.comm.cutoff = value
        elif key.text == "vel":
            args.need(1, key.text)
            sim.comm.velocity = args.yes()
        elif key.text == "mode":
            args.need(1, key.text)
            mode = args.word()
            if mode.text == "multi":  # neighbor multi is LAMMPS's only
                args.fail("Cannot use comm mode 'multi' without 'multi' style neighbor lists", mode, hint="single")
            if mode.text == "multi/old":
                raise Unsupported(f"LAMMPS has comm_modify mode {mode.text}, pylmp's native engines do not", mode.span)
            if mode.text != "single":
                args.fail(f"Unknown comm_modify mode argument: {mode.text}", mode, hint="single")
        elif key.text == "cutoff/multi":
            args.fail("Use cutoff keyword to set cutoff in single mode", key, hint="cutoff R")
        elif key.text == "reduce/multi":
            args.fail("Use reduce/multi in mode multi only", key)
        elif key.text == "group":
            args.need(1, key.text)
            name = args.word()
            if not sim.groups.bit(name.text):
                args.fail(f"Invalid comm_modify keyword: group {name.text} not found", name)
            if name.text != "all":
                raise Unsupported(
                    "LAMMPS has comm_modify group, pylmp's native engines do not", name.span, hint="group all"
                )
        else:
            args.fail(f"Unknown comm_modify keyword: {key.text}", key, hint="cutoff vel mode")
