"""minimize ETOL FTOL MAXITER MAXEVAL"""

from __future__ import annotations

from dataclasses import replace

from pylmp.io.ready import initialise
from pylmp.io.run_log import loop_time, minimized
from pylmp.model.minimize import MinPlan
from pylmp.model.registry import command
from pylmp.model.scene import state
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word

_MOST = 2**31 - 1


@command("minimize", needs_box=True)
def minimize(sim: Simulation, args: Args) -> None:
    """Move the atoms to a minimum of the energy, with the style of min_style."""
    args.expect(4, 4, "4 arguments")
    if sim.timer.passed:
        return
    etol, ftol = (_tolerance(args, word, name) for word, name in zip(args.words[:2], ("energy", "force"), strict=True))
    plan = MinPlan(etol, ftol, *(_count(args, word, what) for word, what in zip(args.words[2:], ("iterations", "evaluations"), strict=True)))
    before = sim.neighbor
    sim.neighbor = replace(before, every=1, delay=0, check=True)
    if before != sim.neighbor:
        sim.console.both("Switching to 'neigh_modify every 1 delay 0 check yes' setting during minimization\n")
    sim.begin, sim.end = sim.step, sim.step + plan.maxiter
    sim.output.begin(sim.step, sim.end, True, timeless=True)
    sim.relaxing = True
    try:
        initialise(sim)
        assert sim.engine is not None
        sim.report, result = sim.engine.minimize(sim, state(sim), plan)
        sim.ran = True
    finally:
        sim.relaxing = False
        sim.output.end()
        sim.neighbor = before
    sim.output.thermo.end()
    sim.console.both(loop_time(sim, sim.report).rstrip("\n") + "\n\n" + minimized(sim, sim.report, result))
    sim.console.flush()
    sim.interrupts.obey()


def _tolerance(args: Args, word: Word, name: str) -> float:
    value = args.as_number(word)
    if value < 0.0:
        args.fail(f"Illegal minimize {name} tolerance: {value:g}", word, hint="0.0 or more")
    return value


def _count(args: Args, word: Word, what: str) -> int:
    value = args.as_integer(word)
    if not 0 <= value <= _MOST:
        args.fail(f"Illegal minimize maximum {what}: {value}", word, hint=f"0 to {_MOST}")
    return value
