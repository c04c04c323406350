"""bond_style quartic/breakable and quartic/unbreakable.

    E_q  = K (r - Rc)^2 (r - Rc - B1) (r - Rc - B2) + U0      r <= Rc
    E_lj = 4 (r^-12 - r^-6) + 1                               r <  2^(1/6)

quartic/breakable (the release's quartic): past Rc the bond is gone, its type 0, its energy 0; while it holds, the pair
interaction of its two atoms is taken out, so that it is there at once when the bond breaks.
quartic/unbreakable: past Rc the energy stays U0 and the quartic force is zero; the LJ term and nothing else acts below 2^(1/6).

Source: LAMMPS manual, bond_quartic.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import Any

from pylmp.laws import select, sqrt
from pylmp.model.blob import Blob
from pylmp.model.many_body import has_many_body
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff, Law, Restriction, always

WALL2 = 1.2599210498948732  # (2^(1/6))^2: where the LJ term ends
LENGTH = 0.97  # LAMMPS's fixed estimate of the bond length

COEFFS = (
    Coeff("K", "energy/distance^4"),
    Coeff("B1", "distance"),
    Coeff("B2", "distance"),
    Coeff("Rc", "distance"),
    Coeff("U0", "energy"),
)


def quartic(breakable: bool) -> Law:
    def law(r2: Any, dot: Any, h: Any, c: Any) -> Any:
        k, b1, b2, rc, u0 = c
        r = sqrt(r2)
        dr = r - rc
        d2 = dr * dr
        ra = dr - b1
        rb = dr - b2
        force = -k / r * (d2 * (ra + rb) + 2.0 * dr * ra * rb)
        energy = k * d2 * ra * rb + u0
        beyond = r2 > rc * rc
        if not breakable:
            force = select(beyond, 0.0, force)
            energy = select(beyond, u0, energy)
        s2 = 1.0 / r2
        s6 = s2 * s2 * s2
        near = r2 < WALL2
        force = force + select(near, 48.0 * s6 * (s6 - 0.5) / r2, 0.0)
        energy = energy + select(near, 4.0 * s6 * (s6 - 1.0) + 1.0, 0.0)
        return force, energy, h, select(beyond, False, True)

    return law


def single(r2: Any, c: Any, pair_energy: Any) -> Any:
    """Energy of one bond as compute bond/local gives it: the pair energy leaves before the LJ term enters."""
    k, b1, b2, rc, u0 = c
    dr = sqrt(r2) - rc
    ra = dr - b1
    rb = dr - b2
    s2 = 1.0 / r2
    s6 = s2 * s2 * s2
    wall = select(r2 < WALL2, 4.0 * s6 * (s6 - 1.0) + 1.0, 0.0)
    return k * (dr * dr) * ra * rb + u0 - pair_energy + wall


def no_single(sim: Any, _: Any) -> bool:
    return sim.pair is None


RESTRICTIONS = (
    Restriction("B101", "Pair style does not support bond_style quartic", no_single, "pair_style lj/cut or zero before the run"),
    Restriction(
        "B102", "Bond style quartic cannot be used with 3,4-body interactions", lambda sim, _: has_many_body(sim),
        "angle_style none, dihedral_style none, improper_style none",
    ),
    Restriction(
        "B103", "Bond style quartic requires special_bonds = 1,1,1", lambda sim, _: sim.special.lj != (1.0, 1.0, 1.0),
        "special_bonds lj/coul 1 1 1",
    ),
)  # fmt: skip

for name, release in (("quartic", "quartic"), ("quartic/breakable", "")):
    BONDS.add(
        name,
        BondStyle(
            name=name, manual="bond_quartic.html", coeffs=COEFFS, law=lambda options: quartic(True),
            restrictions=RESTRICTIONS, can_break=always(True), on_break="zero", breaks_in_setup=True,
            subtract_pair=True, single=single, length=lambda coeffs, options: LENGTH, mixable=True, omp=True, release=release,
            restart=Blob(name="quartic"),
        ),
    )  # fmt: skip

BONDS.add(
    "quartic/unbreakable",
    BondStyle(
        name="quartic/unbreakable", manual="bond_quartic.html", coeffs=COEFFS, law=lambda options: quartic(False),
        length=lambda coeffs, options: LENGTH, mixable=None, omp=True,
    ),
)  # fmt: skip
