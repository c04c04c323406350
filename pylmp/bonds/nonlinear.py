"""bond_style nonlinear: E = epsilon (r - r0)^2 / [lambda^2 - (r - r0)^2].

Source: LAMMPS manual, bond_nonlinear.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import Any

from pylmp.laws import sqrt
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff


def nonlinear(r2: Any, dot: Any, h: Any, c: Any) -> Any:
    epsilon, r0, longest = c
    r = sqrt(r2)
    dr = r - r0
    square = longest * longest
    rest = square - dr * dr
    return -epsilon / r * 2.0 * dr * square / (rest * rest), epsilon * (dr * dr) / rest, h, True


BONDS.add(
    "nonlinear",
    BondStyle(
        name="nonlinear", manual="bond_nonlinear.html",
        coeffs=(Coeff("epsilon", "energy"), Coeff("r0", "distance"), Coeff("lambda", "distance")),
        adapts=("epsilon", "r0", "lamda"), law=lambda options: nonlinear, length=lambda coeffs, options: coeffs[1], omp=True, release="nonlinear",
    ),
)  # fmt: skip
