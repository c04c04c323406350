"""run N [upto] [start S] [stop S] [pre yes|no] [post yes|no] [every M "command" ...]"""

from __future__ import annotations

from dataclasses import dataclass

from pylmp.io.ready import initialise
from pylmp.io.run_log import footer, loop_time
from pylmp.model.checks import warn_motionless
from pylmp.model.engine import RunPlan
from pylmp.model.registry import command
from pylmp.model.scene import state
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word

_MAX_STEPS = 2**31 - 1


@dataclass
class _Request:
    """What the words of one run command say; start, stop: None where not given."""

    steps: int
    start: int | None = None
    stop: int | None = None
    pre: bool = True
    post: bool = True
    every: int = 0
    commands: tuple[Word, ...] = ()


@command("run", needs_box=True)
def run(sim: Simulation, args: Args) -> None:
    """Advance the simulation."""
    if sim.timer.passed:
        return
    args.need(1)
    request = _read(sim, args)
    left, first = request.steps, True
    while first or left > 0:
        steps = min(request.every, left) if request.every else left
        left -= steps
        # Without start and stop, each part of run ... every is a ramp of its own.
        begin = sim.step if request.start is None else request.start
        end = sim.step + steps if request.stop is None else request.stop
        setup = request.pre or (first and not sim.ran)
        _segment(sim, RunPlan(steps, begin, end, setup), post=request.post or (request.every > 0 and left == 0))
        sim.interrupts.obey()
        if request.commands:
            sim.asking.block()
        for word in request.commands:
            sim.script.execute(word.text)
        if request.commands:
            sim.asking.again(sim.step + request.every)
        if sim.halted:
            break
        first = False


def _segment(sim: Simulation, plan: RunPlan, post: bool) -> None:
    """One run of the engine with the log around it."""
    assert sim.engine is not None
    sim.begin, sim.end = plan.begin, plan.end
    sim.output.begin(sim.step, sim.step + plan.steps, plan.setup)
    try:
        if plan.setup:
            warn_motionless(sim)
            initialise(sim)
        sim.report = sim.engine.run(sim, state(sim), plan)
        sim.ran = True
    finally:
        sim.output.end()
    sim.output.thermo.end()
    sim.console.both(loop_time(sim, sim.report))
    if post:
        sim.console.both(footer(sim, sim.report))
    sim.console.flush()


def _read(sim: Simulation, args: Args) -> _Request:
    number = args.word()
    request = _Request(args.as_integer(number, 64))
    upto, given = False, {}
    while len(args):
        key = args.word()
        given[key.text] = args.peek()
        if key.text not in ("upto", "start", "stop", "pre", "post", "every"):
            args.fail(f"Unknown run keyword: {key.text}", key, hint="upto start stop pre post every")
        if key.text == "upto":
            upto = True
            continue
        if len(args) < (2 if key.text == "every" else 1):
            hint = 'every M "command" "command", or every M NULL' if key.text == "every" else ""
            args.fail(f"Illegal run {key.text} command: missing argument(s)", key, hint=hint)
        if key.text == "start":
            request.start = args.integer(64)
        elif key.text == "stop":
            request.stop = args.integer(64)
        elif key.text == "pre":
            request.pre = args.yes()
        elif key.text == "post":
            request.post = args.yes()
        else:
            request.every = args.integer()
            if request.every <= 0:
                args.fail(f"Invalid run every argument: {request.every}", hint="a positive number of steps")
            request.commands = tuple(args.rest())
            if len(request.commands) == 1 and request.commands[0].text == "NULL":
                request.commands = ()
    _check(sim, args, request, upto, number, given)
    return request


def _check(
    sim: Simulation, args: Args, request: _Request, upto: bool, number: Word, given: dict[str, Word | None]
) -> None:
    """Step numbers that make sense; turns upto's step number into a count."""
    now = sim.step
    if not 0 <= request.steps - (now if upto else 0) <= _MAX_STEPS:
        if upto:
            args.fail(f"Invalid run command upto value: {request.steps}. Must be >= {now}", number)
        args.fail(f"Invalid run command N value: {request.steps}", number, hint=f"0 to {_MAX_STEPS}")
    if upto:
        request.steps -= now
    last = now + request.steps
    if request.start is not None:
        if request.start < 0:
            args.fail(f"Invalid run command start value: {request.start}", given["start"])
        if request.start > now:
            text = f"Run command start value {request.start} is after start of run at step {now}"
            args.fail(text, given["start"])
    if request.stop is not None:
        if request.stop < 0:
            args.fail(f"Invalid run command stop value: {request.stop}", given["stop"])
        if request.stop < last:
            args.fail(f"Run command stop value {request.stop} is before end of run at step {last}", given["stop"])
