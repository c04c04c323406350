"""The compiler's side: words and laws' functions that work in registers alone. Imported by ``alphabet.py`` alone."""

# mypy: allow-untyped-defs, allow-untyped-calls, disable-error-code="no-untyped-call,attr-defined,misc,operator,call-arg,arg-type,index"

from __future__ import annotations

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic

from pylmp.kernels import simd
from pylmp.kernels.simd.vector import ELEMENTS, KINDS, SCALARS, Vector, native, spread
from pylmp.kernels.simd.word import INDEX, LETTERS, as_bits, call_of, ones, place, vector_of, word

# ---- vectors from numbers, and from each other ------------------------------------------------------------------


def _splat(named, kind):
    @word(named, lambda value, lanes: vector_of(kind, lanes), types.Number, types.Integer)
    def emit(builder, sig, values):
        value, given, vector = values[0], sig.args[0], sig.return_type
        if kind == "i4":
            value = builder.trunc(value, ELEMENTS[kind])
        elif isinstance(given, types.Integer):
            value = builder.sitofp(value, ELEMENTS[kind])
        elif KINDS[given] != kind:
            value = (builder.fptrunc if kind == "f4" else builder.fpext)(value, ELEMENTS[kind])
        return spread(builder, value, vector)


for _name, _element in ((simd.splat, "f8"), (simd.splat_single, "f4"), (simd.splat_whole, "i4")):
    _splat(_name, _element)


@word(simd.count_up, lambda start, lanes: vector_of("i4", lanes), types.Integer, types.Integer)
def _count_up(builder, sig, values):
    vector = sig.return_type
    first = spread(builder, builder.trunc(values[0], INDEX), vector)
    return builder.add(first, ir.Constant(native(vector), list(range(vector.lanes))))


@word(simd.single, lambda vector: Vector("f4", vector.lanes), Vector)
def _single(builder, sig, values):
    return builder.fptrunc(values[0], native(sig.return_type))


@word(simd.double, lambda vector: Vector("f8", vector.lanes), Vector)
def _double(builder, sig, values):
    return (builder.fpext if sig.args[0].kind == "f4" else builder.sitofp)(values[0], native(sig.return_type))


# ---- numbers from vectors ---------------------------------------------------------------------------------------


@word(simd.some, lambda mask: types.boolean, Vector)
def _some(builder, sig, values):
    bits = as_bits(builder, values[0], sig.args[0].lanes)
    return builder.icmp_unsigned("!=", bits, ir.Constant(bits.type, 0))


@word(simd.count, lambda mask: types.int64, Vector)
def _count(builder, sig, values):
    return ones(builder, values[0], sig.args[0].lanes)


@word(simd.total, lambda vector: SCALARS[vector.kind], Vector)
def _total(builder, sig, values):
    result = builder.extract_element(values[0], place(0))
    for lane in range(1, sig.args[0].lanes):
        result = builder.fadd(result, builder.extract_element(values[0], place(lane)))
    return result


@word(simd.largest, lambda vector: SCALARS[vector.kind], Vector)
def _largest(builder, sig, values):
    """nan wins: it is neither less nor more."""
    result = builder.extract_element(values[0], place(0))
    for lane in range(1, sig.args[0].lanes):
        other = builder.extract_element(values[0], place(lane))
        keep = builder.fcmp_ordered(">=", result, other)
        unknown = builder.fcmp_unordered("uno", result, result)
        result = builder.select(builder.or_(keep, unknown), result, other)
    return result


# ---- the laws' alphabet, for vectors ----------------------------------------------------------------------------


@intrinsic
def choose(typing, mask, a, b):
    """a where mask holds, else b: two vectors, a vector and a number, or two truths."""
    vector = next((x for x in (a, b) if isinstance(x, Vector)), None)
    if vector is None:
        vector = mask if isinstance(types.unliteral(a), types.Boolean) else Vector("f8", mask.lanes)
    given = tuple(x if isinstance(x, Vector) else SCALARS[vector.kind] for x in (a, b))

    def emit(context, builder, sig, values):
        sides = [v if isinstance(k, Vector) else spread(builder, v, vector) for k, v in zip(given, values[1:], strict=True)]
        return builder.select(values[0], *sides)

    return vector(mask, *given), emit


def _unary(name):
    @intrinsic
    def function(typing, x):
        def emit(context, builder, sig, values):
            kind = native(x)
            return builder.call(call_of(builder, f"llvm.{name}.v{x.lanes}{LETTERS[x.kind]}", kind, kind), values)

        return x(x), emit

    return function


root, magnitude = _unary("sqrt"), _unary("fabs")


@intrinsic
def lane(typing, x, number):
    """One lane as a number."""

    def emit(context, builder, sig, values):
        return builder.extract_element(values[0], builder.trunc(values[1], INDEX))

    return SCALARS[x.kind](x, types.int64), emit


@intrinsic
def with_lane(typing, x, number, value):
    """x with one lane replaced."""

    def emit(context, builder, sig, values):
        return builder.insert_element(values[0], values[2], builder.trunc(values[1], INDEX))

    return x(x, types.int64, SCALARS[x.kind]), emit
