"""Every law against the manual's formula: at 50 digits, in doubles, and its force against the slope of its energy."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from pylmp.bonds.bpm_spring_plastic import plastic
from pylmp.bonds.fene import fene
from pylmp.bonds.fene_expand import fene_expand
from pylmp.bonds.gromos import gromos
from pylmp.bonds.harmonic import harmonic
from pylmp.bonds.harmonic_shift import shifted
from pylmp.bonds.morse import morse
from pylmp.bonds.nonlinear import nonlinear
from pylmp.bonds.quartic import quartic
from pylmp.pairs.bpm_spring import spring
from pylmp.pairs.lj_cut import lj, row
from pylmp.pairs.lj_expand import expanded
from pylmp.pairs.morse import morse as morse_pair
from pylmp.pairs.soft import PI, soft
from tests.laws import formulas

QUARTIC = (1200.0, -0.55, 0.25, 1.3, 34.6878)
DEEP = (200.0, -1.55, 0.57, 0.7, 3.022)
SHALLOW = (2.0, -1.05, 0.27, 1.6, 1.022)


def lj_row(epsilon, sigma, cut):
    """The numbers the law receives, at the precision of what is given."""
    s6, s12 = sigma**6, sigma**12
    return 48 * epsilon * s12, 24 * epsilon * s6, 4 * epsilon * s12, 4 * epsilon * s6, 0, cut * cut


# name: law(r2, c), reference energy(r, *c), coefficients as doubles, range of r
ENERGIES = {
    "harmonic": (lambda r2, c: harmonic(r2, 0, (), c)[:2], formulas.harmonic, (32.5, 1.13), 0.3, 3.0),
    **{
        f"quartic {kind} {c[0]:g}": (lambda r2, c, b=kind == "breakable": quartic(b)(r2, 0, (), c)[:2], formulas.quartic, c, 0.7, far)
        for kind, c, far in (
            ("breakable", QUARTIC, 1.29), ("unbreakable", QUARTIC, 2.0), ("unbreakable", DEEP, 2.0), ("unbreakable", SHALLOW, 2.0)
        )
    },
    **{
        name: (lambda r2, c, law=law: law(r2, 0, (), c)[:2], formula, c, near, far)
        for name, law, formula, c, near, far in (
            ("fene", fene, formulas.fene, (30.0, 1.5, 1.1, 1.05), 0.8, 1.42),
            ("fene/expand", fene_expand, formulas.fene, (30.0, 1.5, 1.1, 0.95, 0.13), 0.85, 1.54),
            ("morse", morse, formulas.morse, (10.3, 2.1, 1.07), 0.3, 3.0),
            ("nonlinear", nonlinear, formulas.nonlinear, (10.3, 1.07, 1.9), 0.3, 2.9),
            ("gromos", gromos, formulas.gromos, (10.3, 1.07), 0.3, 3.0),
            ("harmonic/shift", shifted(False), formulas.harmonic_shift, (10.3, 1.07, 1.9), 0.3, 3.0),
            ("harmonic/shift/cut", shifted(True), formulas.harmonic_shift, (10.3, 1.07, 1.9), 0.3, 1.89),
        )
    },
    "lj/cut": (lambda r2, c: lj(r2, 0, 1, lj_row(*c, 9)), formulas.lennard_jones, (1.3, 0.9), 0.75, 2.5),
    "morse pair": (
        lambda r2, c: morse_pair(r2, 0, 1, (*c, 2 * c[0] * c[1], 0, 81)), formulas.morse_pair, (1.3, 1.7, 1.15), 0.75, 2.5,
    ),
    "lj/expand": (
        lambda r2, c: expanded(r2, 0, 1, (*lj_row(c[0], c[1], 9)[:4], c[2], 0, 81)), formulas.expanded, (1.3, 0.9, 0.17), 0.95, 2.5,
    ),
    "bpm/spring": (
        lambda r2, c: spring({"anharmonic": False})(r2, 0, 1, (c[0], 0.3, 0, c[1], c[1] * c[1])),
        formulas.spring_pair, (2.3, 1.9), 0.2, 2.2,
    ),
    "bpm/spring anharmonic": (
        lambda r2, c: spring({"anharmonic": True})(r2, 0, 1, (c[0], 0.3, c[2], c[1], c[1] * c[1])),
        formulas.spring_pair, (2.3, 1.9, 5.1), 0.2, 2.2,
    ),
}  # fmt: skip


def radii(low: float, high: float, count: int) -> list[float]:
    return np.random.default_rng(7).uniform(low, high, count).tolist()


@pytest.mark.parametrize("name", ENERGIES)
def test_law_is_the_formula_at_fifty_digits(name: str) -> None:
    law, energy, c, low, high = ENERGIES[name]
    exact = tuple(map(mp.mpf, c))
    for r in map(mp.mpf, radii(low, high, 200)):
        _, e = law(r * r, exact)
        assert abs(e - energy(r, *exact)) <= mp.mpf(10) ** -43 * max(1, abs(e))


@pytest.mark.parametrize("name", ENERGIES)
def test_force_is_minus_the_slope_of_the_energy(name: str) -> None:
    law, energy, c, low, high = ENERGIES[name]
    exact = tuple(map(mp.mpf, c))
    for r in map(mp.mpf, radii(low, high, 100)):
        over_r, _ = law(r * r, exact)
        force = -formulas.slope(lambda s: energy(s, *exact), r)
        assert abs(over_r * r - force) <= mp.mpf(10) ** -25 * max(1, abs(force))
        mine = -formulas.slope(lambda s: law(s * s, exact)[1], r)
        assert abs(over_r * r - mine) <= mp.mpf(10) ** -25 * max(1, abs(force))


@pytest.mark.parametrize(("name", "ulps"), [(name, 12) for name in ENERGIES])
def test_doubles_are_off_by_few_units_of_the_largest_term(name: str, ulps: int) -> None:
    """In doubles: error below ulps units in the last place of the largest term of the sum."""
    law, energy, c, low, high = ENERGIES[name]
    exact = tuple(map(mp.mpf, c))
    for r in radii(low, high, 500):
        _, e = law(r * r, c)
        true = energy(mp.sqrt(mp.mpf(r * r)), *exact)
        assert abs(e - true) <= ulps * math.ulp(largest_term(name, r, c))


def largest_term(name: str, r: float, c: tuple[float, ...]) -> float:
    """A bound of the numbers that are added and subtracted on the way to the energy."""
    wall = 4.0 / r**12 + 4.0 / r**6 + 1.0
    if name.startswith("quartic"):
        k, b1, b2, rc, u0 = c
        x = abs(r - rc)
        relative = max(rc, r) * (
            2.0 / max(x, 1e-3) + 1.0 / max(abs(r - rc - b1), 1e-3) + 1.0 / max(abs(r - rc - b2), 1e-3)
        )
        return abs(u0) + wall + abs(k * x * x * (r - rc - b1) * (r - rc - b2)) * (1.0 + relative)
    if name.startswith("fene"):
        k, r0, epsilon, sigma, *delta = c
        s = r - sum(delta)
        q = 1.0 - (s / r0) ** 2
        return k * r0 * r0 * (1.0 / q - math.log(q)) + 24.0 * epsilon * ((sigma / s) ** 12 + 1.0) * r / s
    if name == "nonlinear":
        x, longest = abs(r - c[1]), c[2]
        return c[0] * longest**2 * (1.0 + r * r) / (longest**2 - x * x) ** 2
    if name.startswith("harmonic/shift"):
        return c[0] / (c[1] - c[2]) ** 2 * (1.0 + r * r)
    if name == "morse":
        z = math.exp(-c[1] * (r - c[2]))
        return c[0] * (1.0 + z) ** 2 * (1.0 + c[1] * r)
    if name == "gromos":
        return c[0] * (r * r + c[1] ** 2) ** 2
    if name == "morse pair":
        z = math.exp(-c[1] * (r - c[2]))
        return c[0] * (z * z + 2.0 * z) * (1.0 + c[1] * r)
    if name == "lj/expand":
        s = r - c[2]
        return 24.0 * c[0] * ((c[1] / s) ** 12 + (c[1] / s) ** 6) * r / s
    if name == "lj/cut":
        return 4.0 * c[0] * ((c[1] / r) ** 12 + (c[1] / r) ** 6)
    gap = abs(r - c[1])
    return max(c) * (1.0 + gap) ** 4 * (1.0 + r)


def test_soft_is_the_formula() -> None:
    """pi is the double nearest to it: the error of that alone bounds the deviation."""
    a, cut = mp.mpf(1.3), mp.mpf(1.9)
    for r in map(mp.mpf, radii(0.1, 2.4, 300)):
        over_r, energy = soft(r * r, 0, 1, (a, cut, cut * cut))
        assert abs(energy - formulas.soft(r, a, cut)) <= a * abs(mp.pi - PI) * r / cut
        force = mp.pi * a / cut * mp.sin(mp.pi * r / cut) if r < cut else 0
        assert abs(over_r * r - force) <= 3 * a / cut * abs(mp.pi - PI) * (1 + mp.pi)


def test_lj_row_is_the_formula() -> None:
    """The numbers handed to the law, to four units in the last place; offset: the energy at the cutoff."""
    for epsilon, sigma, cut in np.random.default_rng(3).uniform(0.5, 2.0, (50, 3)).tolist():
        exact = lj_row(mp.mpf(epsilon), mp.mpf(sigma), mp.mpf(cut))
        got = row((epsilon, sigma), cut, True)
        for q in (0, 1, 2, 3, 5):
            assert abs(got[q] - exact[q]) <= 4 * math.ulp(got[q])
        at_cut = formulas.lennard_jones(mp.mpf(cut), epsilon, sigma)
        assert abs(got[4] - at_cut) <= 16 * math.ulp(4.0 * epsilon * ((sigma / cut) ** 12 + (sigma / cut) ** 6))


@pytest.mark.parametrize("smooth", [True, False])
@pytest.mark.parametrize("normalize", [True, False])
def test_plastic_is_the_formula(smooth: bool, normalize: bool) -> None:
    """A random walk of one bond at 50 digits: force with damping, plastic strain, and whether it holds."""
    law = plastic({"smooth": smooth, "normalize": normalize})
    c = tuple(map(mp.mpf, (10.3, 0.3, 0.51, 0.021)))
    random = np.random.default_rng(9)
    r0 = mp.mpf(1.07)
    h, ep, r = (r0, mp.mpf(0)), mp.mpf(0), r0
    held, yielded = set(), set()
    for step, speed in zip(random.normal(0, 0.05, 400), random.normal(0, 1, 400), strict=True):
        r *= mp.exp(mp.mpf(step))
        before = ep
        over_r, energy, h, alive = law(r * r, r * mp.mpf(speed), h, c)
        force, ep, holds = formulas.plastic(r, mp.mpf(speed), r0, ep, *c, smooth=smooth, normalize=normalize)
        assert abs(over_r * r - force) <= mp.mpf(10) ** -40 * max(1, abs(force))
        assert abs(h[1] - ep) <= mp.mpf(10) ** -45
        assert (h[0], energy, alive) == (r0, 0, holds)
        held.add(holds)
        yielded.add(int(mp.sign(ep - before)))
    assert held == {True, False}
    assert yielded == {-1, 0, 1}


def test_work_of_a_loading_cycle() -> None:
    """Between strains -a and a a perfectly plastic spring dissipates 4 F_y (a - eps_p) r0 a cycle, F_y = k eps_p r0."""
    k, eps_p, r0, a, steps = 10.0, 0.02, 1.3, 0.1, 1000
    law = plastic({"smooth": False, "normalize": False})
    up = np.linspace(-a, a, steps + 1)
    path = np.concatenate([[0.0], np.linspace(0.0, a, steps // 2 + 1), up[::-1], up])
    h, force = (r0, 0.0), []
    for e in path.tolist():
        r = r0 * (1.0 + e)
        over_r, _, h, _ = law(r * r, 0.0, h, (k, 0.5, 0.0, eps_p))
        force.append(over_r * r)
    cycle = slice(-2 * (steps + 1), None)
    work = -np.trapezoid(np.array(force)[cycle], r0 * path[cycle])
    assert math.isclose(work, 4.0 * k * eps_p * r0 * (a - eps_p) * r0, rel_tol=1e-12)


def test_damping_is_along_the_bond_and_dies_at_the_breaking_strain() -> None:
    """F_D = -gamma w (rhat . v)."""
    law = plastic({"smooth": True, "normalize": False})
    rigid = (0.0, 0.25, 0.7, 1.0)
    for r, w in ((1.0, 1.0), (1.125, 1.0 - 0.5**8), (1.25, 0.0)):
        over_r, _, _, _ = law(r * r, r * 3.0, (1.0, 0.0), rigid)
        assert math.isclose(over_r * r, -0.7 * w * 3.0, abs_tol=1e-15)


def test_nothing_leaks_from_beyond_the_cutoff() -> None:
    """What a law computes and does not select may overflow; the selected side is clean."""
    for r2 in (1.0e150, 1.0e300, 1.7e308):
        assert quartic(False)(r2, 0.0, (), QUARTIC)[:2] == (0.0, 34.6878)
        assert quartic(True)(r2, 0.0, (), QUARTIC)[3] is False
        assert lj(r2, 0.0, 1.0, row((1.0, 1.0), 2.5, True)) == (0.0, 0.0)
        for anharmonic in (True, False):
            assert spring({"anharmonic": anharmonic})(r2, 1e10, 1.0, (2.0, 0.3, 5.0, 1.0, 1.0)) == (0.0, 0.0)
    assert harmonic(0.0, 0.0, (), (3.0, 1.0))[:2] == (0.0, 3.0)
