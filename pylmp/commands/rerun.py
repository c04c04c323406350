"""rerun FILE... [first N] [last N] [every N] [skip N] [start N] [stop N] [post yes|no] dump FIELDS and keywords of read_dump

Source: LAMMPS manual, rerun.html.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from pylmp.io.ready import initialise
from pylmp.io.run_log import footer, loop_time
from pylmp.io.snapshot import Reader, Request, read_request
from pylmp.model.checks import warn_motionless
from pylmp.model.paths import readable
from pylmp.model.registry import command
from pylmp.model.scene import state
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_KEYWORDS = ("first", "last", "every", "skip", "start", "stop", "post", "dump")
_NEVER = 2**63 - 1


@dataclass
class _Plan:
    """Which snapshots; start, stop: what ramps refer to, below 0: not given."""

    files: list[str]
    first: int = 0
    last: int = _NEVER
    every: int = 0
    skip: int = 1
    start: int = -1
    stop: int = -1
    post: bool = False


@command("rerun", needs_box=True)
def rerun(sim: Simulation, args: Args) -> None:
    """Forces and output of the snapshots of dumps, one after the other."""
    plan, request = _read(sim, args)
    reader = Reader(sim, plan.files, request)
    assert sim.engine is not None
    sim.begin = plan.start if plan.start >= 0 else plan.first
    sim.end = plan.stop if plan.stop >= 0 else plan.last
    sim.output.begin(sim.begin, plan.stop if plan.stop >= 0 else plan.last, True, timeless=True)
    try:
        warn_motionless(sim)
        initialise(sim)
        sim.report = sim.engine.replay(sim, state(sim), _frames(sim, reader, plan))
        sim.ran = True
    finally:
        sim.output.end()
    sim.output.thermo.end()
    sim.console.both(loop_time(sim, sim.report))
    if plan.post:
        sim.console.both(footer(sim, sim.report))
    sim.console.flush()
    sim.interrupts.obey()


def _frames(sim: Simulation, reader: Reader, plan: _Plan) -> Iterator[None]:
    """Make each chosen snapshot the simulation's state. Steps ascend; those that do not are passed over."""
    before, passed = -1, 0
    for snapshot in reader.snapshots():
        if snapshot.step < plan.first or snapshot.step <= before:
            continue
        if snapshot.step > plan.last:
            break
        if before >= 0:
            if plan.every and snapshot.step % plan.every:
                continue
            passed += 1
            if passed % plan.skip:
                continue
        if 0 <= plan.stop < snapshot.step:
            raise ScriptError(f"Read rerun dump file timestep {snapshot.step} > specified stop {plan.stop}", manual="rerun.html")
        before = snapshot.step
        sim.step = snapshot.step
        sim.output.clock.book(sim.step, sim.dt)
        reader.apply(snapshot)
        yield
    if before < 0:
        raise ScriptError("Rerun dump file does not contain requested snapshot", manual="rerun.html")


def _read(sim: Simulation, args: Args) -> tuple[_Plan, Request]:
    plan = _Plan([])
    while (word := args.peek()) is not None and word.text not in _KEYWORDS:
        plan.files.append(str(readable(sim, args.word())))
    if not plan.files or not len(args):
        args.illegal(args.owner, hint="rerun FILE dump x y z")
    while True:
        key = args.word()
        if key.text not in _KEYWORDS or not len(args):
            args.illegal(key, hint=" ".join(_KEYWORDS))
        if key.text == "dump":
            break
        if key.text == "post":
            plan.post = args.yes()
            if not len(args):
                args.illegal(hint="dump, and the fields to read, come last")
            continue
        value = args.integer()
        if value < (1 if key.text == "skip" else 0):
            args.illegal(hint="0 or more" if key.text != "skip" else "1 or more")
        setattr(plan, key.text, value)
        if not len(args):
            args.illegal(hint="dump, and the fields to read, come last")
    if plan.first > plan.last or 0 <= plan.stop < plan.start:
        args.illegal(args.owner, hint="first is not above last")
    return plan, read_request(sim, args, any("%" in name for name in plan.files))
