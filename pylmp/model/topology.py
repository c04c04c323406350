"""Bonds, angles, dihedrals, impropers: four kinds of one thing, a type and the IDs of two, three or four atoms.

An atom stores them in slots: num_KIND, KIND_type and KIND_atom of model/atoms.py. With newton bond on one atom stores each (the first
of a bond, the second of the others), with newton bond off every atom it joins does. A type below 0 is turned off, 0 is a broken bond.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import AnyInts, Ints, Small

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

Wanted = Callable[[AnyInts], NDArray[np.bool_]]


@dataclass(frozen=True)
class Kind:
    """size: atoms that one joins. keeper: which of them stores it with newton bond on, and stands for it where it is counted once."""

    name: str
    size: int
    keeper: int

    @property
    def plural(self) -> str:
        return f"{self.name}s"

    def total(self, sim: Simulation) -> int:
        """LAMMPS's global count."""
        return int(getattr(sim, self.plural))

    def set_total(self, sim: Simulation, count: int) -> None:
        setattr(sim, self.plural, count)

    def types(self, sim: Simulation) -> int:
        return int(getattr(sim, f"{self.name}_types"))

    def style(self, sim: Simulation) -> Any:
        """The force style of this kind, or None."""
        return getattr(sim, self.name)

    def numbers(self, sim: Simulation) -> Small:
        """(capacity,) slots in use."""
        array: Small = getattr(sim.atoms, f"num_{self.name}")
        return array

    def kinds(self, sim: Simulation) -> Small:
        """(capacity, slots) types."""
        array: Small = getattr(sim.atoms, f"{self.name}_type")
        return array

    def members(self, sim: Simulation) -> Small:
        """(capacity, slots, size) IDs of the atoms; for bonds (capacity, slots): the partner's."""
        array: Small = getattr(sim.atoms, f"{self.name}_atom")
        return array

    def recount(self, sim: Simulation) -> int:
        """The global count from the slots in use."""
        stored = int(self.numbers(sim)[: sim.atoms.n].sum())
        self.set_total(sim, stored if sim.newton_bond else stored // self.size)
        return self.total(sim)


BOND, ANGLE, DIHEDRAL, IMPROPER = KINDS = (
    Kind("bond", 2, 0), Kind("angle", 3, 1), Kind("dihedral", 4, 1), Kind("improper", 4, 1),
)  # fmt: skip
KIND = {kind.name: kind for kind in KINDS}


@dataclass
class Entries:
    """Slots of owned atoms, in row and slot order: rows, slots, types (k,); tags (k, size) the atoms' IDs in order."""

    kind: Kind
    rows: Ints
    slots: Ints
    types: Ints
    tags: Ints

    def __len__(self) -> int:
        return len(self.rows)

    def take(self, chosen: Any) -> Entries:
        return Entries(self.kind, self.rows[chosen], self.slots[chosen], self.types[chosen], self.tags[chosen])

    def at(self, sim: Simulation) -> Ints:
        """(k, size) rows of the atoms, -1 where an atom is not there."""
        by_tag = sim.atoms.rows_by_tag()
        known = (self.tags >= 0) & (self.tags < len(by_tag))
        return np.where(known, by_tag[np.where(known, self.tags, 0)], -1)

    def once(self, sim: Simulation) -> Entries:
        """Each a single time: with newton bond off that of a bond's lower ID, else that of the keeper."""
        if sim.newton_bond:
            return self
        own = sim.atoms.tag[self.rows]
        return self.take(own < self.tags[:, 1] if self.kind is BOND else own == self.tags[:, self.kind.keeper])


def entries(sim: Simulation, kind: Kind, wanted: Wanted | None = None) -> Entries:
    """The stored slots of a kind whose type satisfies wanted."""
    atoms, n = sim.atoms, sim.atoms.n
    types = kind.kinds(sim)[:n]
    used = np.arange(types.shape[1])[None, :] < kind.numbers(sim)[:n, None]
    rows, slots = np.nonzero(used & wanted(types) if wanted else used)
    members = kind.members(sim)[rows, slots]
    tags = np.stack([atoms.tag[rows], members], axis=1) if kind is BOND else members.astype(np.int64)
    return Entries(kind, rows, slots, types[rows, slots].astype(np.int64), tags)


def keepers(sim: Simulation, kind: Kind, tags: Ints) -> Ints:
    """(k, m) IDs of the atoms that store tags (k, size)."""
    return tags[:, kind.keeper : kind.keeper + 1] if sim.newton_bond else tags


def crowd(sim: Simulation, kind: Kind, tags: Ints) -> Ints:
    """(n,) how many of tags (k, size) each owned atom would store."""
    rows = sim.atoms.rows_by_tag()[keepers(sim, kind, tags).ravel()]
    return np.bincount(rows, minlength=sim.atoms.n)


def store(sim: Simulation, kind: Kind, types: Ints, tags: Ints) -> None:
    """Append to the slots of the atoms that keep them, in the order given. There must be room.

    types (k,); tags (k, size) IDs of owned atoms.
    """
    atoms, holders = sim.atoms, keepers(sim, kind, tags)
    rows = atoms.rows_by_tag()[holders.ravel()]
    entry = np.repeat(np.arange(len(tags)), holders.shape[1])
    new = np.bincount(rows, minlength=atoms.n)
    rank = np.empty(len(rows), np.int64)
    rank[np.argsort(rows, kind="stable")] = np.arange(len(rows)) - np.repeat(np.cumsum(new) - new, new)
    slots = kind.numbers(sim)[rows] + rank
    kind.kinds(sim)[rows, slots] = types[entry]
    if kind is BOND:
        pair = tags[entry]
        atoms.bond_atom[rows, slots] = np.where(pair[:, 0] == atoms.tag[rows], pair[:, 1], pair[:, 0])
        atoms.bond_history[rows, slots] = 0.0
    else:
        kind.members(sim)[rows, slots] = tags[entry]
    kind.numbers(sim)[: atoms.n] += new
