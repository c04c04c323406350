"""SIMD words: what the compiler makes of them has the bits of their plain Python meaning, with AVX-512 and without."""

from __future__ import annotations

import ctypes
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

from pylmp.kernels.compile import compile_object
from pylmp.kernels.simd import (
    LANES,
    WIDE,
    compress,
    count,
    count_up,
    double,
    gather,
    gather_rows,
    largest,
    load,
    scatter,
    single,
    some,
    splat,
    splat_single,
    splat_whole,
    store,
    total,
)  # fmt: skip
from pylmp.kernels.store import Kernel, kernel
from pylmp.laws import fabs, select, sqrt

ROWS = 40


def arithmetic(x: "f8*", y: "f8*", out: "f8*") -> "f8":
    a = load(x, 0, LANES)
    b = load(y, 3, LANES)
    store(out, 0, a + b)
    store(out, 8, a - b * 2.0)
    store(out, 16, 1.0 / a - -b)
    store(out, 24, select(a < b, a, b))
    store(out, 32, select((a >= b) & ~(a == b) | (a != a), 7.0, b))
    store(out, 40, sqrt(fabs(a)) * select(b > 0.0, 1.0, -1.0))
    store(out, 48, splat(2.5, LANES) + 1 * a)
    store(out, 56, double(single(a * b)))
    return total(a * b) + largest(b)


def memory(x: "f8*", index: "i4*", wide: "i8*", singles: "f4*", whole: "i4*", out: "f8*") -> "f8":
    j = load(index, 0, LANES) * splat_whole(3, LANES)
    store(out, 0, gather(x, j, 2))
    a, b, c = gather_rows(x, j)
    store(out, 8, a)
    store(out, 16, b)
    store(out, 24, c)
    scatter(out, count_up(32, LANES), 0, double(load(index, 0, LANES)))
    store(wide, 0, gather(wide, load(index, 0, LANES), 0) + 5)
    v = load(singles, 1, WIDE)
    taken = v * v - splat_single(0.25, WIDE) < 0.0
    n = compress(whole, 0, count_up(100, WIDE), taken & (count_up(0, WIDE) != 3))
    m = compress(whole, 20, load(index, 0, LANES), load(index, 0, LANES) > 4)
    if some(taken):
        n += 100
    return float(1000 * count(taken) + n + 10000 * m)


def arguments() -> dict[str, list]:
    dice = np.random.default_rng(5)
    x, y = dice.normal(size=3 * ROWS + 8), dice.normal(size=32)
    x[3] = y[6]
    index = dice.permutation(np.arange(ROWS, dtype=np.int32))
    parts = {
        "arithmetic": [x, y, np.zeros(64)],
        "memory": [x, index, np.arange(ROWS) * 7, dice.uniform(-1, 1, 32).astype(np.float32), np.zeros(64, np.int32), np.zeros(64)],
    }  # fmt: skip
    return parts


@pytest.mark.parametrize("function", [arithmetic, memory])
def test_bits(function) -> None:
    compiled, plain = arguments()[function.__name__], arguments()[function.__name__]
    assert kernel(function).bind(*compiled)() == function(*plain)
    _same(compiled, plain)


@pytest.mark.parametrize("function", [arithmetic, memory])
def test_bits_without_avx512(function) -> None:
    """The code of a processor with AVX2 alone, in a process of its own; on one without AVX2 there is nothing to see."""
    with ProcessPoolExecutor(1, get_context("spawn")) as child:
        found = child.submit(on_older_processor, function.__name__).result()
    if found is None:
        pytest.skip("no AVX2 here")
    plain = arguments()[function.__name__]
    assert found[0] == function(*plain)
    _same(found[1], plain)


def on_older_processor(name: str) -> tuple[float, list] | None:
    import llvmlite.binding as llvm

    features = llvm.get_host_cpu_features()
    if not features.get("avx2"):
        return None
    newer = ("avx512", "evex512", "avx10", "amx")
    older = type(features)({feature: on and not feature.startswith(newer) for feature, on in features.items()})
    llvm.get_host_cpu_features, llvm.get_host_cpu_name = (lambda: older), (lambda: "haswell")
    function = {"arithmetic": arithmetic, "memory": memory}[name]
    compiled = arguments()[name]
    return Kernel(function, compile_object(function)).bind(*compiled)(), compiled


def _same(compiled: list, plain: list) -> None:
    """Equal bits, except behind what compress chose, where anything may stand."""
    for one, other in zip(compiled, plain, strict=True):
        if one.dtype == np.int32 and len(one) == 64:
            chosen = other != 0
            assert (one[chosen] == other[chosen]).all()
        else:
            assert one.tobytes() == other.tobytes()


def test_a_mask_of_two_truths() -> None:
    def alive(x: "f8*", out: "f8*") -> "f8":
        a = load(x, 0, LANES)
        holds = select(a > 0.0, False, True)
        store(out, 0, select(holds, a, 0.0))
        return float(count(holds))

    x, out = np.array([1.0, -1.0, 0.0, 2.0, -3.0, np.nan, np.inf, -np.inf]), np.zeros(8)
    assert kernel(alive).bind(x, out)() == 5.0
    assert out.tolist()[:5] == [0.0, -1.0, 0.0, 0.0, -3.0]
    assert np.isnan(out[5]) and out[7] == -np.inf


def test_nothing_is_stored_outside() -> None:
    """A store writes its lanes and nothing else."""

    def fill(out: "f8*", at: "i8") -> "f8":
        store(out, at, splat(1.0, LANES))
        return 0.0

    out = np.zeros(24)
    kernel(fill).bind(out, 8)()
    assert out.tolist() == [0.0] * 8 + [1.0] * 8 + [0.0] * 8
    assert ctypes.sizeof(ctypes.c_double) * LANES == 64
