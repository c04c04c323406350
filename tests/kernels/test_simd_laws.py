"""A law in eight lanes has the bits it has for one number."""

from __future__ import annotations

import numpy as np
import pytest

from pylmp.kernels.fast import columns
from pylmp.kernels.simd import LANES, count_up, load, splat_whole, store
from pylmp.kernels.store import kernel, prepare
from pylmp.laws import select
from pylmp.model.registry import BONDS, PAIRS

N = 32
COEFFICIENTS = {"gromos": 2, "harmonic": 2}


def pair_kernel(law, width: int):
    take = columns(width)

    def every(r2: "f8*", dot: "f8*", c: "f8*", force: "f8*", energy: "f8*") -> "f8":
        for k in range(0, N, LANES):
            at = count_up(k, LANES) * splat_whole(width, LANES)
            f, e = law(load(r2, k, LANES), load(dot, k, LANES), 1.0, take(c, at))
            store(force, k, f)
            store(energy, k, e)
        return 0.0

    return every


def bond_kernel(law, width: int, memory: int):
    take, recall = columns(width), columns(memory)

    def every(r2: "f8*", dot: "f8*", c: "f8*", h: "f8*", force: "f8*", energy: "f8*", alive: "f8*") -> "f8":
        for k in range(0, N, LANES):
            at = count_up(k, LANES)
            x = load(r2, k, LANES)
            f, e, _, holds = law(
                x, load(dot, k, LANES), recall(h, at * splat_whole(memory, LANES)), take(c, at * splat_whole(width, LANES))
            )
            store(force, k, f + 0.0 * x)
            store(energy, k, e + 0.0 * x)
            store(alive, k, select((x == x) & holds, 1.0, 0.0) if memory else 0.0 * x)
        return 0.0

    return every


def numbers() -> tuple[np.ndarray, np.ndarray, np.random.Generator]:
    dice = np.random.default_rng(3)
    return dice.uniform(0.6, 2.6, N), dice.normal(size=N), dice


PAIR_NAMES = [name for name in PAIRS.names() if (s := PAIRS.find(name)) and s.law is not None and s.data is None]
BOND_NAMES = [name for name in BONDS.names() if (s := BONDS.find(name)) and s.read is None and s.law is not None and s.coeffs]


@pytest.mark.parametrize("name", PAIR_NAMES)
def test_pair(name: str) -> None:
    style = PAIRS.find(name)
    r2, dot, dice = numbers()
    width = len(style.row(tuple(dice.uniform(0.5, 1.5, len(style.coeffs))), 1.5, False))
    c = dice.uniform(0.5, 3.0, (N, width))
    force, energy = np.zeros(N), np.zeros(N)
    law = style.law({"cut": 1.5, "anharmonic": True})
    kernel(pair_kernel(law, width)).bind(r2, dot, c, force, energy)()
    expected = law(r2, dot, 1.0, tuple(c.T))
    assert force.tobytes() == (expected[0] + 0.0).tobytes() or (force == expected[0]).all()
    assert (energy == expected[1]).all()


@pytest.mark.parametrize("name", BOND_NAMES)
@pytest.mark.parametrize("smooth", [False, True])
def test_bond(name: str, smooth: bool) -> None:
    style = BONDS.find(name)
    if smooth and not style.history:
        pytest.skip("no keywords")
    options = {"smooth": smooth, "normalize": not smooth, "break": True, "overlay/pair": False, "volume/factor": False}
    r2, dot, dice = numbers()
    c, h = dice.uniform(0.5, 3.0, (N, len(style.coeffs))), dice.uniform(0.5, 1.5, (N, max(1, len(style.history))))
    force, energy, alive = np.zeros(N), np.zeros(N), np.zeros(N)
    law = style.law(options)
    kernel(bond_kernel(law, len(style.coeffs), len(style.history))).bind(r2, dot, c, h, force, energy, alive)()
    with np.errstate(all="ignore"):
        expected = law(r2, dot, tuple(h.T[: len(style.history)]), tuple(c.T))
    both = np.isfinite(expected[0])
    assert both.any()
    assert (force[both] == (expected[0] + 0.0 * r2)[both]).all()
    assert (energy[both] == (expected[1] + 0.0 * r2)[both]).all()
    if style.history:
        assert (alive == np.asarray(expected[3], float)).all()


def test_every_law_was_met() -> None:
    assert len(PAIR_NAMES) >= 5
    assert len(BOND_NAMES) >= 9
    prepare([], print)
