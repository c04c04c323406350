"""Atoms that leave, and geometry that LAMMPS warns of at set-up."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Ints
from pylmp.model.bond import bond_pairs

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_STRETCH = 1.1  # measured on LAMMPS 22 Jul 2025: it warns as if bonds were this much longer


def remove_lost(sim: Simulation) -> None:
    """Drop owned atoms beyond the faces, as LAMMPS's exchange does: the last atom moves into the hole. In frame coordinates.

    In periodic directions these are atoms more than one box length away, since wrapping moves by one at most.
    """
    atoms = sim.atoms
    lo, hi = sim.box.frame
    for d in range(3):
        x = atoms.x[: atoms.n, d]
        if not ((x < lo[d]) | (x >= hi[d])).any():
            continue
        order = list(range(atoms.n))
        i = 0
        while i < len(order):
            c = float(atoms.x[order[i], d])
            if c < lo[d] or c >= hi[d]:
                order[i] = order[-1]
                order.pop()
            else:
                i += 1
        atoms.keep(np.array(order, np.int64))


def _bonds(sim: Simulation) -> tuple[Ints, Ints]:
    """Rows of the two ends of each bond that is on."""
    rows, _, partners = bond_pairs(sim, lambda kinds: kinds > 0)
    known = partners >= 0
    return rows[known], partners[known]


def warn_images(sim: Simulation) -> None:
    """Warn of image flags that disagree along a bond."""
    if not sim.has_bonds or not any(sim.box.periodic):
        return
    rows, partners = _bonds(sim)
    atoms, box = sim.atoms, sim.box
    d = box.minimum_image(atoms.x[rows] - atoms.x[partners])
    unwrapped = box.unwrap(atoms.x[rows], atoms.image[rows]) - box.unwrap(atoms.x[partners], atoms.image[partners])
    if np.any(np.abs(unwrapped - d) > 0.5 * box.length):
        sim.console.warning("Inconsistent image flags")


def warn_extent(sim: Simulation) -> None:
    """Warn of a periodic box so small that the longest bond, stretched a little more, has two images to choose from."""
    box = sim.box
    periodic = np.array(box.periodic[: sim.dimension])
    if not sim.has_bonds or not periodic.any():
        return
    rows, partners = _bonds(sim)
    if len(rows):
        d = box.minimum_image(sim.atoms.x[rows] - sim.atoms.x[partners])
        longest = float(np.sqrt((d * d).sum(axis=1).max()))
        if np.any(periodic & (box.length[: sim.dimension] < 2.0 * longest * _STRETCH)):
            sim.console.warning("Bond/angle/dihedral extent > half of periodic box length")
