"""The list of bonds that one style evaluates, with what each remembers, and what happens when bonds break."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact import INDEX_MASK
from pylmp.kernels.exact import bond as loops
from pylmp.kernels.kinds import Function
from pylmp.kernels.store import kernel
from pylmp.model.bond import BondPart, bond_pairs
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.ghosts import Ghosts
    from pylmp.model.neighbor import NeighborList
    from pylmp.model.simulation import Simulation


class BondList:
    """bonds (capacity, 3) int64: rows of the two ends and the type (0: broken); history (capacity, memory)."""

    def __init__(self, sim: Simulation, part: BondPart | _Everything) -> None:
        self.part = part
        self.count = 0
        self.misplaced: BondList | None = None
        self.bonds = np.zeros((64, 3), np.int64)
        self.history = np.zeros((64, sim.bond.memory))
        self.broken = np.zeros(64, np.int64)
        self._list = loops.bond_list(sim.newton_bond, sim.bond.memory)
        self._back = loops.copy_back(sim.bond.memory)

    def functions(self) -> list[Function]:
        return [self._list, self._back] if self.part.memory else [self._list]

    def build(self, sim: Simulation, ghosts: Ghosts, tolerant: bool = False) -> None:
        """List the bonds; ghosts are there. Raises ScriptError when a partner is nowhere."""
        self.misplaced = None
        atoms = sim.atoms
        while True:
            count = kernel(self._list).bind(
                atoms.x, atoms.tag, ghosts.first, ghosts.same, atoms.num_bond, atoms.bond_type, atoms.bond_atom,
                atoms.bond_history, atoms.bond_per_atom, self.part.mine, len(ghosts.first), self.bonds, self.history,
                atoms.n, len(self.bonds), int(tolerant),
            )()  # fmt: skip
            if count >= 0.0:
                break
            if count <= loops.LOST:
                self._complain(sim, int(loops.LOST - count), ghosts)
            rows = 2 * len(self.bonds)
            self.bonds = np.zeros((rows, 3), np.int64)
            self.history = np.zeros((rows, self.history.shape[1]))
            self.broken = np.zeros(rows, np.int64)
        self.count = int(count)

    def _complain(self, sim: Simulation, row: int, ghosts: Ghosts) -> None:
        atoms = sim.atoms
        for slot in range(int(atoms.num_bond[row])):
            partner = int(atoms.bond_atom[row, slot])
            if partner >= len(ghosts.first) or ghosts.first[partner] < 0:
                raise ScriptError(
                    f"Bond atoms {int(atoms.tag[row])} {partner} missing on proc 0 at step {sim.step}",
                    hint="an atom was lost: a smaller timestep, or a boundary that keeps it", manual="Errors_details.html",
                )  # fmt: skip

    def copy_back(self, sim: Simulation) -> None:
        """What bonds remember, from the list to the slots of their owned ends."""
        if self.misplaced is not None:
            self.misplaced.history[:] = 0.0
            self.misplaced.history[: self.count] = self.history[: self.count]
            self.misplaced.copy_back(sim)
            self.misplaced = None
            return
        atoms = sim.atoms
        if self.part.memory and self.count:
            kernel(self._back).bind(
                atoms.tag, atoms.num_bond, atoms.bond_atom, atoms.bond_history, atoms.bond_per_atom, self.bonds,
                self.history, self.count, atoms.n,
            )()  # fmt: skip

    def store_reference(self, sim: Simulation) -> None:
        """At the first evaluation ever: r0 of every slot is its length by minimum image, everything else 0."""
        self.part.stored = True
        mine = self.part.mine.astype(bool)
        rows, slots, partners = bond_pairs(sim, lambda kinds: (kinds > 0) & mine[np.maximum(kinds, 0)])
        keep = partners >= 0
        rows, slots, partners = rows[keep], slots[keep], partners[keep]
        x = sim.atoms.x
        d = sim.box.minimum_image(x[rows] - x[partners])
        sim.atoms.bond_history[rows, slots] = 0.0
        sim.atoms.bond_history[rows, slots, 0] = np.sqrt(d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2])


@dataclass(frozen=True)
class _Everything:
    """Stands for a style that owns every bond type."""

    mine: np.ndarray[tuple[int], np.dtype[np.uint8]]
    memory: int


def misplace(sim: Simulation, listed: BondList, ghosts: Ghosts) -> None:
    """Under hybrid, LAMMPS keeps what it stores at the first evaluation in the order of the style's own list, and takes it back at
    the next rebuild as if it were in the order of all bonds: entry n of all bonds gets what entry n of the style's list remembers,
    and entries beyond get 0, so that their r0 is taken anew. Later rebuilds are right. Measured on LAMMPS 22 Jul 2025."""
    types = np.ones(sim.bond_types + 1, np.uint8)
    whole = BondList(sim, _Everything(types, sim.bond.memory))
    whole.build(sim, ghosts)
    listed.misplaced = whole


class Breaks:
    """Pairs whose bond broke and that must become ordinary neighbors: in the current neighbor list on the next step, in
    the special lists at the next rebuild."""

    def __init__(self) -> None:
        self.pairs: list[tuple[int, int]] = []
        self.cleared = 0

    def record(self, sim: Simulation, listed: BondList, count: int) -> None:
        """Bookkeeping for the first count entries of listed.broken, in order."""
        atoms, part = sim.atoms, listed.part
        for entry in listed.broken[:count]:
            i, j = int(listed.bonds[entry, 0]), int(listed.bonds[entry, 1])
            if part.style.lower_id_first and atoms.tag[j] < atoms.tag[i]:
                i, j = j, i
            ends = [(a, int(atoms.tag[b])) for a, b in ((i, j), (j, i)) if a < atoms.n]
            if part.style.on_break == "zero":
                for row, partner in ends:
                    slots = atoms.bond_atom[row, : atoms.num_bond[row]] == partner
                    atoms.bond_type[row, : atoms.num_bond[row]][slots] = 0
                continue
            if i < atoms.n or sim.newton_bond:
                sim.bonds -= 1
                if part.recorder is not None:
                    part.recorder.record(sim, i, j)
            if part.updates_special:
                self.pairs.append((int(atoms.tag[i]), int(atoms.tag[j])))
            for row, partner in ends:
                used = int(atoms.num_bond[row])
                slots = (atoms.bond_atom[row, :used] == partner) & (atoms.bond_type[row, :used] > 0)
                if slots.any():
                    atoms.drop_slot(row, int(np.argmax(slots)))

    def clear_flags(self, sim: Simulation, neighbors: NeighborList | None, ghosts: Ghosts) -> None:
        """Pairs broken on the step before act from now on."""
        if neighbors is not None:
            for pair in self.pairs[self.cleared :]:
                for tag, other in (pair, pair[::-1]):
                    row = int(ghosts.first[tag]) if tag < len(ghosts.first) else -1
                    if 0 <= row < sim.atoms.n:
                        entries = neighbors.neighbors[neighbors.first[row] : neighbors.first[row + 1]]
                        plain = entries & INDEX_MASK
                        found = sim.atoms.tag[plain] == other
                        entries[found] = plain[found]
        self.cleared = len(self.pairs)

    def edit_special(self, sim: Simulation) -> None:
        """Take all recorded pairs out of the special lists."""
        atoms = sim.atoms
        if self.pairs:
            rows = atoms.rows_by_tag()
            for pair in self.pairs:
                for tag, other in (pair, pair[::-1]):
                    row = int(rows[tag]) if tag < len(rows) else -1
                    if row < 0:
                        continue
                    near, used = int(atoms.num_special[row, 0]), int(atoms.num_special[row, 2])
                    found = np.flatnonzero(atoms.special[row, :near] == other)
                    if len(found):
                        k = int(found[0])
                        atoms.special[row, k : used - 1] = atoms.special[row, k + 1 : used]
                        atoms.num_special[row] = near - 1
        self.pairs.clear()
        self.cleared = 0
