"""The bonds of the fast engine: eight atoms side by side, each bond at both of its ends."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.fast import blocks
from pylmp.kernels.fast import bonds as loops
from pylmp.kernels.fast.choosing import few_types
from pylmp.kernels.fast.terms import BondTerm
from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES
from pylmp.kernels.store import kernel
from pylmp.kernels.team import PARTS
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.atoms import Floats, Ints
    from pylmp.model.bond import BondPart
    from pylmp.model.simulation import Simulation


class LeftOut:
    """Rows that are no neighbors of a row, because bonds join them: rows[first[i]:first[i + 1]] of row i."""

    def __init__(self) -> None:
        self.first = np.zeros(1, np.int64)
        self.rows = np.zeros(1, np.int32)
        self._leave = loops.leaving_out()

    def functions(self) -> list[Function]:
        return [self._leave]

    def build(self, sim: Simulation, nobody: bool, by_tag: Ints) -> None:
        """nobody: the list leaves them out by itself. by_tag: row of each ID."""
        if nobody:
            self.first = np.zeros(sim.atoms.n + 1, np.int64)
            return
        atoms = sim.atoms
        zero = (np.array(sim.special.lj) == 0.0).astype(np.uint8)
        self.first, self.rows = np.zeros(atoms.n + 1, np.int64), np.zeros(1, np.int32)
        while (count := int(self._into(sim, zero, by_tag)())) >= len(self.rows):
            self.rows = np.zeros(count + 1, np.int32)

    def _into(self, sim: Simulation, zero: NDArray[np.uint8], by_tag: Ints) -> Callable[[], float]:
        atoms = sim.atoms
        return kernel(self._leave).bind(
            atoms.num_special, atoms.special, atoms.max_special, zero, by_tag, len(by_tag), self.first, self.rows, len(self.rows), atoms.n,
        )  # fmt: skip


def closest_images(sim: Simulation, rows: Ints, partners: Ints) -> Ints:
    """For each of rows the closest row, ghosts included, of the atom of row partners."""
    atoms, total = sim.atoms, sim.atoms.total
    order = np.argsort(atoms.tag[:total], kind="stable")  # the atom itself before its ghosts
    tags = atoms.tag[:total][order]
    begin, end = (np.searchsorted(tags, atoms.tag[partners], side) for side in ("left", "right"))
    many = end - begin
    begins = np.cumsum(many) - many
    images = order[np.repeat(begin - begins, many) + np.arange(int(many.sum()))]
    d = atoms.x[np.repeat(rows, many)] - atoms.x[images]
    away = (d * d).sum(axis=1)
    best = np.lexsort((np.arange(len(away)), away, np.repeat(np.arange(len(rows)), many)))
    return np.asarray(images[best[begins]])


class FastBonds:
    """Slots of bonds, at first[b] + 8 k + lane: entry k of a row of block b.

    depth (blocks,) int32; to (slots,) int32: 3 x the other row; kind: type, 0 none, below 0 broken since the last list; owner: the row, -1
    nobody's. memories (memory x slots). fresh, misplaced: as of the exact engine's lists.
    """

    misplaced = None

    def __init__(self, sim: Simulation, part: BondPart, left_out: LeftOut) -> None:
        self.part = part
        self.memory, self.room = part.memory, sim.bond.memory
        self.fresh = False
        self.slots = 0
        self.left_out = left_out
        self._back = loops.copy_back(self.memory)
        zero = part.style.on_break == "zero"
        self._book = loops.booking(zero, self.memory, part.shifts, part.updates_special)
        self._clear = loops.clearing()
        self._count, self._lay = loops.counting(sim.newton_bond), loops.laying(sim.newton_bond, self.memory)
        self._allocate(0, 0)

    def functions(self) -> list[Function]:
        return [self._back, self._book, self._clear, self._count, self._lay]

    def term(self, sim: Simulation, alone: Function) -> BondTerm:
        """alone: the law of pairs that bonds take out again, None if there is no pair law."""
        part, style = self.part, self.part.style
        return BondTerm(
            part.law, part.table.shape[1], part.memory, style.velocity, few_types(sim.bond_types), style.reference, part.can_break,
            part.updates_special and alone is not None, alone if style.subtract_pair else None,
            part.watch,
        )  # fmt: skip

    def _allocate(self, slots: int, count: int) -> None:
        self.slots = slots
        room = slots + LANES
        self.to, self.kind, self.broken, self.noted = (np.zeros(room + PARTS, np.int32) for _ in range(4))
        self.owner, self.home = np.full(room, -1, np.int32), np.full(room, -1, np.int32)
        self.memories = np.zeros(max(1, self.memory) * slots + LANES)
        self.first, self.depth = np.zeros(count + 1, np.int64), np.zeros(count + 1, np.int32)

    def build(self, sim: Simulation, filler: int, by_tag: Ints) -> None:
        """New slots, from what the atoms store; filler: the row of nobody; by_tag: row of each ID. Raises ScriptError where a partner is nowhere."""
        atoms, n, count = sim.atoms, sim.atoms.n, blocks(sim.atoms.n)
        held, mine = np.zeros(LANES * count, np.int32), self.part.mine
        missing = kernel(self._count).bind(
            atoms.num_bond, atoms.bond_type, atoms.bond_atom, atoms.bond_per_atom, mine, by_tag, len(by_tag), held, n, sim.lost_bonds != "error",
        )()  # fmt: skip
        if missing <= loops.MISSING:
            row, slot = divmod(int(loops.MISSING - missing), atoms.bond_per_atom)
            raise ScriptError(
                f"Bond atoms {int(atoms.tag[row])} {int(atoms.bond_atom[row, slot])} missing on proc 0 at step {sim.step}",
                hint="an atom was lost: a smaller timestep, or a boundary that keeps it", manual="Errors_details.html",
            )  # fmt: skip
        depth = held.reshape(count, LANES).max(axis=1, initial=0)
        self._allocate(LANES * int(depth.sum()), count)
        self.depth[:count] = depth
        np.cumsum(LANES * depth, out=self.first[1:])
        self.to[:] = 3 * filler
        self.memories[: self.memory * self.slots] = 1.0
        held[:] = 0
        kernel(self._lay).bind(
            atoms.num_bond, atoms.bond_type, atoms.bond_atom, atoms.bond_history, atoms.bond_per_atom, mine, by_tag, len(by_tag), self.first, held,
            self.to, self.kind, self.owner, self.home, self.memories, self.slots, n,
        )()  # fmt: skip
        if atoms.ghosts:
            used = np.flatnonzero(self.owner >= 0)
            self.to[used] = 3 * closest_images(sim, self.owner[used].astype(np.int64), self.home[used].astype(np.int64))
        self.fresh = True

    def copy_back(self, sim: Simulation) -> None:
        """What bonds remember, to the slots of the atoms that store them."""
        atoms = sim.atoms
        if self.memory and self.slots:
            kernel(self._back).bind(
                atoms.tag, atoms.num_bond, atoms.bond_atom, atoms.bond_history, atoms.bond_per_atom, self.owner, self.to, self.kind,
                self.memories, self.slots,
            )()  # fmt: skip

    def forgetting(self) -> Callable[[], float]:
        """A call for when there is a new list: it has the atoms of broken bonds."""
        return kernel(self._clear).bind(self.kind, self.slots if self.part.updates_special else 0)

    def said_by(self, k: int, begin: int) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """Where the k-th part of the forces, which begins at block begin, says what broke, and what must be reported."""
        start = int(self.first[begin])
        return self.broken[start:], self.noted[start + k :]

    def collect(self, begins: list[int], counts: Ints) -> None:
        """What the parts said, counts slots of each broken, one behind the other as if it were one part."""
        broken = notes = 0
        for k, (begin, count) in enumerate(zip(begins, counts.tolist(), strict=True)):
            said, noted = self.said_by(k, begin)
            self.broken[broken : broken + count] = said[:count]
            broken += count
            more = int(noted[0])
            self.noted[1 + notes : 1 + notes + more] = noted[1 : 1 + more]
            notes += more
        self.noted[0] = notes

    def book(self, sim: Simulation, count: int) -> None:
        """Bookkeeping for count slots of broken, one at each end of a bond."""
        atoms, part = sim.atoms, self.part
        if part.recorder is not None:
            self._record(sim, self.broken[:count])
        kernel(self._book).bind(
            self.broken, count, self.owner, self.to, atoms.tag, atoms.num_bond, atoms.bond_type, atoms.bond_atom, atoms.bond_history,
            atoms.bond_per_atom, atoms.num_special, atoms.special, atoms.max_special, self.left_out.first, self.left_out.rows,
        )()  # fmt: skip
        gone = self.broken[:count]
        if part.updates_special:
            sim.lists.occasional.broke(sim, atoms.tag[np.stack([self.owner[gone], self.home[gone]])])
        if part.style.on_break != "zero":
            sim.bonds -= int(np.count_nonzero(self._lower(gone)))

    def report(self, sim: Simulation) -> None:
        """What the style says of the noted bonds: a warning, or a ScriptError. By rows, each bond once."""
        count = int(self.noted[0])
        if self.part.style.report is not None and count:
            at = self.noted[1 : 1 + count]
            at = at[self._lower(at)]
            at = at[np.argsort(self.owner[at], kind="stable")]
            self.part.style.report(sim, self.part, self._ends(at))

    def _record(self, sim: Simulation, broken: NDArray[np.int32]) -> None:
        broken = broken[np.argsort(np.minimum(self.owner[broken], self.home[broken]), kind="stable")]
        for p in broken:
            i, j = int(self.owner[p]), int(self.to[p]) // 3
            if sim.atoms.tag[i] < sim.atoms.tag[j]:
                self.part.recorder.record(sim, i, j)

    def _lower(self, at: NDArray[Any]) -> NDArray[np.bool_]:
        """Which of these slots, one at each end of a bond, are those at the lower row."""
        return np.asarray(self.owner[at] < self.home[at])

    # ---- as the exact engine's lists show themselves: each bond once ------------------------------------------------

    @property
    def _once(self) -> Ints:
        """Slots of bonds that hold, those at the lower row."""
        return np.flatnonzero((self.kind[: self.slots] > 0) & self._lower(np.arange(self.slots)))

    @property
    def count(self) -> int:
        return len(self._once)

    @property
    def bonds(self) -> Ints:
        """(count, 3) rows of both ends, type."""
        return self._ends(self._once)

    def _ends(self, at: NDArray[Any]) -> Ints:
        """(slots, 3) rows of both ends, type."""
        return np.stack([self.owner[at], self.to[at] // 3, self.kind[at]], axis=1).astype(np.int64)

    @property
    def history(self) -> Floats:
        """(count, numbers that bonds of any style remember)"""
        if not self.memory:
            return np.zeros((self.count, self.room))
        return self.memories[: self.memory * self.slots].reshape(self.memory, self.slots)[:, self._once].T
