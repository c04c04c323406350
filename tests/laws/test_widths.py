"""One law, several widths: numpy arrays give the bits that floats give, element by element."""

from __future__ import annotations

import math
from itertools import product

import mpmath as mp
import numpy as np
import pytest

from pylmp import laws
from pylmp.bonds.bpm_spring_plastic import plastic
from pylmp.model.registry import BONDS, PAIRS

mp.mp.dps = 50
RANDOM = np.random.default_rng(21)
N = 2000
TABLE = RANDOM.normal(0, 1, 100)
R2 = RANDOM.uniform(0.6, 2.3, N) ** 2
DOT = RANDOM.normal(0, 1, N)
PLASTIC = [
    {"smooth": smooth, "normalize": normalize, "break": True, "overlay/pair": False}
    for smooth, normalize in product((True, False), repeat=2)
]
BOND_LAWS = [
    *(("bpm/spring/plastic", options, (10.3, 0.3, 0.51, 0.021)) for options in PLASTIC),
    *(("bpm/spring", {**options, "volume/factor": False}, (10.3, 0.3, 0.51, 0.0)) for options in PLASTIC),
    *(("bpm/spring", {**options, "volume/factor": True}, (10.3, 0.3, 0.51, 4.1, 1.07)) for options in PLASTIC),
    ("quartic", {}, (1200.0, -0.55, 0.25, 1.3, 34.6878)),
    ("quartic/breakable", {}, (1200.0, -0.55, 0.25, 1.3, 34.6878)),
    ("quartic/unbreakable", {}, (200.0, -1.55, 0.57, 0.7, 3.022)),
    ("harmonic", {}, (32.5, 1.13)),
    ("zero", {}, (1.0,)),
    ("fene", {}, (30.0, 1.5, 1.1, 1.05)),
    ("fene/expand", {}, (30.0, 1.5, 1.1, 0.95, 0.13)),
    ("morse", {}, (10.3, 2.1, 1.07)),
    ("nonlinear", {}, (10.3, 1.07, 1.9)),
    ("gromos", {}, (10.3, 1.07)),
    ("harmonic/shift", {}, (10.3, 1.07, 1.9)),
    ("harmonic/shift/cut", {}, (10.3, 1.07, 1.9)),
    ("table", {"style": 1}, (0.55, 10.0, 0.1, 20.0, 0.01 / 6.0, 1.0, 4.0, TABLE)),
    ("table", {"style": 2}, (0.55, 10.0, 0.1, 20.0, 0.01 / 6.0, 1.0, 4.0, TABLE)),
]
PAIR_LAWS = [
    ("lj/cut", {}, (1.3, 0.9), 1.9),
    ("soft", {}, (1.3,), 1.9),
    ("morse", {}, (1.3, 1.7, 1.15), 1.9),
    ("lj/expand", {}, (1.3, 0.9, 0.17), 1.7),
    ("bpm/spring", {"anharmonic": False}, (2.3, 0.4, 0.0), 1.9),
    ("bpm/spring", {"anharmonic": True}, (2.3, 0.4, 5.1), 1.9),
    *(("table", {"style": kind}, (0.25, 15.0 / 3.36, 3.36 / 15.0, 16.0, 0.01, TABLE), 1.9) for kind in (0, 1, 2)),
    ("table", {"style": 3}, (0.25, float(2**22 - 1), 16.0, 64.0, 0.0, RANDOM.normal(0, 1, 6 * 64)), 1.9),
]


def columns(c: tuple) -> tuple:
    """Coefficients of many at once; what a law looks up is there once."""
    return tuple(x if isinstance(x, np.ndarray) else np.full(N, x) for x in c)


def test_no_law_is_forgotten() -> None:
    assert {name for name, _ in BONDS} == {name for name, _, _ in BOND_LAWS}
    assert {name for name, style in PAIRS if style.law} == {name for name, _, _, _ in PAIR_LAWS}


@pytest.mark.parametrize(("name", "options", "c"), BOND_LAWS)
def test_bond_law(name: str, options: dict, c: tuple) -> None:
    style = BONDS.find(name)
    law = style.law(options)
    h = (RANDOM.uniform(0.9, 1.1, N), RANDOM.normal(0, 0.05, N))[: len(style.history)]
    whole = law(R2, DOT, h, columns(c))
    for q in range(N):
        one = law(float(R2[q]), float(DOT[q]), tuple(float(x[q]) for x in h), c)
        assert [np.broadcast_to(x, N)[q] for x in (whole[0], whole[1], whole[3])] == [one[0], one[1], one[3]]
        assert [x[q] for x in whole[2]] == list(one[2])


@pytest.mark.parametrize(("name", "options", "coeffs", "cut"), PAIR_LAWS)
def test_pair_law(name: str, options: dict, coeffs: tuple, cut: float) -> None:
    style = PAIRS.find(name)
    law = style.law(options)
    c = style.row(coeffs, cut, True)
    factor = RANDOM.choice([0.0, 0.5, 1.0], N)
    if style.data is not None:
        c = (*c, 0.0, style.data(coeffs, cut))
    force, energy = law(R2, DOT, factor, columns(c))
    for q in range(N):
        assert (force[q], energy[q]) == law(float(R2[q]), float(DOT[q]), float(factor[q]), c)
    assert (force == 0.0).any()
    assert (force != 0.0).any()


def test_every_combination_of_options_is_its_own_law() -> None:
    forces = {plastic(options)(1.21, 0.3, (1.05, 0.0), (10.0, 0.3, 0.5, 0.02))[0] for options in PLASTIC}
    assert len(forces) == len(PLASTIC)


def test_functions_answer_as_c_does() -> None:
    """Where Python's math raises: infinite, zero or nan, alone and in arrays; mpmath's numbers keep their digits."""
    inf, nan = math.inf, math.nan
    cases = [
        (laws.exp, (710.0,), inf), (laws.exp, (-inf,), 0.0), (laws.log, (0.0,), -inf), (laws.log, (-1.0,), nan),
        (laws.sin, (inf,), nan), (laws.cos, (-inf,), nan), (laws.power, (0.0, -1.5), inf), (laws.power, (-2.0, 0.5), nan),
        (laws.power, (-1e200, 3.0), -inf), (laws.power, (-1e200, 2.0), inf), (laws.power, (-8.0, 3.0), -512.0),
        (laws.single, (0.1,), 0.10000000149011612), (laws.single, (1e300,), inf), (laws.bits, (1.0,), 0x3F800000), (laws.bits, (-0.0,), -(2**31)),
        (laws.whole, (-2.7,), -2), (laws.whole, (nan,), 0), (laws.whole, (1e300,), 0),
    ]  # fmt: skip
    for function, values, expected in cases:
        np.testing.assert_equal(function(*values), expected)
        np.testing.assert_equal(function(*(np.array([v, v]) for v in values)), np.array([expected] * 2))
    third = laws.power(mp.mpf(2), 1.0 / mp.mpf(3)) - mp.cbrt(2)
    assert abs(third) < mp.mpf(10) ** -45
    assert abs(laws.log(laws.exp(mp.mpf(0.3))) - mp.mpf(0.3)) < mp.mpf(10) ** -45
