"""bond_style morse: E = D [1 - exp(-alpha (r - r0))]^2.

Source: LAMMPS manual, bond_morse.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import Any

from pylmp.laws import exp, select, sqrt
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff


def morse(r2: Any, dot: Any, h: Any, c: Any) -> Any:
    d, alpha, r0 = c
    r = sqrt(r2)
    z = exp(-alpha * (r - r0))
    apart = r > 0.0
    force = select(apart, -2.0 * d * alpha * (1.0 - z) * z / select(apart, r, 1.0), 0.0)
    return force, d * (1.0 - z) * (1.0 - z), h, True


BONDS.add(
    "morse",
    BondStyle(
        name="morse", manual="bond_morse.html",
        coeffs=(Coeff("D", "energy"), Coeff("alpha", "1/distance"), Coeff("r0", "distance")),
        adapts=("d0", "alpha", "r0"), law=lambda options: morse, length=lambda coeffs, options: coeffs[2], omp=True, release="morse",
    ),
)  # fmt: skip
