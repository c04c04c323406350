"""Special neighbors: who is one, two or three bonds away from whom (1-2, 1-3, 1-4 pairs), found from the bond slots.

Source: LAMMPS manual, special_bonds.html; the printed block as measured on LAMMPS 22 Jul 2025: its maxima of 1-3 and 1-4
count every path, also those of doubled bonds and rings; the lists hold every neighbor once, at its shortest distance.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.model.appetite import make_room
from pylmp.model.atoms import Ints
from pylmp.model.bond import bond_pairs
from pylmp.model.topology import ANGLE, DIHEDRAL, entries
from pylmp.text.number import shortest

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_PATHS_AT_ONCE = 4_000_000  # a bound on memory: atoms are done in stretches with at most so many paths


class Neighborhood:
    """Neighbors one bond away: those of row i are rows member[first[i]:first[i + 1]], own bond slots first.

    A bond counts whether it is on, off or broken, and as often as it is stored. Lost atoms that are still bonded follow
    the owned rows; tags: IDs of all.
    """

    def __init__(self, sim: Simulation) -> None:
        atoms = sim.atoms
        rows, slots, partners = bond_pairs(sim, lambda kinds: np.ones(kinds.shape, bool))
        lost = partners < 0
        gone, at = np.unique(atoms.bond_atom[rows[lost], slots[lost]], return_inverse=True)
        partners = partners.copy()
        partners[lost] = atoms.n + at
        self.tags = np.concatenate([atoms.tag[: atoms.n], gone])
        if sim.newton_bond:
            rows, partners = np.concatenate([rows, partners[~lost]]), np.concatenate([partners, rows[~lost]])
        self.count = np.bincount(rows, minlength=len(self.tags))
        self.first = np.concatenate([[0], np.cumsum(self.count)])
        self.member = partners[np.argsort(rows, kind="stable")]

    def expand(self, roots: Ints, rows: Ints) -> tuple[Ints, Ints]:
        """All neighbors of each row of rows, each under the root of its row."""
        counts = self.count[rows]
        ends = np.cumsum(counts)
        steps = np.arange(int(ends[-1]) if len(ends) else 0) - np.repeat(ends - counts, counts)
        return np.repeat(roots, counts), self.member[np.repeat(self.first[rows], counts) + steps]

    def paths(self) -> tuple[Ints, Ints, Ints]:
        """(n,) numbers of 1-2, 1-3 and 1-4 paths from each atom, as LAMMPS counts them: only the first step back is left out."""
        degree = self.count
        owner = np.repeat(np.arange(len(degree)), degree)
        two = np.bincount(owner, degree[self.member], len(degree)).astype(np.int64)
        three = np.bincount(owner, two[self.member], len(degree)).astype(np.int64)
        return degree, two - degree, three - degree * degree


    def pairs(self, bonds: int) -> Ints:
        """Pairs of rows (i*n + j) that a path of two or three bonds joins, as LAMMPS goes: only the first step back is left out, and
        of a doubled bond only one of the two ways back."""
        n = len(self.count)
        root = other = np.arange(n)
        for step in range(bonds):
            parents = np.repeat(np.arange(len(root)), self.count[other])
            root, other = self.expand(root, other)
            if step == 1:
                back = np.flatnonzero(root == other)
                _, first = np.unique(parents[back], return_index=True)
                root, other = np.delete(root, back[first]), np.delete(other, back[first])
        foreign = root != other
        return np.unique(root[foreign] * np.int64(n) + other[foreign])


def build_special(sim: Simulation) -> None:
    """Rebuild every atom's lists, and print what LAMMPS prints.

    1-3 lists are built only if their weights, or those of 1-4 pairs, differ from 1; 1-4 lists only if theirs do.
    With special_bonds angle (dihedral) yes only those 1-3 (1-4) neighbors stay that an angle or dihedral joins.
    """
    make_room(sim)
    settings = sim.special
    ones = (1.0, 1.0)
    fourth = (settings.lj[2], settings.coul[2]) != ones
    third = fourth or (settings.lj[1], settings.coul[1]) != ones
    depth = 3 if fourth else 2 if third else 1
    near = Neighborhood(sim)
    paths = near.paths()
    lines = ["Finding 1-2 1-3 1-4 neighbors ..."]
    for name, weights in (("lj:   ", settings.lj), ("coul: ", settings.coul)):
        lines.append(f"  special bond factors {name} " + " ".join(f"{shortest(w):<8}" for w in weights))
    for k in range(depth):
        lines.append(f"{int(paths[k].max(initial=0)):6d} = max # of 1-{k + 2} neighbors")
    joined: list[Ints | None] = [None, None, None]
    total = len(near.tags)
    for k, flag, name in ((1, settings.angle, "angle"), (2, settings.dihedral, "dihedral")):
        if flag and k < depth:
            joined[k] = _joined(sim, name, total)
            before = near.pairs(k + 1)
            lines.append(f"  {len(before)} = # of 1-{k + 2} neighbors before {name} trim")
            lines.append(f"  {int(_among(before, joined[k]).sum())} = # of 1-{k + 2} neighbors after {name} trim")
    longest = _fill(sim, near, joined[:depth])
    room = max(sim.atoms.max_special, longest, 1) + sim.extra_special
    sim.extra_special = 0  # it counts once
    sim.atoms.widen_special(room)
    lines.append(f"{room:6d} = max # of special neighbors")
    lines.append("  special bonds CPU = 0.000 seconds")
    sim.console.both("\n".join(lines) + "\n")


def _joined(sim: Simulation, name: str, n: int) -> Ints:
    """Pairs of rows (i*n + j: j stays in the list of i) that an angle joins by its ends, a dihedral by its ends.

    For special_bonds angle yes a dihedral a-b-c-d joins a to c, c to a and d to b. LAMMPS forgets b to d, and so must we.
    """
    ends = [(ANGLE, 0, 2), (ANGLE, 2, 0), (DIHEDRAL, 0, 2), (DIHEDRAL, 2, 0), (DIHEDRAL, 3, 1)]
    if name == "dihedral":
        ends = [(DIHEDRAL, 0, 3), (DIHEDRAL, 3, 0)]
    keys = []
    for kind, one, other in ends:
        at = entries(sim, kind).at(sim)
        at = at[(at[:, [one, other]] >= 0).all(axis=1)]
        keys.append(at[:, one] * np.int64(n) + at[:, other])
    return np.unique(np.concatenate(keys))


def _among(keys: Ints, sorted_keys: Ints | None) -> NDArray[np.bool_]:
    assert sorted_keys is not None
    at = np.minimum(np.searchsorted(sorted_keys, keys), len(sorted_keys) - 1)
    return np.asarray(sorted_keys[at] == keys) if len(sorted_keys) else np.zeros(len(keys), bool)


def _fill(sim: Simulation, near: Neighborhood, wanted: list[Ints | None]) -> int:
    """Write the lists; returns the longest. wanted: pairs of neighbors one, two, three bonds away that belong to them; None: all."""
    n = sim.atoms.n
    degree = near.count
    cost = np.cumsum(degree + near.paths()[len(wanted) - 1] + degree * degree)
    longest, begin = 0, 0
    while begin < n:
        spent = int(cost[begin - 1]) if begin else 0
        end = min(n, max(begin + 1, int(np.searchsorted(cost, spent + _PATHS_AT_ONCE, side="right"))))
        longest = max(longest, _fill_rows(sim, near, np.arange(begin, end), wanted))
        begin = end
    return longest


def _fill_rows(sim: Simulation, near: Neighborhood, rows: Ints, wanted: list[Ints | None]) -> int:
    atoms, total = sim.atoms, np.int64(len(near.tags))
    roots, others, levels = [], [], []
    root, other = rows, rows
    for k, keep in enumerate(wanted):
        root, other = near.expand(root, other)
        stays = slice(None) if keep is None else _among(root * total + other, keep)
        roots.append(root[stays])
        others.append(other[stays])
        levels.append(np.full(len(root[stays]), k))
    root, other, level = np.concatenate(roots), np.concatenate(others), np.concatenate(levels)
    foreign = root != other
    root, other, level = root[foreign], other[foreign], level[foreign]
    _, seen = np.unique(root * total + other, return_index=True)  # each where it comes first: levels ascend
    seen.sort()
    order = seen[np.argsort(root[seen], kind="stable")]
    root, other, level = root[order], other[order], level[order]
    counts = np.bincount(root - rows[0], minlength=len(rows))
    longest = int(counts.max(initial=0))
    atoms.widen_special(longest)
    slot = np.arange(len(root)) - np.repeat(np.cumsum(counts) - counts, counts)
    atoms.special[rows] = 0
    atoms.special[root, slot] = near.tags[other]
    for k in range(3):
        atoms.num_special[rows, k] = np.bincount(root[level <= k] - rows[0], minlength=len(rows))
    return longest
