"""The compiler's side: the words that read and write arrays. Imported by ``alphabet.py`` alone."""

# mypy: allow-untyped-defs, allow-untyped-calls, disable-error-code="no-untyped-call,attr-defined,misc,operator,call-arg,arg-type,index"

from __future__ import annotations

import llvmlite.binding as llvm
from llvmlite import ir
from numba.core import types

from pylmp.kernels import simd
from pylmp.kernels.simd.vector import ELEMENTS, Vector, constant, native
from pylmp.kernels.simd.word import BYTES, INDEX, LETTERS, LONG, call_of, kind_of, ones, place, vector_of, word


def _vector_at(builder, array, at, kind):
    return builder.bitcast(builder.gep(array, [at]), native(kind).as_pointer())


@word(simd.load, lambda array, at, lanes: vector_of(kind_of(array), lanes), types.CPointer, types.Integer, types.Integer)
def _load(builder, sig, values):
    kind = sig.return_type
    result = builder.load(_vector_at(builder, values[0], values[1], kind))
    result.align = BYTES[kind.kind]
    return result


@word(simd.store, lambda array, at, vector: types.none if vector.kind == kind_of(array) else None, types.CPointer, types.Integer, Vector)
def _store(builder, sig, values):
    kind = sig.args[2]
    instruction = builder.store(values[2], _vector_at(builder, values[0], values[1], kind))
    instruction.align = BYTES[kind.kind]


def _addresses(builder, array, index, offset, kind):
    """A vector of addresses. The offset goes into the base, where it costs nothing."""
    element = ELEMENTS[kind.kind]
    base = builder.gep(array, [offset])
    places = builder.gep(base, [index], source_etype=element)
    places.type = ir.VectorType(base.type, kind.lanes)
    return places


@word(
    simd.gather, lambda array, index, offset: Vector(kind_of(array), index.lanes) if isinstance(index, Vector) else None,
    types.CPointer, Vector, types.Integer,
)  # fmt: skip
def _gather(builder, sig, values):
    kind = sig.return_type
    places = _addresses(builder, *values, kind)
    mask, result = native(kind.mask), native(kind)
    name = f"llvm.masked.gather.v{kind.lanes}{LETTERS[kind.kind]}.v{kind.lanes}p0"
    function = call_of(builder, name, result, places.type, INDEX, mask, result)
    align = ir.Constant(INDEX, BYTES[kind.kind])
    return builder.call(function, [places, align, constant(kind.mask, 1), ir.Constant(result, ir.Undefined)])


def _turn(builder, a, b, lanes):
    return builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(INDEX, len(lanes)), lanes))


@word(
    simd.gather_rows, lambda array, index: types.UniTuple(Vector("f8", 8), 3) if index == Vector("i4", 8) else None,
    types.CPointer, Vector,
)  # fmt: skip
def _gather_rows(builder, sig, values):
    """Eight rows x y z and one more number, two by two in one register, then turned."""
    array, index = values
    four = ir.VectorType(ELEMENTS["f8"], 4)
    rows = []
    for k in range(8):
        start = builder.sext(builder.extract_element(index, place(k)), LONG)
        row = builder.load(builder.bitcast(builder.gep(array, [start]), four.as_pointer()))
        row.align = 8
        rows.append(row)
    a, b, c, d = (_turn(builder, rows[k], rows[k + 4], list(range(8))) for k in range(4))
    low, high = [0, 8, 2, 10, 4, 12, 6, 14], [1, 9, 3, 11, 5, 13, 7, 15]
    x_z, x_z_more = _turn(builder, a, b, low), _turn(builder, c, d, low)
    y, y_more = _turn(builder, a, b, high), _turn(builder, c, d, high)
    first, last = [0, 1, 8, 9, 4, 5, 12, 13], [2, 3, 10, 11, 6, 7, 14, 15]
    turned = (_turn(builder, x_z, x_z_more, first), _turn(builder, y, y_more, first), _turn(builder, x_z, x_z_more, last))
    result = ir.Constant(ir.ArrayType(native(sig.return_type.dtype), 3), ir.Undefined)
    for k, vector in enumerate(turned):
        result = builder.insert_value(result, vector, k)
    return result


@word(
    simd.scatter, lambda array, index, offset, vector: types.none if isinstance(vector, Vector) else None,
    types.CPointer, Vector, types.Integer, Vector,
)  # fmt: skip
def _scatter(builder, sig, values):
    array, index, offset, vector = values
    kind = sig.args[3]
    places = _addresses(builder, array, index, offset, kind)
    name = f"llvm.masked.scatter.v{kind.lanes}{LETTERS[kind.kind]}.v{kind.lanes}p0"
    function = call_of(builder, name, ir.VoidType(), vector.type, places.type, INDEX, native(kind.mask))
    builder.call(function, [vector, places, ir.Constant(INDEX, BYTES[kind.kind]), constant(kind.mask, 1)])


@word(
    simd.compress, lambda array, at, vector, mask: types.int64 if isinstance(mask, Vector) else None,
    types.CPointer, types.Integer, Vector, Vector,
)  # fmt: skip
def _compress(builder, sig, values):
    array, at, vector, mask = values
    kind = sig.args[2]
    if kind.lanes * BYTES[kind.kind] == 64 and llvm.get_host_cpu_features().get("avx512f"):
        name = f"llvm.x86.avx512.mask.compress.v{kind.lanes}{LETTERS[kind.kind]}"
        result = native(kind)
        function = call_of(builder, name, result, result, result, native(kind.mask))
        chosen = builder.call(function, [vector, ir.Constant(result, ir.Undefined), mask])
        instruction = builder.store(chosen, _vector_at(builder, array, at, kind))
        instruction.align = BYTES[kind.kind]
        return ones(builder, mask, kind.lanes)
    # Each lane is stored, and the place moves on only behind the chosen ones: no branch to mispredict.
    end = at
    for lane in range(kind.lanes):
        builder.store(builder.extract_element(vector, place(lane)), builder.gep(array, [end]))
        end = builder.add(end, builder.zext(builder.extract_element(mask, place(lane)), LONG))
    return builder.sub(end, at)


