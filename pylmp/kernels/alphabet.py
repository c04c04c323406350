"""What the compiler knows of the laws' alphabet. Only ``compile.py`` imports this file.

Overloads carry no annotations: numba compares their signature with the implementation's.
"""

# mypy: allow-untyped-defs, allow-untyped-calls, disable-error-code="no-untyped-call"

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic, overload

from pylmp import laws

WORDS: frozenset[Callable[..., Any]] = frozenset(
    {laws.select, laws.sqrt, laws.fabs, laws.exp, laws.log, laws.sin, laws.cos, laws.power, laws.whole}
)


@intrinsic
def _root_instruction(typing_context, x):
    """The processor's square root: correctly rounded, and no call into the C library for negative numbers."""

    def generate(context, builder, signature, arguments):
        double = ir.DoubleType()
        root = builder.module.declare_intrinsic("llvm.sqrt", [double], ir.FunctionType(double, [double]))
        return builder.call(root, arguments)

    return types.float64(types.float64), generate


@overload(laws.select)
def _select(mask, a, b):
    return lambda mask, a, b: a if mask else b


@overload(laws.sqrt)
def _sqrt(x):
    return lambda x: _root_instruction(float(x))


@overload(laws.fabs)
def _fabs(x):
    return lambda x: math.fabs(x)


@overload(laws.exp)
def _exp(x):
    return lambda x: math.exp(float(x))


@overload(laws.log)
def _log(x):
    return lambda x: math.log(float(x))


@overload(laws.sin)
def _sin(x):
    return lambda x: math.sin(float(x))


@overload(laws.cos)
def _cos(x):
    return lambda x: math.cos(float(x))


@overload(laws.power)
def _power(x, y):
    return lambda x, y: math.pow(float(x), float(y))


@overload(laws.whole)
def _whole(x):
    return lambda x: int(x) if math.fabs(x) < 4611686018427387904.0 else 0
