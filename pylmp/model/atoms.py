"""The atoms: a structure of numpy arrays in LAMMPS's local order.

Rows ``0 .. n-1`` are owned atoms, rows ``n .. n+ghosts-1`` are ghosts (periodic images), rows beyond are spare.
All arrays share one capacity. Only ``x v f tag type mask`` mean anything in ghost rows.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.text.diagnostic import ScriptError, Unsupported

_LARGEST_ID = 2**27  # tables by ID stay below a gigabyte
MOST_SLOTS, MOST_TYPES = 10_000, 100_000
Ints = NDArray[np.int64]
Small = NDArray[np.int32]
AnyInts = NDArray[np.integer[Any]]
Floats = NDArray[np.float64]

_MANY = {"angle": 3, "dihedral": 4, "improper": 4}  # atoms that one joins
_PER_ATOM = (
    "x", "v", "f", "tag", "type", "mask", "image", "molecule", "q",
    "num_bond", "bond_type", "bond_atom", "bond_history", "num_special", "special",
    *(name for kind in _MANY for name in (f"num_{kind}", f"{kind}_type", f"{kind}_atom")),
)  # fmt: skip


class Atoms:
    """Per-atom arrays.

    x v f         (capacity, 3) float64: position, velocity, force
    tag           (capacity,) int64: atom ID, from 1
    type mask     (capacity,) int64: atom type from 1; group bits (bit 0 = all)
    image         (capacity, 3) int32: periodic image flags
    molecule      (capacity,) int64: molecule ID
    q             (capacity,) float64: charge
    num_bond      (capacity,) int32: bond slots in use
    bond_type bond_atom   (capacity, bond_per_atom) int32: a slot's bond type (<= 0: off or broken) and partner ID
    bond_history  (capacity, bond_per_atom, width) float64: what a slot's bond remembers (r0, ep)
    num_angle angle_type angle_atom   the same for angles: (capacity, slots, 3) IDs of all three atoms; dihedral, improper: (.., 4)
    num_special   (capacity, 3) int32: cumulative counts of 1-2, 1-3, 1-4 neighbors in special
    special       (capacity, max_special) int32: their IDs
    extra         name -> (capacity, ...) array: what a fix or style stores per atom; rides along with the atoms
    newcomers     name -> function of (atoms, rows) that gives the rows of extra[name] for new atoms; 0 where there is none
    """

    x: Floats
    v: Floats
    f: Floats
    tag: Ints
    type: Ints
    mask: Ints
    image: Small
    molecule: Ints
    q: Floats
    num_bond: Small
    bond_type: Small
    bond_atom: Small
    bond_history: Floats
    num_special: Small
    special: Small
    num_angle: Small
    angle_type: Small
    angle_atom: Small
    num_dihedral: Small
    dihedral_type: Small
    dihedral_atom: Small
    num_improper: Small
    improper_type: Small
    improper_atom: Small

    def __init__(self, bond_per_atom: int = 0, max_special: int = 1, **slots: int) -> None:
        """slots: those of angles, dihedrals, impropers, none by default. Raises ScriptError for numbers that cannot be meant."""
        for name, count in {"bond": bond_per_atom, "special": max_special, **slots}.items():
            check_count(count, MOST_SLOTS, f"{name}s per atom")
        self.n = 0
        self.ghosts = 0
        self.bond_per_atom = bond_per_atom
        self.max_special = max_special
        self.extra: dict[str, NDArray[np.generic]] = {}
        self.newcomers: dict[str, Callable[[Atoms, slice], Floats]] = {}
        for name in ("x", "v", "f"):
            setattr(self, name, np.zeros((0, 3)))
        for name in ("tag", "type", "mask", "molecule"):
            setattr(self, name, np.zeros(0, np.int64))
        self.image = np.zeros((0, 3), np.int32)
        self.num_bond = np.zeros(0, np.int32)
        self.bond_type = np.zeros((0, bond_per_atom), np.int32)
        self.bond_atom = np.zeros((0, bond_per_atom), np.int32)
        self.bond_history = np.zeros((0, bond_per_atom, 0))
        self.num_special = np.zeros((0, 3), np.int32)
        self.special = np.zeros((0, max_special), np.int32)
        self.q = np.zeros(0)
        for kind, size in _MANY.items():
            width = slots.get(kind, 0)
            setattr(self, f"num_{kind}", np.zeros(0, np.int32))
            setattr(self, f"{kind}_type", np.zeros((0, width), np.int32))
            setattr(self, f"{kind}_atom", np.zeros((0, width, size), np.int32))

    @property
    def capacity(self) -> int:
        return len(self.tag)

    @property
    def total(self) -> int:
        """Owned and ghost atoms."""
        return self.n + self.ghosts

    def reserve(self, rows: int) -> bool:
        """Make room for rows rows; True if the arrays moved (addresses held elsewhere are then stale)."""
        if rows <= self.capacity:
            return False
        rows += rows // 4 + 64
        for name in _PER_ATOM:
            setattr(self, name, _grown(getattr(self, name), rows))
        for name in self.extra:
            self.extra[name] = _grown(self.extra[name], rows)
        return True

    def append(self, x: Floats, type_: Ints | int) -> range:
        """Add atoms after the owned ones; ghosts are forgotten. IDs, images, velocities stay 0, group all.

        x  (k, 3). Returns the new rows.
        """
        new = range(self.n, self.n + len(x))
        self.clear_ghosts()
        self.reserve(new.stop)
        rows = slice(new.start, new.stop)
        for name in _PER_ATOM:
            _clear(getattr(self, name)[rows])
        self.x[rows], self.type[rows], self.mask[rows] = x, type_, 1
        for name, array in self.extra.items():
            array[rows] = self.newcomers[name](self, rows) if name in self.newcomers else np.zeros((), array.dtype)
        self.n = new.stop
        return new

    def number(self) -> None:
        """Give every atom without an ID (0) the next one above the largest, in local order."""
        tags = self.tag[: self.n]
        nameless = tags == 0
        largest = int(tags.max()) if self.n else 0
        tags[nameless] = largest + 1 + np.arange(int(nameless.sum()))

    def permute(self, order: Ints) -> None:
        """Put owned atom order[k] at row k. Ghosts are forgotten."""
        self.clear_ghosts()
        for name in _PER_ATOM:
            array = getattr(self, name)
            if array[: self.n].any():
                array[: self.n] = array[: self.n][order]
        for array in self.extra.values():
            array[: self.n] = array[: self.n][order]

    def keep(self, order: Ints) -> None:
        """Keep owned atoms order (rows) in this order, drop the others. Ghosts are forgotten."""
        self.clear_ghosts()
        for name in _PER_ATOM:
            array = getattr(self, name)
            if array[: self.n].any():
                array[: len(order)] = array[order]
            else:
                _clear(array[: len(order)])
        for array in self.extra.values():
            array[: len(order)] = array[order]
        self.n = len(order)

    def drop(self, doomed: NDArray[np.bool_]) -> None:
        """Remove the doomed (n,) owned atoms as LAMMPS does: the last atom moves into the hole, and is looked at in its turn."""
        order = list(range(self.n))
        i = 0
        while i < len(order):
            if doomed[order[i]]:
                order[i] = order[-1]
                order.pop()
            else:
                i += 1
        self.keep(np.array(order, np.int64))

    def clear_ghosts(self) -> None:
        self.ghosts = 0

    def rows_by_tag(self) -> Ints:
        """(largest ID + 1,) owned row of each ID, -1 where there is none. Raises Unsupported for gigantic IDs."""
        rows = np.full(self.span(), -1, np.int64)
        rows[self.tag[: self.n][::-1]] = np.arange(self.n - 1, -1, -1)
        return rows

    def span(self) -> int:
        """Largest ID + 1: the size of a table of all IDs. Raises Unsupported for gigantic ones."""
        largest = int(self.tag[: self.n].max(initial=0))
        if largest > _LARGEST_ID:
            raise Unsupported(
                f"LAMMPS has atom IDs such as {largest}, pylmp's native engines do not", hint=f"IDs up to {_LARGEST_ID}", manual="atom_modify.html"
            )  # fmt: skip
        return largest + 1

    def slots(self, kind: str) -> int:
        """How many bonds (angles, ...) an atom can store."""
        return int(getattr(self, f"{kind}_type").shape[1])

    def widen(self, kind: str, slots: int) -> None:
        """Room for more bonds (angles, ...) per atom."""
        extra = slots - self.slots(kind)
        if extra <= 0:
            return
        if kind == "bond":
            self.widen_bonds(slots)
            return
        for name in (f"{kind}_type", f"{kind}_atom"):
            array = getattr(self, name)
            setattr(self, name, np.pad(array, ((0, 0), (0, extra), (0, 0))[: array.ndim]))

    def widen_bonds(self, bond_per_atom: int) -> None:
        """Room for more bond slots per atom."""
        extra = bond_per_atom - self.bond_per_atom
        if extra > 0:
            self.bond_type = np.pad(self.bond_type, ((0, 0), (0, extra)))
            self.bond_atom = np.pad(self.bond_atom, ((0, 0), (0, extra)))
            self.bond_history = np.pad(self.bond_history, ((0, 0), (0, extra), (0, 0)))
            self.bond_per_atom = bond_per_atom

    def set_history(self, width: int) -> None:
        """Give every bond slot width remembered numbers, all 0."""
        self.bond_history = np.zeros((self.capacity, self.bond_per_atom, width))

    def widen_special(self, max_special: int) -> None:
        extra = max_special - self.max_special
        if extra > 0:
            self.special = np.pad(self.special, ((0, 0), (0, extra)))
            self.max_special = max_special

    def drop_slot(self, row: int, slot: int, kind: str = "bond", remember: bool = True) -> None:
        """Remove a slot of an owned atom: the last slot, with what it remembers, moves into the hole.

        remember: false leaves what bonds remember where it is.
        """
        count, types, members = (getattr(self, name.format(kind)) for name in ("num_{}", "{}_type", "{}_atom"))
        last = int(count[row]) - 1
        types[row, slot] = types[row, last]
        members[row, slot] = members[row, last]
        if kind == "bond" and remember:
            self.bond_history[row, slot] = self.bond_history[row, last]
            self.bond_history[row, last] = 0.0
        count[row] = last


def check_count(count: int, most: int, what: str) -> None:
    """Raise ScriptError, LAMMPS's for want of memory, where arrays for count would be absurd."""
    if not 0 <= count <= most:
        says = f"Failed to allocate {8 * count} bytes for array atom:{what.split()[0]}"
        raise ScriptError(says, hint=f"{count} {what}: pylmp goes up to {most}")


def _grown(array: NDArray[np.generic], rows: int) -> NDArray[np.generic]:
    bigger = np.zeros((rows, *array.shape[1:]), array.dtype)
    if array.any():
        bigger[: len(array)] = array
    return bigger


def _clear(rows: NDArray[np.generic]) -> None:
    """Zeros, where there are others. What is only read takes no memory: of arrays that an atom style has no use for there is none."""
    if rows.any():
        rows[...] = 0
