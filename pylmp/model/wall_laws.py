"""Potentials of walls: distance r to a surface -> (force along its normal, energy), shifted to zero at the cutoff.

    lj93      eps (2/15 (s/r)^9 - (s/r)^3)
    lj126     4 eps ((s/r)^12 - (s/r)^6)
    lj1043    2 pi eps (2/5 (s/r)^10 - (s/r)^4 - sqrt(2)/3 s^3/(r + 0.61 s/sqrt(2))^3)
    harmonic  eps (cutoff - r)^2
    morse     D0 (exp(-2 alpha (r - r0)) - 2 exp(-alpha (r - r0)))

Used by fix wall/... and fix wall/region. Source: LAMMPS manual, fix_wall.html and fix_wall_region.html; the order of operations as
measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.wall import Law, whole_power


def lj93(eps: float, sigma: float, cutoff: float) -> Law:
    s3, s9 = whole_power(sigma, 3), whole_power(sigma, 9)
    c1, c2 = 6.0 / 5.0 * eps * s9, 3.0 * eps * s3
    c3, c4 = 2.0 / 15.0 * eps * s9, eps * s3

    def energy(r: Floats) -> Floats:
        ri = 1.0 / r
        r2 = ri * ri
        r4 = r2 * r2
        return c3 * r4 * r4 * ri - c4 * r2 * ri

    offset = at(energy, cutoff)

    def law(r: Floats) -> tuple[Floats, Floats]:
        ri = 1.0 / r
        r2 = ri * ri
        r4 = r2 * r2
        r10 = r4 * r4 * r2
        return c1 * r10 - c2 * r4, energy(r) - offset

    return law


def lj126(eps: float, sigma: float, cutoff: float) -> Law:
    s6, s12 = whole_power(sigma, 6), whole_power(sigma, 12)
    c1, c2, c3, c4 = 48.0 * eps * s12, 24.0 * eps * s6, 4.0 * eps * s12, 4.0 * eps * s6

    def energy(r: Floats) -> Floats:
        ri = 1.0 / r
        r2 = ri * ri
        r6 = r2 * r2 * r2
        return r6 * (c3 * r6 - c4)

    r2 = 1.0 / (cutoff * cutoff)
    r6 = r2 * r2 * r2
    offset = r6 * (c3 * r6 - c4)

    def law(r: Floats) -> tuple[Floats, Floats]:
        ri = 1.0 / r
        r2 = ri * ri
        r6 = r2 * r2 * r2
        return r6 * (c1 * r6 - c2) * ri, energy(r) - offset

    return law


def lj1043(eps: float, sigma: float, cutoff: float, root: float = math.sqrt(2.0)) -> Law:
    """root: the square root of two that LAMMPS uses there."""
    two_pi = 2.0 * math.pi
    s3, s4, s10 = whole_power(sigma, 3), whole_power(sigma, 4), whole_power(sigma, 10)
    c1, c2, c3 = two_pi * 2.0 / 5.0 * eps * s10, two_pi * eps * s4, two_pi * root / 3.0 * eps * s3
    c4 = 0.61 / root * sigma
    c5, c6, c7 = c1 * 10.0, c2 * 4.0, c3 * 3.0

    def energy(r: Floats) -> Floats:
        ri = 1.0 / r
        r2 = ri * ri
        r4 = r2 * r2
        r10 = r4 * r4 * r2
        far = r + c4
        return c1 * r10 - c2 * r4 - c3 * (1.0 / (far * (far * far)))

    offset = at(energy, cutoff)

    def law(r: Floats) -> tuple[Floats, Floats]:
        ri = 1.0 / r
        r2 = ri * ri
        r4 = r2 * r2
        r10 = r4 * r4 * r2
        far = r + c4
        square = far * far
        return c5 * r10 * ri - c6 * r4 * ri - c7 * (1.0 / (square * square)), energy(r) - offset

    return law


def harmonic(eps: float, sigma: float, cutoff: float) -> Law:
    """sigma has no meaning here."""

    def law(r: Floats) -> tuple[Floats, Floats]:
        dr = cutoff - r
        return 2.0 * eps * dr, eps * dr * dr

    return law


def morse(depth: float, alpha: float, rest: float, cutoff: float) -> Law:
    factor = 2.0 * depth * alpha

    def energy(dexp: Floats) -> Floats:
        return depth * (dexp * dexp - 2.0 * dexp)

    reach = cutoff - rest
    offset = depth * (math.exp(-2.0 * alpha * reach) - 2.0 * math.exp(-alpha * reach))

    def law(r: Floats) -> tuple[Floats, Floats]:
        # numpy's exp rounds otherwise than the C library's
        dexp = np.array([math.exp(-alpha * dr) for dr in (r - rest).tolist()])
        return factor * (dexp * dexp - dexp), energy(dexp) - offset

    return law


def at(energy: Callable[[Floats], Floats], r: float) -> float:
    """energy at one distance."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return float(energy(np.array([r]))[0])
