"""Functions and operators of formulas, with C's results and LAMMPS's sentences.

Source: LAMMPS manual, variable.html; values as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pylmp.text.formula import Clock


class FormulaError(Exception):
    """A formula is wrong; the caller adds whose it is and where it stands."""


def compare(sign: str, a: float, b: float) -> float:
    """Comparison and logic: 1.0 or 0.0."""
    p, q = a != 0.0, b != 0.0
    truth = {
        "==": a == b, "!=": a != b, "<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b,
        "&&": p and q, "||": p or q, "|^": p != q,
    }  # fmt: skip
    return float(truth[sign])


def power(a: float, b: float) -> float:
    if a == 0.0 and b < 0.0:
        raise FormulaError("Invalid power expression in variable formula")
    return _c(math.pow, a, b)


def _c(function: Callable[..., float], *values: float) -> float:
    """What the C library returns where Python raises. Its nan of an invalid operation carries a sign, which is printed."""
    try:
        return float(function(*values))
    except OverflowError:
        return math.inf
    except ValueError:
        return -math.nan


def _plain(function: Callable[..., float]) -> Callable[..., float]:
    return lambda *values: _c(function, *values)


def _sqrt(x: float) -> float:
    if x < 0.0:
        raise FormulaError("Sqrt of negative value in variable formula")
    return math.sqrt(x)


def _logarithm(function: Callable[[float], float]) -> Callable[[float], float]:
    def logarithm(x: float) -> float:
        if x <= 0.0:
            raise FormulaError("Log of zero/negative value in variable formula")
        return function(x)

    return logarithm


def _arc(function: Callable[[float], float], name: str) -> Callable[[float], float]:
    def arc(x: float) -> float:
        if x < -1.0 or x > 1.0:
            raise FormulaError(f"{name} of invalid value in variable formula")
        return function(x)

    return arc


def _whole(function: Callable[[float], int]) -> Callable[[float], float]:
    return lambda x: float(function(x)) if math.isfinite(x) else x


def _round(x: float) -> float:
    """Halves go up: 2.5 to 3, -2.5 to -2."""
    if not math.isfinite(x):
        return x
    return float(math.ceil(x) if x - math.floor(x) >= 0.5 else math.floor(x))


_NEVER = float(2**63 - 1024)  # a step that does not come


def _require(holds: bool) -> None:
    if not holds:
        raise FormulaError("Invalid math function in variable formula")


def _part(clock: Clock) -> float:
    """How far the run has gone, 0 to 1."""
    steps = clock.end - clock.begin
    return (clock.step - clock.begin) / steps if steps else 0.0


def _ramp(a: float, b: float, clock: Clock) -> float:
    return a + _part(clock) * (b - a)


def _stagger(a: float, b: float, clock: Clock) -> float:
    """Steps 0, b, a, a+b, 2a, ... in turn."""
    every, offset = int(a), int(b)
    _require(every > 0 and offset > 0 and every > offset)
    low = clock.step - clock.step % every
    return float(low + offset if clock.step - low < offset else low + every)


def _logfreq(a: float, b: float, c: float, clock: Clock) -> float:
    """Steps a 2a ... ba, then times c, and so on."""
    first, many, factor = int(a), int(b), int(c)
    _require(first > 0 and many > 0 and factor > 0 and many < factor)
    if clock.step < first:
        return float(first)
    low = first
    while clock.step >= factor * low:
        low *= factor
    multiple = clock.step // low
    return float((multiple + 1) * low if multiple < many else factor * low)


def _stride(a: float, b: float, c: float, clock: Clock) -> float:
    """Steps a, a+c, ... up to b."""
    first, last, every = int(a), int(b), int(c)
    _require(first >= 0 and last > 0 and every > 0 and first <= last)
    if clock.step < first:
        return float(first)
    if clock.step < last:
        following = clock.step + every - (clock.step - first) % every
        return float(following) if following <= last else _NEVER
    return _NEVER


def _time(clock: Clock) -> float:
    return (clock.step - clock.begin) * clock.dt


def _vdisplace(a: float, b: float, clock: Clock) -> float:
    return a + b * _time(clock)


def _swiggle(a: float, b: float, c: float, clock: Clock) -> float:
    _require(c != 0.0)
    return a + b * math.sin(2.0 * math.pi * _time(clock) / c)


def _cwiggle(a: float, b: float, c: float, clock: Clock) -> float:
    _require(c != 0.0)
    return a + b * (1.0 - math.cos(2.0 * math.pi * _time(clock) / c))


# Name: number of arguments, function, whether it also gets the clock.
FUNCTIONS: dict[str, tuple[int, Callable[..., Any], bool]] = {
    "sqrt": (1, _sqrt, False), "exp": (1, _plain(math.exp), False), "ln": (1, _logarithm(math.log), False),
    "log": (1, _logarithm(math.log10), False), "abs": (1, abs, False), "sign": (1, lambda x: 1.0 if x >= 0.0 else -1.0, False),
    "sin": (1, _plain(math.sin), False), "cos": (1, _plain(math.cos), False), "tan": (1, _plain(math.tan), False),
    "asin": (1, _arc(math.asin, "Arcsin"), False), "acos": (1, _arc(math.acos, "Arccos"), False),
    "atan": (1, math.atan, False), "atan2": (2, math.atan2, False),
    "ceil": (1, _whole(math.ceil), False), "floor": (1, _whole(math.floor), False), "round": (1, _round, False),
    "ternary": (3, lambda c, a, b: a if c != 0.0 else b, False),  # its number of arguments; else see formula.py
    "ramp": (2, _ramp, True), "stagger": (2, _stagger, True), "logfreq": (3, _logfreq, True), "stride": (3, _stride, True),
    "vdisplace": (2, _vdisplace, True), "swiggle": (3, _swiggle, True), "cwiggle": (3, _cwiggle, True),
}  # fmt: skip
