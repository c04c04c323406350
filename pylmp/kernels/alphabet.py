"""What the compiler knows of the laws' alphabet, for numbers and for vectors. Only ``compile.py`` imports this file.

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
from pylmp.kernels import atomic as atomic  # teaches the words of sharing.py
from pylmp.kernels import machine, sharing, simd
from pylmp.kernels.simd import memory as memory  # teaches its words
from pylmp.kernels.simd.emit import choose, lane, magnitude, root, with_lane
from pylmp.kernels.simd.vector import Vector
from pylmp.kernels.simd.word import INDEX, LONG

WORDS: frozenset[Callable[..., Any]] = simd.WORDS | machine.WORDS | sharing.WORDS | {
    laws.select, laws.sqrt, laws.fabs, laws.exp, laws.log, laws.sin, laws.cos, laws.power, laws.whole,
    laws.single, laws.bits,
}  # fmt: skip


@intrinsic
def _root_instruction(typing_context, x):
    """The processor's square root: correctly rounded, and no call into the C library for negative numbers."""

    def generate(context, builder, signature, arguments):
        double = ir.DoubleType()
        root = builder.module.declare_intrinsic("llvm.sqrt", [double], ir.FunctionType(double, [double]))
        return builder.call(root, arguments)

    return types.float64(types.float64), generate


@intrinsic
def _float_bits(typing_context, x):
    """The bits of x as a single precision number."""

    def generate(context, builder, signature, arguments):
        word = builder.bitcast(builder.fptrunc(arguments[0], ir.FloatType()), ir.IntType(32))
        return builder.sext(word, ir.IntType(64))

    return types.int64(types.float64), generate


@overload(laws.select)
def _select(mask, a, b):
    if isinstance(mask, Vector):
        return lambda mask, a, b: choose(mask, a, b)
    return lambda mask, a, b: a if mask else b


@overload(laws.sqrt)
def _sqrt(x):
    if isinstance(x, Vector):
        return lambda x: root(x)
    return lambda x: _root_instruction(float(x))


@overload(laws.fabs)
def _fabs(x):
    if isinstance(x, Vector):
        return lambda x: magnitude(x)
    return lambda x: math.fabs(x)


def _of_c(word, function):
    """A function of the C library: of a number, or of each lane in turn."""

    @overload(word)
    def chosen(x):
        if not isinstance(x, Vector):
            return lambda x: function(float(x))
        lanes = x.lanes

        def each(x):
            result = x
            for k in range(lanes):
                result = with_lane(result, k, function(lane(x, k)))
            return result

        return each


for _word, _function in ((laws.exp, math.exp), (laws.log, math.log), (laws.sin, math.sin), (laws.cos, math.cos)):
    _of_c(_word, _function)


@overload(laws.power)
def _power(x, y):
    if not isinstance(x, Vector):
        return lambda x, y: math.pow(float(x), float(y))
    lanes = x.lanes

    def each(x, y):
        result = x
        for k in range(lanes):
            result = with_lane(result, k, math.pow(lane(x, k), float(y)))
        return result

    def both(x, y):
        result = x
        for k in range(lanes):
            result = with_lane(result, k, math.pow(lane(x, k), lane(y, k)))
        return result

    return both if isinstance(y, Vector) else each


@overload(laws.whole)
def _whole(x):
    return lambda x: int(x) if math.fabs(x) < 4611686018427387904.0 else 0


@overload(laws.single)
def _single(x):
    return lambda x: float(types.float32(x))


@overload(laws.bits)
def _bits(x):
    return lambda x: _float_bits(float(x))


def _at(builder, address, result, *kinds):
    """The machine code at address as a function."""
    return builder.inttoptr(address, ir.FunctionType(result, kinds).as_pointer())


@intrinsic
def _call_kernel(typing_context, address, block):
    def generate(context, builder, signature, arguments):
        where, block = arguments
        return builder.call(_at(builder, where, ir.DoubleType(), LONG), [block])

    return types.float64(types.int64, types.int64), generate


@intrinsic
def _call_clock(typing_context, address, clock, room):
    def generate(context, builder, signature, arguments):
        where, clock, room = arguments
        number = builder.trunc(clock, INDEX)
        return builder.sext(builder.call(_at(builder, where, INDEX, INDEX, room.type), [number, room]), LONG)

    return types.int64(types.int64, types.int64, room), generate


@overload(machine.invoke)
def _invoke(address, block):
    return lambda address, block: _call_kernel(address, block)


@overload(machine.seconds)
def _seconds(address, clock, room):
    def now(address, clock, room):
        _call_clock(address, clock, room)
        return float(room[0]) + 1.0e-9 * float(room[1])

    return now
