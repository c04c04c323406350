"""A function of the C library for every element of an array."""

from __future__ import annotations

from functools import cache

from pylmp import laws
from pylmp.kernels.kinds import Function

_FUNCTIONS = {"exp": laws.exp, "log": laws.log, "sin": laws.sin, "cos": laws.cos}
NAMES = (*_FUNCTIONS, "pow")


@cache
def each(name: str) -> Function:
    """out = f(x), or out = pow(x, y)."""
    if name == "pow":
        return _power
    function = _FUNCTIONS[name]

    def mapped(x: "f8*", out: "f8*", n: "i8") -> "f8":
        for i in range(n):
            out[i] = function(x[i])
        return 0.0

    return mapped


def _power(x: "f8*", y: "f8*", out: "f8*", n: "i8") -> "f8":
    for i in range(n):
        out[i] = laws.power(x[i], y[i])
    return 0.0
