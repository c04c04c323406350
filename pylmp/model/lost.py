"""Atoms that leave, and geometry that LAMMPS warns of at set-up."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.bond import bond_pairs

if TYPE_CHECKING:
    from pylmp.model.ghosts import Ghosts
    from pylmp.model.simulation import Simulation


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


def warn_geometry(sim: Simulation, ghosts: Ghosts) -> None:
    """Bonds longer than half a periodic box length, and image flags that disagree along a bond."""
    if not sim.has_bonds or not any(sim.box.periodic):
        return
    rows, _, partners = bond_pairs(sim, lambda kinds: kinds > 0)
    keep = partners >= 0
    rows, partners = rows[keep], partners[keep]
    if not len(rows):
        return
    atoms, box = sim.atoms, sim.box
    d = box.minimum_image(atoms.x[rows] - atoms.x[partners])
    unwrapped = box.unwrap(atoms.x[rows], atoms.image[rows]) - box.unwrap(atoms.x[partners], atoms.image[partners])
    if np.any(np.abs(unwrapped - d) > 0.5 * box.length):
        sim.console.warning("Inconsistent image flags")
    listed = [entry for bonds in sim.bond_lists for entry in (bonds.bonds[: bonds.count],)]
    for bonds in listed:
        apart = atoms.x[bonds[:, 0]] - atoms.x[bonds[:, 1]]
        if np.any(box.minimum_image(apart) != apart):
            sim.console.warning("Bond/angle/dihedral extent > half of periodic box length")
            return
