"""The compiler's side: how it is taught a word. Imported by the files beside it alone."""

# mypy: allow-untyped-defs, allow-untyped-calls, disable-error-code="no-untyped-call,attr-defined,misc,operator,call-arg,arg-type,index"

from __future__ import annotations

from llvmlite import ir
from numba.core import types
from numba.core.cgutils import get_or_insert_function
from numba.core.typing.templates import AbstractTemplate, infer, infer_global, signature
from numba.extending import lower_builtin

from pylmp.kernels.simd.vector import KINDS, Vector

INDEX, LONG = ir.IntType(32), ir.IntType(64)
BYTES = {"f8": 8, "f4": 4, "i8": 8, "i4": 4, "u1": 1}
LETTERS = {"f8": "f64", "f4": "f32", "i8": "i64", "i4": "i32"}


def word(named, typing, *patterns):
    """Teach the compiler a word. typing(types of its arguments) -> type of its result, None where it does not fit. Decorates
    emit(builder, signature, values)."""

    class Typing(AbstractTemplate):
        key = named

        def generic(self, arguments, keywords):
            result = None if keywords else typing(*arguments)
            return None if result is None else signature(result, *arguments)

    infer(Typing)
    infer_global(named, types.Function(Typing))

    def taught(emit):
        @lower_builtin(named, *patterns)
        def lower(context, builder, sig, values):
            values = [_widened(builder, kind, value) for kind, value in zip(sig.args, values, strict=True)]
            result = emit(builder, sig, values)
            return context.get_dummy_value() if result is None else result

        return emit

    return taught


def _widened(builder, kind, value):
    """Places in arrays as 64-bit numbers."""
    return builder.sext(value, LONG) if isinstance(kind, types.Integer) and value.type.width < 64 else value


def kind_of(array):
    """The kind of an array's elements; None if it is none of ours."""
    return KINDS.get(array.dtype) if isinstance(array, types.CPointer) else None


def vector_of(kind, lanes):
    return Vector(kind, lanes.literal_value) if kind and isinstance(lanes, types.IntegerLiteral) else None


def place(number):
    return ir.Constant(INDEX, number)


def call_of(builder, name, result, *arguments):
    return get_or_insert_function(builder.module, ir.FunctionType(result, arguments), name)


def as_bits(builder, mask, lanes):
    return builder.bitcast(mask, ir.IntType(lanes))


def ones(builder, mask, lanes):
    return builder.zext(builder.ctpop(as_bits(builder, mask, lanes)), LONG)


