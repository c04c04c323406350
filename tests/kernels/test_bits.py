"""Compiled kernels give the bits of plain Python: no contraction, no reordering, IEEE division."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from pylmp.kernels.store import kernel
from tests.kernels.scenes import chain, line, multiply_add, soft, spring, word


@pytest.fixture(autouse=True)
def own_store(tmp_path, monkeypatch):
    monkeypatch.setenv("PYLMP_CACHE", str(tmp_path / "store"))


def test_no_fused_multiply_add_and_no_reordered_sum() -> None:
    a, b, c = np.random.default_rng(1).standard_normal((3, 4001))
    c *= 1e-3
    function = multiply_add()
    plain, compiled = np.empty_like(a), np.empty_like(a)
    total = function(a, b, c, plain, len(a))
    assert kernel(function).bind(a, b, c, compiled, len(a))() == total
    assert compiled.tobytes() == plain.tobytes()
    fused = [float(Fraction(p) * Fraction(q) + Fraction(r)) for p, q, r in zip(a, b, c, strict=True)]
    assert sum(fused != plain) > 100, "the numbers could not tell a fused from an unfused product"
    assert float(np.sum(a * b)) != total, "nor a reordered sum from an ordered one"


@pytest.mark.parametrize("doubled", [False, True])
def test_composed_laws_run_as_plain_python_and_compiled(doubled: bool) -> None:
    function = chain(spring, soft, doubled=doubled)
    ours, theirs = line(), line()
    assert kernel(function).bind(*ours)() == function(*theirs)
    assert ours[1].tobytes() == theirs[1].tobytes()
    assert np.any(ours[1] != 0.0)


@pytest.mark.parametrize("name", ["root", "magnitude", "floor", "bounds", "grow", "turn", "raised", "index", "narrow", "pattern"])
def test_alphabet(name: str) -> None:
    x = np.concatenate([np.random.default_rng(2).random(500) * 10.0, [0.0, 0.25, 0.5, 5e-324, 1e300, 3.0]])
    if name != "root":
        x = np.concatenate([x, -x])
    x = x[np.abs(x) < 1e15] if name == "floor" else x
    plain, compiled = np.empty_like(x), np.empty_like(x)
    word(name)(x, plain, len(x))
    kernel(word(name)).bind(x, compiled, len(x))()
    np.testing.assert_array_equal(compiled, plain)
    if name not in ("grow", "raised"):  # the sign of nan is nobody's
        assert compiled.tobytes() == plain.tobytes()


@pytest.mark.parametrize("name", ["grow", "turn", "raised"])
def test_functions_of_the_c_library(name: str) -> None:
    """Compiled they are those of Python's math, whose doubles LAMMPS has, over the whole range and at its ends."""
    random = np.random.default_rng(4)
    x = np.concatenate([random.uniform(-30.0, 30.0, 3000), np.exp(random.uniform(-700.0, 700.0, 500)), [710.0, -np.inf, np.nan]])
    plain, compiled = np.empty_like(x), np.empty_like(x)
    word(name)(x, plain, len(x)) if name != "turn" else word(name)(x[:-2], plain[:-2], len(x) - 2)
    kernel(word(name)).bind(x, compiled, len(x))()
    np.testing.assert_array_equal(compiled[:-2], plain[:-2])


def test_division_by_zero_is_infinite_as_in_c() -> None:
    x = np.array([0.0, -0.0, np.inf, np.nan, 5e-324, -2.0])
    out = np.empty_like(x)
    kernel(word("divide")).bind(x, out, len(x))()
    with np.errstate(divide="ignore", over="ignore"):
        np.testing.assert_array_equal(out, 1.0 / x)
    assert np.signbit(out[1])
    assert not np.signbit(out[0])
