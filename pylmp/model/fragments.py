"""Fragments: atoms joined by bonds, directly or through others. Source: LAMMPS manual, compute_cluster_atom.html."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Ints

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


def fragments(sim: Simulation, chosen: NDArray[np.bool_], single: bool) -> Ints:
    """(n,) the smallest ID among the chosen owned atoms of each one's fragment; 0 for the others.

    Bonds are those of the lists of special neighbors, both ends chosen. Atoms without any bond: 0 unless single.
    """
    atoms, n = sim.atoms, sim.atoms.n
    tags, near = atoms.tag[:n], atoms.num_special[:n, 0]
    result = np.where(chosen & ((near > 0) | single), tags, 0)
    by_tag = atoms.rows_by_tag()
    rows = np.repeat(np.arange(n), near)
    special = atoms.special[rows, np.arange(len(rows)) - np.repeat(np.cumsum(near) - near, near)]
    others = by_tag[np.where(special < len(by_tag), special, 0)]
    keep = (others >= 0) & chosen[rows] & chosen[others]
    root = list(range(n))

    def find(i: int) -> int:
        while root[i] != i:
            root[i] = root[root[i]]
            i = root[i]
        return i

    for i, j in zip(rows[keep].tolist(), others[keep].tolist(), strict=True):
        a, b = find(i), find(j)
        if tags[a] > tags[b]:
            a, b = b, a
        root[b] = a
    heads = np.array([find(i) for i in range(n)], np.int64)
    return np.where(result > 0, tags[heads], 0)
