"""The list of bonds that one style evaluates, with what each remembers, and what happens when bonds break."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.exact import INDEX_MASK
from pylmp.kernels.exact import bond as loops
from pylmp.kernels.kinds import Function
from pylmp.kernels.store import kernel
from pylmp.model.bond import BondPart, bond_pairs
from pylmp.model.bond_volumes import Volumes
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.ghosts import Ghosts
    from pylmp.model.pair_lists import PairLists
    from pylmp.model.simulation import Simulation


class Listing:
    """The bonds of some types, by rows: bonds (capacity, 3) int64, the two ends and the type (0: broken); history (capacity, memory).

    mine (bond types + 1,) uint8: types listed here. fresh: what bonds remember was not yet copied back to the slots.
    """

    def __init__(self, sim: Simulation, mine: NDArray[np.uint8]) -> None:
        self.mine = mine
        self.memory = sim.bond.memory
        self.count = 0
        self.fresh = False
        self.bonds = np.zeros((64, 3), np.int64)
        self.history = np.zeros((64, self.memory))
        self._list = loops.bond_list(sim.newton_bond, self.memory)
        self._back = loops.copy_back(self.memory)

    def functions(self) -> list[Function]:
        return [self._list, self._back] if self.memory else [self._list]

    def build(self, sim: Simulation, ghosts: Ghosts, tolerant: bool = False) -> None:
        """List the bonds; ghosts are there. Raises ScriptError when a partner is nowhere, unless tolerant."""
        atoms = sim.atoms
        while True:
            count = kernel(self._list).bind(
                atoms.x, atoms.tag, ghosts.first, ghosts.same, atoms.num_bond, atoms.bond_type, atoms.bond_atom,
                atoms.bond_history, atoms.bond_per_atom, self.mine, len(ghosts.first), self.bonds, self.history,
                atoms.n, len(self.bonds), int(tolerant),
            )()  # fmt: skip
            if count >= 0.0:
                break
            if count <= loops.LOST:
                self._complain(sim, int(loops.LOST - count), ghosts)
            self._grow(2 * len(self.bonds))
        self.count = int(count)
        self.fresh = True

    def _grow(self, rows: int) -> None:
        self.bonds = np.zeros((rows, 3), np.int64)
        self.history = np.zeros((rows, self.memory))

    def _complain(self, sim: Simulation, row: int, ghosts: Ghosts) -> None:
        atoms = sim.atoms
        for slot in range(int(atoms.num_bond[row])):
            partner, kind = int(atoms.bond_atom[row, slot]), int(atoms.bond_type[row, slot])
            if kind > 0 and self.mine[kind] and (partner >= len(ghosts.first) or ghosts.first[partner] < 0):
                raise ScriptError(
                    f"Bond atoms {int(atoms.tag[row])} {partner} missing on proc 0 at step {sim.step}",
                    hint="an atom was lost: a smaller timestep, or a boundary that keeps it", manual="Errors_details.html",
                )  # fmt: skip

    def copy_back(self, sim: Simulation) -> None:
        """What bonds remember, from the list to the slots of their owned ends; once only, as in LAMMPS, until the list is built anew.

        So a restart file written during a run costs what happens to the bonds from then to the next rebuild.
        """
        if not self.fresh:
            return
        self.fresh = False
        atoms = sim.atoms
        if self.memory and self.count:
            kernel(self._back).bind(
                atoms.tag, atoms.num_bond, atoms.bond_atom, atoms.bond_history, atoms.bond_per_atom, self.bonds,
                self.history, self.count, atoms.n,
            )()  # fmt: skip


class BondList(Listing):
    """The bonds that one style evaluates.

    broken   (capacity,) int64: room for the entries that break in one step
    noted    (1 + capacity,): how many of one evaluation its style wants reported, then these
    volumes  of atoms, if the style asks for them; own (capacity,): what it makes of them for each bond
    """

    def __init__(self, sim: Simulation, part: BondPart) -> None:
        super().__init__(sim, part.mine)
        self.part = part
        self.broken, self.noted = np.zeros(len(self.bonds), np.int64), np.zeros(len(self.bonds) + 1, np.int64)
        self.own = np.zeros(len(self.bonds))
        self.volumes = Volumes(sim, part) if part.style.volumes(part.options) else None
        self.misplaced: Listing | None = None

    def functions(self) -> list[Function]:
        return [*super().functions(), *(self.volumes.functions() if self.volumes else ())]

    def build(self, sim: Simulation, ghosts: Ghosts, tolerant: bool = False) -> None:
        self.misplaced = None
        super().build(sim, ghosts, tolerant)

    def _grow(self, rows: int) -> None:
        super()._grow(rows)
        self.broken, self.noted = np.zeros(rows, np.int64), np.zeros(rows + 1, np.int64)
        self.own = np.zeros(rows)

    def copy_back(self, sim: Simulation) -> None:
        if not (self.part.memory and self.part.style.evolves):
            return
        if self.misplaced is None:
            super().copy_back(sim)
            return
        self.misplaced.history[:] = 0.0
        self.misplaced.history[: self.count] = self.history[: self.count]
        self.misplaced.copy_back(sim)
        self.misplaced = None

    def misplace(self, sim: Simulation, ghosts: Ghosts) -> None:
        """Under hybrid, LAMMPS keeps what bpm/spring/plastic stores at the first evaluation in the order of the style's own list, and takes it back
        at the next rebuild as if it were in the order of all bonds: entry n of all bonds gets what entry n of the style's list
        remembers, and entries beyond get 0, so that their r0 is taken anew. Later rebuilds are right. Measured on LAMMPS 22 Jul 2025.
        """
        self.misplaced = Listing(sim, np.ones(sim.bond_types + 1, np.uint8))
        self.misplaced.build(sim, ghosts)


def store_reference(sim: Simulation, part: BondPart) -> None:
    """At the first evaluation ever: r0 of every slot is its length by minimum image, also of bonds of other styles."""
    part.stored = True
    rows, slots, partners = bond_pairs(sim, lambda kinds: kinds > 0)
    keep = partners >= 0
    rows, slots, partners = rows[keep], slots[keep], partners[keep]
    x = sim.atoms.x
    d = sim.box.minimum_image(x[rows] - x[partners])
    sim.atoms.bond_history[rows, slots] = 0.0
    sim.atoms.bond_history[rows, slots, 0] = np.sqrt(d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2])


class Breaks:
    """Pairs whose bond broke and that must become ordinary neighbors: flagged, in the current neighbor list on the next step, which
    may be one of the next run; pairs, in the special lists at the next rebuild or when the run ends."""

    def __init__(self) -> None:
        self.pairs: list[tuple[int, int]] = []
        self.flagged: list[tuple[int, int]] = []

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
                    self.flagged.append(self.pairs[-1])
            for row, partner in ends:
                used = int(atoms.num_bond[row])
                slots = (atoms.bond_atom[row, :used] == partner) & (atoms.bond_type[row, :used] > 0)
                if slots.any():
                    atoms.drop_slot(row, int(np.argmax(slots)), remember=part.shifts)

    def clear_flags(self, sim: Simulation, lists: PairLists | None, ghosts: Ghosts) -> None:
        """Pairs broken on the step before act from now on."""
        for neighbors in lists.all if lists else ():
            for pair in self.flagged:
                for tag, other in (pair, pair[::-1]):
                    row = int(ghosts.first[tag]) if tag < len(ghosts.first) else -1
                    if 0 <= row < sim.atoms.n:
                        entries = neighbors.neighbors[neighbors.first[row] : neighbors.first[row + 1]]
                        plain = entries & INDEX_MASK
                        found = sim.atoms.tag[plain] == other
                        entries[found] = plain[found]
        self.flagged.clear()

    def edit_special(self, sim: Simulation) -> None:
        """Take all recorded pairs out of the special lists."""
        atoms = sim.atoms
        if self.pairs:
            rows = atoms.rows_by_tag()
            for pair in dict.fromkeys(self.pairs):  # two bonds between the same atoms
                for tag, other in (pair, pair[::-1]):
                    row = int(rows[tag]) if tag < len(rows) else -1
                    if row < 0:
                        continue
                    near, used = int(atoms.num_special[row, 0]), int(atoms.num_special[row, 2])
                    found = np.flatnonzero(atoms.special[row, :near] == other)
                    if not len(found):  # the bond between them that broke later
                        raise ScriptError(
                            f"Special bond {tag} {other} not found", hint="a box wide enough that no two atoms are bonded twice"
                        )
                    k = int(found[0])
                    atoms.special[row, k : used - 1] = atoms.special[row, k + 1 : used]
                    atoms.num_special[row] = near - 1
        self.pairs.clear()
