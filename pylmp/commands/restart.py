"""restart 0 | N BASE | N FILE1 FILE2 [fileper N] [nfile N]"""

from __future__ import annotations

from dataclasses import replace

from pylmp.commands.write_restart import read_pieces
from pylmp.io.restart.schedule import Restarts, Series
from pylmp.model.paths import writable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("restart")
def restart(sim: Simulation, args: Args) -> None:
    """Write a restart file every N steps of runs: each to a name of its own (BASE.STEP, or the step in place of *), or to two in turn."""
    args.need(1)
    number = args.word()
    variable = number.text[2:] if number.text.startswith("v_") else ""
    every = 0 if variable else args.as_integer(number)
    if not variable and every == 0:
        if len(args):
            args.illegal(args.owner, hint="restart 0")
        sim.output.restarts = None
        return
    if not len(args):
        args.illegal(args.owner, hint="restart N BASE, or restart N FILE1 FILE2")
    names = [args.word() for _ in range(1 if len(args) % 2 else 2)]
    if len(names) == 1 and "*" not in names[0].text:
        names[0] = replace(names[0], text=f"{names[0].text}.*")
    if len(names) == 2 and ("%" in names[0].text) != ("%" in names[1].text):
        args.fail("Both restart files must use % or neither", names[1])
    while len(args):
        read_pieces(args, args.word(), "%" in names[0].text)
    for name in names:
        writable(sim, name)
    if sim.output.restarts is None:
        sim.output.restarts = Restarts()
    series = Series(names, every, variable)
    if len(names) == 1:
        sim.output.restarts.single = series
    else:
        sim.output.restarts.double = series
