"""bond_style gromos: E = K (r^2 - r0^2)^2.

Source: LAMMPS manual, bond_gromos.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import Any

from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff


def gromos(r2: Any, dot: Any, h: Any, c: Any) -> Any:
    k, r0 = c
    dr = r2 - r0 * r0
    kd = k * dr
    return -4.0 * kd, kd * dr, h, True


BONDS.add(
    "gromos",
    BondStyle(
        name="gromos", manual="bond_gromos.html", coeffs=(Coeff("K", "energy/distance^4"), Coeff("r0", "distance")),
        adapts=("k", "r0"), law=lambda options: gromos, length=lambda coeffs, options: coeffs[1], omp=True, release="gromos",
    ),
)  # fmt: skip
