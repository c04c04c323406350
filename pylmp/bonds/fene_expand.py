"""bond_style fene/expand: bond_style fene of the length r - delta, for beads of unlike size.

Source: LAMMPS manual, bond_fene_expand.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import Any

from pylmp.bonds.fene import LEAST, LENGTH, WALL2, WORST, cautions, report_alone, squared, warn
from pylmp.laws import log, select, sqrt
from pylmp.model.atoms import Ints
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff, always
from pylmp.text.number import eight


def fene_expand(r2: Any, dot: Any, h: Any, c: Any) -> Any:
    k, r0, epsilon, sigma, delta = c
    r = sqrt(r2)
    rs = r - delta
    rs2 = rs * rs
    q = 1.0 - rs2 / (r0 * r0)
    q = select(q < LEAST, LEAST, q)
    force = -k * rs / q / r
    energy = -0.5 * k * (r0 * r0) * log(q)
    s2 = sigma * sigma / rs2
    s6 = s2 * s2 * s2
    near = rs2 < WALL2 * sigma * sigma
    force = force + select(near, 48.0 * epsilon * s6 * (s6 - 0.5) / rs / r, 0.0)
    energy = energy + select(near, 4.0 * epsilon * s6 * (s6 - 1.0) + epsilon, 0.0)
    return force, energy, h, True


def left(r2: Any, c: Any) -> Any:
    """1 - ((r - delta)/R0)^2."""
    rs = sqrt(r2) - c[4]
    return 1.0 - rs * rs / (c[1] * c[1])


def too_long(r2: Any, c: Any) -> Any:
    return left(r2, c) < LEAST


def report(sim: Any, part: Any, bonds: Ints) -> None:
    for first, second, kind in bonds.tolist():
        warn(sim, first, second, eight, bool(left(float(squared(sim, first, second)), part.table[kind]) <= WORST))


BONDS.add(
    "fene/expand",
    BondStyle(
        name="fene/expand", manual="bond_fene_expand.html",
        coeffs=(
            Coeff("K", "energy/distance^2"), Coeff("R0", "distance"), Coeff("epsilon", "energy"), Coeff("sigma", "distance"),
            Coeff("delta", "distance"),
        ),
        adapts=("k", "r0", "epsilon", "sigma", "shift"), law=lambda options: fene_expand, length=lambda coeffs, options: LENGTH * coeffs[3] + coeffs[4], watch=always(too_long),
        report=report, report_alone=report_alone, cautions=cautions("fene/expand"), omp=True, release="fene/expand",
    ),
)  # fmt: skip
