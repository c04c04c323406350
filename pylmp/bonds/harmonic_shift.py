"""bond_style harmonic/shift: E = Um/(r0 - rc)^2 [(r - r0)^2 - (r0 - rc)^2], zero at rc, -Um at r0.

Source: LAMMPS manual, bond_harmonic_shift.html. Order of operations as measured on
LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pylmp.laws import select, sqrt
from pylmp.model.blob import Blob, nearest
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff, Law, Options
from pylmp.text.words import Args


def shifted(cut: bool) -> Law:
    def law(r2: Any, dot: Any, h: Any, c: Any) -> Any:
        depth, r0, rc = c
        r = sqrt(r2)
        dr = r - r0
        gap = r0 - rc
        k = depth / (gap * gap)
        rk = k * dr
        apart = r > 0.0
        force = select(apart, -2.0 * rk / select(apart, r, 1.0), 0.0)
        energy = k * (dr * dr - gap * gap)
        if cut:
            force = select(r > rc, 0.0, force)
            energy = select(r > rc, 0.0, energy)
        return force, energy, h, True

    return law


def check(name: str) -> Any:
    def different(options: Options, args: Args, values: tuple[float, ...]) -> None:
        if values[1] == values[2]:
            args.fail(f"Bond {name} r0 and r1 must be different", hint="the energy is zero at rc, and least at r0")

    return different


def stiffness(values: Sequence[float]) -> tuple[float, ...]:
    """Um, r0, rc to k, r0, rc, which is what LAMMPS keeps."""
    um, r0, rc = values
    gap = r0 - rc
    return um / (gap * gap), r0, rc


def depth(values: Sequence[float]) -> tuple[float, ...]:
    k, r0, rc = values
    return nearest(k * ((r0 - rc) * (r0 - rc)), k, lambda um: stiffness((um, r0, rc))[0]), r0, rc


def style(name: str, cut: bool) -> BondStyle:
    return BondStyle(
        name=name, manual=f"bond_{name.replace('/', '_')}.html",
        coeffs=(Coeff("Um", "energy"), Coeff("r0", "distance"), Coeff("rc", "distance")),
        law=lambda options: shifted(cut), length=lambda coeffs, options: coeffs[1], check=check(name), omp=True, release=name,
        restart=Blob(pack=stiffness, unpack=depth),
    )  # fmt: skip


BONDS.add("harmonic/shift", style("harmonic/shift", False))
