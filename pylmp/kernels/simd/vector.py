"""The compiler's side: the type of a vector, and its operators. Imported by ``alphabet.py`` alone."""

# mypy: allow-untyped-defs, allow-untyped-calls, disable-error-code="no-untyped-call,attr-defined,misc,operator,call-arg,arg-type,index"

from __future__ import annotations

import operator

from llvmlite import ir
from numba.core import types
from numba.core.typing.templates import AbstractTemplate, infer_global, signature
from numba.extending import lower_builtin, models, register_model

ELEMENTS = {
    "f8": ir.DoubleType(), "f4": ir.FloatType(), "i8": ir.IntType(64), "i4": ir.IntType(32), "u1": ir.IntType(8), "mask": ir.IntType(1),
}  # fmt: skip
SCALARS = {
    "f8": types.float64, "f4": types.float32, "i8": types.int64, "i4": types.int32, "u1": types.uint8, "mask": types.boolean,
}  # fmt: skip
KINDS = {scalar: kind for kind, scalar in SCALARS.items()}
FLOATS = ("f8", "f4")


class Vector(types.Type):
    """kind: of its elements, a key of ELEMENTS; lanes: how many."""

    def __init__(self, kind, lanes):
        self.kind, self.lanes = kind, lanes
        super().__init__(name=f"Vector({kind} x {lanes})")

    @property
    def key(self):
        return self.kind, self.lanes

    @property
    def mask(self):
        return Vector("mask", self.lanes)


def native(vector):
    """The LLVM type of a vector."""
    return ir.VectorType(ELEMENTS[vector.kind], vector.lanes)


@register_model(Vector)
class _Model(models.PrimitiveModel):
    def __init__(self, manager, vector):
        super().__init__(manager, vector, native(vector))


def spread(builder, value, vector):
    """A number in all lanes."""
    kind = native(vector)
    nothing = ir.Constant(kind, ir.Undefined)
    first = builder.insert_element(nothing, value, ir.Constant(ir.IntType(32), 0))
    zeros = ir.Constant(ir.VectorType(ir.IntType(32), vector.lanes), [0] * vector.lanes)
    return builder.shuffle_vector(first, nothing, zeros)


def constant(vector, value):
    """The same constant in all lanes."""
    return ir.Constant(native(vector), [value] * vector.lanes)


def matched(x, y):
    """The vector that both operands become, and the scalar type a number is cast to first; None if they do not go together."""
    if isinstance(x, Vector) and x == y:
        return x
    vector, other = (x, y) if isinstance(x, Vector) else (y, x)
    if not isinstance(vector, Vector) or vector.kind == "mask":
        return None
    fits = (types.Float, types.Integer) if vector.kind in FLOATS else types.Integer
    return vector if isinstance(other, fits) else None


def cast(vector, operand):
    """The type an operand has in the signature."""
    return operand if isinstance(operand, Vector) else SCALARS[vector.kind]


def lanes_of(builder, vector, given, value):
    return value if isinstance(given, Vector) else spread(builder, value, vector)


_PAIRS = ((Vector, Vector), (Vector, types.Number), (types.Number, Vector))


def _arithmetic(operation, on_floats, on_integers):
    @infer_global(operation)
    class _Typing(AbstractTemplate):
        def generic(self, arguments, keywords):
            if len(arguments) != 2 or (vector := matched(*arguments)) is None:
                return None
            if on_floats if vector.kind in FLOATS else on_integers:
                return signature(vector, *(cast(vector, operand) for operand in arguments))
            return None

    def emit(context, builder, sig, values):
        vector = sig.return_type
        a, b = (lanes_of(builder, vector, given, value) for given, value in zip(sig.args, values, strict=True))
        return getattr(builder, on_floats if vector.kind in FLOATS else on_integers)(a, b)

    for pair in _PAIRS:
        lower_builtin(operation, *pair)(emit)


for _operation, _on_floats, _on_integers in (
    (operator.add, "fadd", "add"), (operator.sub, "fsub", "sub"), (operator.mul, "fmul", "mul"), (operator.truediv, "fdiv", None),
    (operator.iadd, "fadd", "add"), (operator.isub, "fsub", "sub"), (operator.imul, "fmul", "mul"), (operator.itruediv, "fdiv", None),
):  # fmt: skip
    _arithmetic(_operation, _on_floats, _on_integers)


def _logic(operation, instruction):
    @infer_global(operation)
    class _Typing(AbstractTemplate):
        def generic(self, arguments, keywords):
            x, y = arguments
            whole = isinstance(x, Vector) and x.kind not in FLOATS
            return signature(x, x, y) if whole and x == y else None

    @lower_builtin(operation, Vector, Vector)
    def emit(context, builder, sig, values):
        return getattr(builder, instruction)(*values)


_logic(operator.and_, "and_")
_logic(operator.or_, "or_")


def _comparison(operation, sign):
    @infer_global(operation)
    class _Typing(AbstractTemplate):
        def generic(self, arguments, keywords):
            if len(arguments) != 2 or (vector := matched(*arguments)) is None:
                return None
            return signature(vector.mask, *(cast(vector, operand) for operand in arguments))

    def emit(context, builder, sig, values):
        vector = next(given for given in sig.args if isinstance(given, Vector))
        a, b = (lanes_of(builder, vector, given, value) for given, value in zip(sig.args, values, strict=True))
        if vector.kind not in FLOATS:
            return builder.icmp_signed(sign, a, b)
        return (builder.fcmp_unordered if sign == "!=" else builder.fcmp_ordered)(sign, a, b)  # nan is unequal to all

    for pair in _PAIRS:
        lower_builtin(operation, *pair)(emit)


for _operation, _sign in (
    (operator.lt, "<"), (operator.le, "<="), (operator.gt, ">"), (operator.ge, ">="), (operator.eq, "=="), (operator.ne, "!="),
):  # fmt: skip
    _comparison(_operation, _sign)


@infer_global(operator.neg)
class _Negation(AbstractTemplate):
    def generic(self, arguments, keywords):
        (x,) = arguments
        return signature(x, x) if isinstance(x, Vector) and x.kind != "mask" else None


@lower_builtin(operator.neg, Vector)
def _negate(context, builder, sig, values):
    return builder.fneg(*values) if sig.args[0].kind in FLOATS else builder.neg(*values)


@infer_global(operator.invert)
class _Inversion(AbstractTemplate):
    def generic(self, arguments, keywords):
        (x,) = arguments
        return signature(x, x) if isinstance(x, Vector) and x.kind == "mask" else None


@lower_builtin(operator.invert, Vector)
def _invert(context, builder, sig, values):
    return builder.not_(*values)
