"""bond_style harmonic: E = K (r - r0)^2. The file to copy when adding a bond style.

Source: LAMMPS manual, bond_harmonic.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import Any

from pylmp.laws import select, sqrt
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff


def harmonic(r2: Any, dot: Any, h: Any, c: Any) -> Any:
    """Force over r is -2 K (r - r0)/r, zero at r = 0."""
    k, r0 = c
    r = sqrt(r2)
    dr = r - r0
    rk = k * dr
    apart = r > 0.0
    force = select(apart, -2.0 * rk / select(apart, r, 1.0), 0.0)
    return force, rk * dr, h, True


BONDS.add(
    "harmonic",
    BondStyle(
        name="harmonic",
        manual="bond_harmonic.html",
        coeffs=(Coeff("K", "energy/distance^2"), Coeff("r0", "distance")),
        adapts=("k", "r0"),
        law=lambda options: harmonic,
        length=lambda coeffs, options: coeffs[1],
        omp=True,
        release="harmonic",
    ),
)
