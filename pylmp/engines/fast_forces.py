"""The force field of a fast run: one kernel for pairs and bonds, over eight atoms at a time."""

from __future__ import annotations

from collections.abc import Callable
from itertools import chain
from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.engines.fast_bonds import FastBonds, LeftOut
from pylmp.engines.fast_compose import Composer, table_of
from pylmp.engines.fast_list import FullList, Step
from pylmp.engines.ghost_list import GhostList
from pylmp.kernels.exact import SHARES
from pylmp.kernels.exact import neighbor as neighbor_loops
from pylmp.kernels.fast import FAR, blocks, nobody
from pylmp.kernels.fast import neighbor as loops
from pylmp.kernels.fast.driver import drive
from pylmp.kernels.fast.forces import TALLIES
from pylmp.kernels.fast.renewal import hold, look_out, renew
from pylmp.kernels.simd import LANES
from pylmp.kernels.store import kernel, prepare
from pylmp.kernels.team import PARTS, cuts
from pylmp.model.asking import ENERGY, SHARED, VIRIAL, level_of, levels
from pylmp.model.bondlist import store_reference
from pylmp.model.lost import check_bonded

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.atoms import Floats
    from pylmp.model.pair import PairPart
    from pylmp.model.simulation import Simulation

Call = Callable[[], float]


def _of_last_run(sim: Simulation) -> FullList | None:
    lists = getattr(getattr(sim.lists, "forces", None), "lists", None)
    return lists if isinstance(lists, FullList) else None


