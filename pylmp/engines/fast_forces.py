"""The force field of a fast run: one kernel for pairs and bonds, over eight atoms at a time."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.engines.fast_bonds import FastBonds
from pylmp.engines.fast_list import FullList
from pylmp.kernels.exact import neighbor as neighbor_loops
from pylmp.kernels.fast import FAR, blocks, nobody
from pylmp.kernels.fast import neighbor as loops
from pylmp.kernels.fast.driver import drive
from pylmp.kernels.fast.forces import TALLIES, PairTerm, force_loop
from pylmp.kernels.fast.renewal import hold, look_out, renew
from pylmp.kernels.simd import LANES
from pylmp.kernels.store import kernel, prepare
from pylmp.model.asking import ENERGY, VIRIAL
from pylmp.model.bondlist import store_reference
from pylmp.model.lost import check_bonded

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.simulation import Simulation

Call = Callable[[], float]
Step = tuple[Call, float, float]


class FastForces:
    """Kernels with and without tallies, bound to the arrays of the atoms.

    least, most: (3,) lowest and highest coordinates when last measured.
    bonds: the listing of the bond style, in a list as the exact engine has them; lists: the neighbor list, None without a pair law
    """

    def __init__(self, sim: Simulation) -> None:
        parts = sim.pair.working if sim.pair else []
        self.pair = parts[0] if parts and parts[0].settings.compute else None
        self.bonds = [FastBonds(sim, part) for part in (sim.bond.parts if sim.bond else [])]
        self.lists = FullList(sim) if self.pair is not None and sim.neighbor_cutoff > 0.0 else None
        term = PairTerm(self.pair.law, self.pair.width, self.pair.style.velocity, sim.atom_types == 1) if self.pair else None
        bond = self.bonds[0].term(sim, self.pair) if self.bonds else None
        self._kernels = [force_loop(term, bond, sim.box.periodic, tally) for tally in (False, True)]
        self._moved, self._extent, self._beyond = neighbor_loops.moved(), loops.extents(), look_out(sim.box.periodic)
        self._hold: Function = hold
        self._calls: list[Call] = []
        self._may_break = np.zeros(1, np.int64)
        self._reports = bool(self.bonds) and self.bonds[0].part.style.report is not None
        self._moved_call: Call = lambda: 0.0
        self._sums = np.zeros(TALLIES)
        self._kinds = np.zeros(0, np.int32)
        self.least, self.most = np.zeros(3), np.zeros(3)
        self._scratch = np.zeros(6 * LANES)
        self._length = np.zeros(3)
        self._held_box, self._moving_faces = sim.box.corners(), False
        self._nothing = np.zeros(1, np.int64), np.zeros(1, np.int32), np.zeros(1, np.uint8), np.zeros((8, 8))
        self._held, self._limit2 = np.zeros((0, 3)), np.zeros(1)
        self._laid_out = False  # types and bonds, for the rows as they now are

    def prepare(self, sim: Simulation, more: list[Function]) -> tuple[int, int]:
        """Compile what the store does not have, all at once, more included: how many kernels there are, how many were compiled."""
        functions = [*self._kernels, self._moved, self._extent, self._beyond, *sim.box.functions(), self._hold, renew, drive, *more]
        for listed in self.bonds:
            functions += listed.functions()
        if self.lists is not None:
            functions += self.lists.functions()
        for fix in sim.fixes:
            functions += fix.functions()
        return prepare(functions, sim.console.screen)

    def measure(self, sim: Simulation) -> None:
        """Find the lowest and highest coordinates."""
        if sim.atoms.n:
            self._measuring(sim)()

    def _measuring(self, sim: Simulation) -> Call:
        return kernel(self._extent).bind(sim.atoms.x, self._scratch, self.least, self.most, sim.atoms.n)

    def renewal(self, sim: Simulation) -> list[Step]:
        """What makes new lists for the same rows, bound as the last rebuild left it; nothing of it goes wrong twice when a rebuild follows."""
        atoms, box = sim.atoms, sim.box
        beyond = kernel(self._beyond).bind(self.least, self.most, box.lo, box.hi)
        always = [self._measuring(sim), beyond, box.wrapping(atoms), *(listed.forgetting() for listed in self.bonds)]
        holding = kernel(self._hold).bind(atoms.x, self._held, atoms.n)
        return [*((call, 0.0, 0.0) for call in always), *(self.lists.steps if self.lists else []), (holding, 0.0, 0.0)]

    def copy_back(self, sim: Simulation) -> None:
        for listed in self.bonds:
            listed.copy_back(sim)

    def moved_rows(self) -> None:
        """Atoms have changed places, or some are gone."""
        self._laid_out = False

    def rebuild(self, sim: Simulation) -> None:
        """A new neighbor list; bind the kernels to the arrays as they now are."""
        atoms, n = sim.atoms, sim.atoms.n
        atoms.reserve(nobody(n) + LANES)
        atoms.x[n : nobody(n)] = FAR
        atoms.x[nobody(n)] = -FAR
        atoms.v[n : nobody(n) + 1] = 0.0
        if not self._laid_out:
            self._laid_out = True
            self._kinds = np.ones(3 * atoms.capacity, np.int32)
            self._kinds[: 3 * n : 3] = atoms.type[:n]
            for listed in self.bonds:
                if not listed.part.stored:
                    store_reference(sim, listed.part)
                listed.build(sim)
        else:
            for listed in self.bonds:
                listed.forgetting()()
        if self.lists is not None:
            self.lists.build(sim, self.bonds[0].left_out if self.bonds else None, self.least, self.most)
        check_bonded(sim)
        if len(self._held) != n:
            self._held = np.zeros((n, 3))
        self._held[:] = atoms.x[:n]
        self._length[:] = sim.box.length
        self._held_box = sim.box.corners()
        self._moving_faces = sim.box.changing and any(sim.box.periodic[: sim.dimension])
        self._bind(sim)

    def _bind(self, sim: Simulation) -> None:
        atoms = sim.atoms
        lists, bonds = self.lists, self.bonds[0] if self.bonds else None
        whole, small, tiny, number = self._nothing
        table = self.pair.table if self.pair else number
        listing = (lists.first, lists.depth, lists.edges, lists.neighbors) if lists else (whole, small, tiny, small)
        listed = (
            (bonds.first, bonds.depth, bonds.to, bonds.kind, bonds.memories, bonds.slots, bonds.part.table)
            if bonds
            else (whole, small, small, small, number, 0, number)
        )
        self._calls = [
            kernel(function).bind(
                atoms.x, atoms.v, atoms.f, self._kinds, *listing, table, len(table), *listed, self._length, self._sums,
                *((bonds.broken, bonds.noted) if bonds else (small, small)), self._may_break, 0, blocks(atoms.n),
            )
            for function in self._kernels
        ]  # fmt: skip
        self._limit2[0] = 0.25 * sim.neighbor.skin * sim.neighbor.skin
        self._moved_call = kernel(self._moved).bind(atoms.x, self._held, self._limit2, atoms.n)

    # ---- every step -------------------------------------------------------------------------------------------

    def able(self, wanted: int) -> int:
        return wanted & (ENERGY | VIRIAL)

    def evaluate(self, sim: Simulation, wanted: int, setup: bool) -> None:
        """Forces, and what is wanted besides; then what breaks is booked."""
        if self._moving_faces:
            self._length[:] = sim.box.length
        self._may_break[0] = not setup or (bool(self.bonds) and self.bonds[0].part.style.breaks_in_setup)
        broken = int(self._calls[wanted != 0]())
        if wanted:
            sums = self._sums.tolist()
            sim.tally.pair, sim.tally.bond = sums[0] + sums[2], sums[1]
            sim.tally.pair_virial[:] = sums[3:9]
            sim.tally.bond_virial[:] = sums[9:]
        if self._reports:
            self.bonds[0].report(sim)
        if broken:
            self.book(sim, broken)

    def quiet(self) -> tuple[Call, Call] | None:
        """The test who has moved and the forces without tallies, bound; None: there is more to do in a step."""
        return None if self._reports or self._moving_faces else (self._moved_call, self._calls[0])

    def may_break(self) -> None:
        """From now on bonds may break."""
        self._may_break[0] = 1

    def book(self, sim: Simulation, count: int) -> None:
        """Bonds broke in the last evaluation: count slots."""
        self.bonds[0].book(sim, count)

    def anybody_moved(self, sim: Simulation) -> bool:
        """Has an atom moved more than half the skin, less what the faces moved, since the last build?"""
        if self._moving_faces:
            delta = max(0.5 * (sim.neighbor.skin - sim.box.travel(self._held_box)), 0.0)
            self._limit2[0] = delta * delta
        return self._moved_call() != 0.0
