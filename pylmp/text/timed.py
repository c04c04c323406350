"""Functions of the run's clock: values that follow the step number, and sequences of steps.

Source: LAMMPS manual, variable.html; roundings as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from pylmp.text.formula_error import FormulaError, require

_NEVER = float(2**63 - 1024)  # a step that does not come
_MOST = 10_000_000  # steps of a sequence looked at in one evaluation


class Clock(NamedTuple):
    """What functions of time refer to: current step, first and last step of the run, timestep size."""

    step: int
    begin: int
    end: int
    dt: float


def _whole(x: float) -> int:
    """As C casts to a 64-bit integer."""
    return int(x) if abs(x) < 2.0**63 else -(2**63)


def ramp(a: float, b: float, clock: Clock) -> float:
    """From a at the start of the run to b at its end."""
    steps = clock.end - clock.begin
    part = (clock.step - clock.begin) / steps if steps else 0.0
    return a + part * (b - a)


def vdisplace(a: float, b: float, clock: Clock) -> float:
    """a, moving with velocity b."""
    return a + b * (clock.step - clock.begin) * clock.dt


def _phase(c: float, clock: Clock, name: str) -> float:
    if c == 0.0:
        raise FormulaError(f"Invalid {name}(x,y,z) function in variable formula: z must be > 0")
    return 2.0 * math.pi / c * (clock.step - clock.begin) * clock.dt


def _circular(x: float, name: str) -> float:
    return float(getattr(math, name)(x)) if math.isfinite(x) else -math.nan


def swiggle(a: float, b: float, c: float, clock: Clock) -> float:
    """a, swinging by b with period c as the sine does."""
    return a + b * _circular(_phase(c, clock, "swiggle"), "sin")


def cwiggle(a: float, b: float, c: float, clock: Clock) -> float:
    """a, swinging by b with period c as 1 - cosine does."""
    return a + b * (1.0 - _circular(_phase(c, clock, "cwiggle"), "cos"))


def stagger(a: float, b: float, clock: Clock) -> float:
    """Steps 0, b, a, a+b, 2a, ... in turn."""
    every, offset = _whole(a), _whole(b)
    require(every > 0 and offset > 0 and every > offset)
    low = clock.step - clock.step % every
    return float(low + offset if clock.step - low < offset else low + every)


def logfreq(a: float, b: float, c: float, clock: Clock) -> float:
    """Steps a 2a ... ba, then times c, and so on."""
    first, many, factor = _whole(a), _whole(b), _whole(c)
    require(first > 0 and many > 0 and factor > 0 and many < factor)
    if clock.step < first:
        return float(first)
    low = first
    while clock.step >= factor * low:
        low *= factor
    multiple = clock.step // low
    return float((multiple + 1) * low if multiple < many else factor * low)


def logfreq2(a: float, b: float, c: float, clock: Clock) -> float:
    """From a to ca in b equal parts, from ca to cca in b, and so on; rounded up."""
    first, many, factor = _whole(a), _whole(b), _whole(c)
    require(first > 0 and many > 0 and factor > 0)
    value, count = float(first), 0
    delta = first * (factor - 1.0) / many
    while clock.step >= value:
        require(factor > 1 and count < _MOST)  # LAMMPS does not return
        value += delta
        count += 1
        if count % many == 0:
            delta *= factor
    return float(math.ceil(value))


def logfreq3(a: float, b: float, c: float, clock: Clock) -> float:
    """b steps from a to c, each a fixed multiple of the one before but at least one step later; rounded up."""
    first, many, last = _whole(a), _whole(b), _whole(c)
    require(first > 0 and many > 1 and last > 0 and last - first >= many - 1)
    ratio = math.pow(last / first, 1.0 / (many - 1))
    if clock.step >= last:
        if clock.step > last:
            raise FormulaError("Calls to variable exceeded limit", plain=True)
        return float(math.floor((last - 1) * ratio + 0.5) + 1)
    for k in range(min(many - 1, _MOST)):
        value = max(math.ceil(first * math.pow(ratio, k)), first + k)
        if value > clock.step:
            return float(value)
    return float(last)


def stride(a: float, b: float, c: float, clock: Clock) -> float:
    """Steps a, a+c, ... up to b."""
    first, last, every = _whole(a), _whole(b), _whole(c)
    require(first >= 0 and every > 0 and first <= last)
    if clock.step < first:
        return float(first)
    following = clock.step + every - (clock.step - first) % every
    return float(following) if clock.step < last and following <= last else _NEVER


def stride2(a: float, b: float, c: float, d: float, e: float, f: float, clock: Clock) -> float:
    """Steps a, a+c, ... up to b; but from d to e every f."""
    first, last, every, fine_first, fine_last, fine = (_whole(q) for q in (a, b, c, d, e, f))
    require(first >= 0 and every > 0 and first <= last)
    require(fine > 0 and first <= fine_first <= fine_last <= last)
    step = clock.step
    if step < first:
        return float(first)
    if step >= last:
        return _NEVER
    if step < fine_first:
        return float(min(step + every - (step - first) % every, fine_first))
    if step < fine_last:
        following = step + fine - (step - fine_first) % fine
        if following > fine_last:
            following = fine_last + every - (fine_last - first) % every
        return float(following) if following <= last else _NEVER
    return float(step + every - (step - first) % every)