class FastForces:
    """Kernels with and without tallies, bound to the arrays of the atoms.

    least, most: (3,) lowest and highest coordinates when last measured.
    bonds: the listing of the bond style, in a list as the exact engine has them; lists: the neighbor list, None without a pair law
    """

    def __init__(self, sim: Simulation, ghosts: bool = False) -> None:
        self._ghosts = ghosts
        self.left_out = LeftOut()
        self.bonds = [FastBonds(sim, part, self.left_out) for part in (sim.bond.parts if sim.bond else [])]
        listing = sim.pair is not None and sim.neighbor_cutoff > 0.0
        self.lists: Any = None
        if listing:
            self.lists = GhostList(sim) if ghosts else FullList(sim, _of_last_run(sim))
        self.parts = [part for part in sim.pair.working if part.settings.compute] if sim.pair and listing else []
        self._table, _ = table_of(self.parts)
        composer = Composer(sim, self.parts, self.bonds, self.lists, ghosts)
        self._kernels = {level: composer.loops(level) for level in levels(sim)}
        self._single = composer.of_each_pair_style() if len(self.parts) > 1 else []
        self._moved, self._extent, self._beyond = neighbor_loops.moved(), loops.extents(), look_out(sim.box.periodic)
        self._hold: Function = hold
        self._calls: dict[int, list[Call]] = {}
        self._part_calls: list[Call] = []
        self._shares = np.zeros((2, 0, SHARES))
        self._scrap = np.zeros((0, 3))
        self._may_break = np.zeros(1, np.int64)
        self._reports = any(listed.part.style.report is not None for listed in self.bonds)
        self._moved_call: Call = lambda: 0.0
        self._sums = np.zeros((max(1, len(self.bonds)), PARTS, TALLIES))
        self._part_sums = np.zeros((len(self._single), PARTS, TALLIES))
        self._kinds = np.zeros(0, np.int32)
        self.least, self.most = np.zeros(3), np.zeros(3)
        self._scratch = np.zeros(6 * LANES)
        self._length = np.zeros(3)
        self._held_box, self._moving_faces = sim.box.corners(), False
        self._nothing = np.zeros(1, np.int64), np.zeros(1, np.int32), np.zeros(1, np.uint8), np.zeros((8, 8))
        self._held, self._limit2 = np.zeros((0, 3)), np.zeros(1)
        self.by_tag = np.zeros(0, np.int64)  # row of each ID
        self._laid_out = False  # types and bonds, for the rows as they now are

    def prepare(self, sim: Simulation, more: list[Function]) -> tuple[int, int]:
        """Compile what the store does not have, all at once, more included: how many kernels there are, how many were compiled."""
        functions = [*chain(*self._kernels.values()), *self._single, self._moved, self._extent, self._beyond, *sim.box.functions(), self._hold]
        functions += [renew, drive, *sim.team.functions(), *more, *self.left_out.functions()]
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
        holding = sim.team.split(atoms.n, lambda a, b: kernel(self._hold).bind(atoms.x[a:], self._held[a:], b - a))
        return [*((call, 0.0, 0.0) for call in always), *(self.lists.steps if self.lists else []), (holding, 0.0, 0.0)]

    def copy_back(self, sim: Simulation) -> None:
        for listed in self.bonds:
            listed.copy_back(sim)

    def moved_rows(self) -> None:
        """Atoms have changed places, or some are gone."""
        self._laid_out = False

    def rebuild(self, sim: Simulation, cutoff: float = 0.0) -> None:
        """A new neighbor list; bind the kernels to the arrays as they now are. cutoff: of ghosts, whose rows are behind those of the atoms."""
        atoms, n, total = sim.atoms, sim.atoms.n, sim.atoms.total
        atoms.reserve(max(total, nobody(n)) + LANES)
        filler = self._fill(sim)
        if self._ghosts or not self._laid_out:
            self._laid_out = True
            self._kinds = np.ones(3 * atoms.capacity, np.int32)
            self._kinds[: 3 * total : 3] = atoms.type[:total]
            if self.bonds or not self._ghosts:
                self.by_tag = atoms.rows_by_tag()
            self.left_out.build(sim, self._ghosts, self.by_tag)
            for listed in self.bonds:
                if not listed.part.stored:
                    store_reference(sim, listed.part)
                listed.build(sim, filler, self.by_tag)
        else:
            for listed in self.bonds:
                listed.forgetting()()
        if self._ghosts and self.lists is not None:
            self.lists.build(sim, filler)
        elif self.lists is not None:
            self.lists.build(sim, self.left_out, self.least, self.most, self._kinds)
        check_bonded(sim)
        if len(self._held) != n:
            self._held = np.zeros((n, 3))
        self._held[:] = atoms.x[:n]
        self._length[:] = sim.box.length
        self._held_box = sim.box.corners()
        self._moving_faces = sim.box.changing and any(sim.box.periodic[: sim.dimension])
        self.bind(sim)

    @staticmethod
    def _fill(sim: Simulation) -> int:
        """Rows behind the atoms: far from everybody, one of them, which is returned, from the others too."""
        atoms = sim.atoms
        filler = max(atoms.total, nobody(atoms.n))
        atoms.x[atoms.total : filler] = FAR
        atoms.x[filler] = -FAR
        atoms.v[atoms.total : filler + 1] = 0.0
        return filler

    def alone(self, sim: Simulation) -> None:
        """Guests of computes (engines/guests.py) leave the rows behind the atoms."""
        if sim.atoms.ghosts and not self._ghosts:
            sim.atoms.clear_ghosts()
            self._fill(sim)

    def bind(self, sim: Simulation) -> None:
        """Bind the kernels to the arrays as they now are."""
        atoms = sim.atoms
        rows = nobody(atoms.n)
        if 2 in self._kernels and self._shares.shape[1] != rows:
            self._shares = np.zeros((2, rows, SHARES))
        if self._single and len(self._scrap) < rows + 1:
            self._scrap = np.zeros((rows + 1, 3))
        self._calls = {
            level: [self.bound(sim, level, function, k, self._sums[k], atoms.f) for k, function in enumerate(functions)]
            for level, functions in self._kernels.items()
        }
        self._part_calls = [
            self.bound(sim, 1, function, 0, sums, self._scrap, part) for function, sums, part in zip(self._single, self._part_sums, self.parts, strict=False)
        ]
        self._limit2[0] = 0.25 * sim.neighbor.skin * sim.neighbor.skin
        self._moved_call = sim.team.split(atoms.n, lambda a, b: kernel(self._moved).bind(atoms.x[a:], self._held[a:], self._limit2, b - a))

    def bound(self, sim: Simulation, level: int, function: Function, k: int, sums: Floats, f: Floats, part: PairPart | None = None) -> Call:
        """The k-th loop of a level, bound, its parts a job of the team; part: of this pair style alone."""
        atoms, lists, bonds = sim.atoms, self.lists, self.bonds[k] if self.bonds else None
        whole, small, tiny, number = self._nothing
        listing = (lists.first, lists.depth, lists.edges, lists.neighbors, lists.weights) if lists else (whole, small, tiny, small, number)
        table = self._table if part is None else part.table
        listed = (
            (bonds.first, bonds.depth, bonds.to, bonds.kind, bonds.memories, bonds.slots, bonds.part.table)
            if bonds
            else (whole, small, small, small, number, 0, number)
        )
        calls = []
        for p, (begin, end) in enumerate(self._cut(sim, level)):
            said = bonds.said_by(p, begin) if bonds else (small, small)
            calls.append(kernel(function).bind(
                atoms.x, atoms.v, f, self._kinds, *listing, table, len(table), *listed, self._length, sums[p], *self._shares, *said,
                self._may_break, begin, end,
            ))  # fmt: skip
        return sim.team.job(calls)

    @staticmethod
    def _cut(sim: Simulation, level: int) -> list[tuple[int, int]]:
        """Blocks of each part of a loop. Where it sums something the parts are the same for any number of threads."""
        count = blocks(sim.atoms.n)
        return cuts(count, LANES) if level or sim.team.threads > 1 else [(0, count)]

    # ---- every step -------------------------------------------------------------------------------------------

    def able(self, wanted: int) -> int:
        """What of wanted this run can sum: shares of atoms only if a compute asked for them when it was set up, as in LAMMPS."""
        return wanted if SHARED in self._kernels else wanted & (ENERGY | VIRIAL)

    def evaluate(self, sim: Simulation, wanted: int, setup: bool) -> None:
        """Forces, and what is wanted besides; then what breaks is booked."""
        self.alone(sim)
        if self._moving_faces:
            self._length[:] = sim.box.length
        if len(self.parts) > 1:  # fix adapt may have changed coefficients
            self._table[:] = np.concatenate([part.table for part in self.parts], axis=2)
        level = level_of(wanted) if wanted else 0
        for call in self._part_calls if level else ():  # before bonds break
            call()
        for k, call in enumerate(self._calls[level]):
            listed = self.bonds[k] if self.bonds else None
            self._may_break[0] = not setup or (listed is not None and listed.part.style.breaks_in_setup)
            broken = int(call())
            if listed is not None and listed.part.style.report is not None:
                self._collect(sim, level, k)
                listed.report(sim)
            if broken:
                self.book(sim, broken, k, level)
        if level:
            self._sum(sim, level)

    def _sum(self, sim: Simulation, level: int) -> None:
        if level == SHARED:
            n = sim.atoms.n
            sim.tally.pair_shares, sim.tally.bond_shares = shares = self._shares[:, :n].copy()
            (pair, *pair_virial), (bond, *bond_virial) = shares.sum(axis=1).tolist()
        else:
            sums = self._sums.sum(axis=(0, 1)).tolist()
            pair, bond, pair_virial, bond_virial = sums[0] + sums[2], sums[1], sums[3:9], sums[9:]
        sim.tally.pair, sim.tally.bond = pair, bond
        sim.tally.pair_virial[:] = pair_virial
        sim.tally.bond_virial[:] = bond_virial
        for part, energy in zip(self.parts, self._part_sums[:, :, 0].sum(axis=1).tolist() if self._single else [self._sums[0, :, 0].sum()], strict=False):
            part.energy = float(energy)

    def quiet(self) -> tuple[Call, Call] | None:
        """The test who has moved and the forces without tallies, bound; None: there is more to do in a step."""
        calls = self._calls[0]
        return None if self._reports or self._moving_faces or len(calls) > 1 else (self._moved_call, calls[0])

    def may_break(self) -> None:
        """From now on bonds may break."""
        self._may_break[0] = 1

    def book(self, sim: Simulation, count: int, k: int = 0, level: int = 0) -> None:
        """Bonds of the k-th style broke in the last evaluation, at this level: count slots."""
        if self.bonds[k].part.style.report is None:
            self._collect(sim, level, k)
        self.bonds[k].book(sim, count)

    def _collect(self, sim: Simulation, level: int, k: int) -> None:
        """What the parts of the last job say of bonds, in one list."""
        begins = [begin for begin, _ in self._cut(sim, level)]
        if len(begins) > 1:
            self.bonds[k].collect(begins, sim.team.results[: len(begins)].astype(np.int64))

    def anybody_moved(self, sim: Simulation) -> bool:
        """Has an atom moved more than half the skin, less what the faces moved, since the last build?"""
        if self._moving_faces:
            delta = max(0.5 * (sim.neighbor.skin - sim.box.travel(self._held_box)), 0.0)
            self._limit2[0] = delta * delta
        return self._moved_call() != 0.0
