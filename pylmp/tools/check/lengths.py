"""The bonds of the first set-up, for rules that look at how long they are."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats, Ints
from pylmp.model.bond import bond_pairs
from pylmp.model.simulation import Simulation

_SMALL = 200_000  # atoms whose bonds are looked at


class Lengths(NamedTuple):
    """rows, slots: where each bond is stored; partners: the other row; kinds, r: its type, its length."""

    rows: Ints
    slots: Ints
    partners: Ints
    kinds: NDArray[np.int32]
    r: Floats


def first_lengths(sim: Simulation) -> Lengths | None:
    """Of all bonds between atoms that are there; None after the first run, without bonds, and in large systems."""
    if sim.ran or sim.bond is None or not sim.has_bonds or sim.atoms.n > _SMALL:
        return None
    atoms = sim.atoms
    rows, slots, partners = bond_pairs(sim, lambda types: types > 0)
    there = partners >= 0
    rows, slots, partners = rows[there], slots[there], partners[there]
    r = np.sqrt((sim.box.minimum_image(atoms.x[rows] - atoms.x[partners]) ** 2).sum(axis=1))
    return Lengths(rows, slots, partners, atoms.bond_type[rows, slots], r)
