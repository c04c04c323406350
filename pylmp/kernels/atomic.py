"""The compiler's side of ``sharing.py``. Imported by ``alphabet.py`` alone."""

# mypy: allow-untyped-defs, allow-untyped-calls, disable-error-code="no-untyped-call,attr-defined,misc,operator,call-arg,arg-type,index"

from __future__ import annotations

from llvmlite import ir
from numba.core import types

from pylmp.kernels import sharing
from pylmp.kernels.simd.word import BYTES, INDEX, word

_SIZE = BYTES["i8"]


def _int(array, *numbers):
    return types.int64 if array == types.CPointer(types.int64) else None


def _nothing(array, *numbers):
    return types.none if array == types.CPointer(types.int64) else None


@word(sharing.look, _int, types.CPointer, types.Integer)
def _look(builder, sig, values):
    return builder.load_atomic(builder.gep(values[0], [values[1]]), "acquire", _SIZE)


@word(sharing.post, _nothing, types.CPointer, types.Integer, types.Integer)
def _post(builder, sig, values):
    builder.store_atomic(values[2], builder.gep(values[0], [values[1]]), "release", _SIZE)


@word(sharing.add_to, _nothing, types.CPointer, types.Integer, types.Integer)
def _add_to(builder, sig, values):
    builder.atomic_rmw("add", builder.gep(values[0], [values[1]]), values[2], "acq_rel")


@word(
    sharing.swap_if, lambda array, *numbers: types.boolean if array == types.CPointer(types.int64) else None,
    types.CPointer, types.Integer, types.Integer, types.Integer,
)  # fmt: skip
def _swap_if(builder, sig, values):
    both = builder.cmpxchg(builder.gep(values[0], [values[1]]), values[2], values[3], "acq_rel", "acquire")
    return builder.extract_value(both, 1)


@word(sharing.give_way, lambda address: types.none, types.Integer)
def _give_way(builder, sig, values):
    builder.call(builder.inttoptr(values[0], ir.FunctionType(INDEX, ()).as_pointer()), [])
