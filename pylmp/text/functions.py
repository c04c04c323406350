"""Functions and operators of formulas, with C's results and LAMMPS's sentences.

Source: LAMMPS manual, variable.html; values as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from pylmp.text import timed
from pylmp.text.formula_error import FormulaError


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


def modulo(a: float, b: float) -> float:
    if b == 0.0:
        raise FormulaError("Modulo 0 in variable formula")
    return math.nan if math.isinf(a) else math.fmod(a, b)


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


# Name: number of arguments, function, whether it also gets the clock.
FUNCTIONS: dict[str, tuple[int, Callable[..., Any], bool]] = {
    "sqrt": (1, _sqrt, False), "exp": (1, _plain(math.exp), False), "ln": (1, _logarithm(math.log), False),
    "log": (1, _logarithm(math.log10), False), "abs": (1, abs, False), "sign": (1, lambda x: 1.0 if x >= 0.0 else -1.0, False),
    "sin": (1, _plain(math.sin), False), "cos": (1, _plain(math.cos), False), "tan": (1, _plain(math.tan), False),
    "asin": (1, _arc(math.asin, "Arcsin"), False), "acos": (1, _arc(math.acos, "Arccos"), False),
    "atan": (1, math.atan, False), "atan2": (2, math.atan2, False),
    "ceil": (1, _whole(math.ceil), False), "floor": (1, _whole(math.floor), False), "round": (1, _round, False),
    "ternary": (3, float, False),  # the number of its arguments; chosen in formula.py
    "ramp": (2, timed.ramp, True), "stagger": (2, timed.stagger, True), "logfreq": (3, timed.logfreq, True), "stride": (3, timed.stride, True),
    "vdisplace": (2, timed.vdisplace, True), "swiggle": (3, timed.swiggle, True), "cwiggle": (3, timed.cwiggle, True),
    "logfreq2": (3, timed.logfreq2, True), "logfreq3": (3, timed.logfreq3, True), "stride2": (6, timed.stride2, True),
    "random": (3, float, False), "normal": (3, float, False),  # the number of their arguments; drawn in evaluate.py
}  # fmt: skip
