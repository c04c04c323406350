"""The force field of a run: kernels composed for its scene, bound to its arrays."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.engines.pair_forces import PairForces
from pylmp.kernels.exact import SHARES
from pylmp.kernels.exact import neighbor as neighbor_loops
from pylmp.kernels.exact.bond import bond_loop
from pylmp.kernels.store import kernel, prepare
from pylmp.model.asking import ENERGY, SHARED, VIRIAL, level_of, levels
from pylmp.model.bondlist import BondList, Breaks, store_reference
from pylmp.model.lost import check_bonded
from pylmp.model.pair_lists import PairLists

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.bond import BondPart
    from pylmp.model.ghosts import Ghosts
    from pylmp.model.simulation import Simulation

Call = Callable[[], float]


class ForceField:
    """Kernels of each style by level (model/asking.py): forces alone, and more for the steps that ask for it."""

    def __init__(self, sim: Simulation, ghosts: Ghosts) -> None:
        self.ghosts = ghosts
        self.lists = PairLists(sim) if sim.pair and sim.neighbor_cutoff > 0.0 else None
        self.bonds = [BondList(sim, part) for part in sim.bond.parts] if sim.bond else []
        self._pairs = PairForces(sim, self.lists)
        taken = any(listed.part.style.subtract_pair for listed in self.bonds)
        self._alone = sim.pair.alone() if taken else None
        self._bond = [
            {level: self._compose_bond(sim, listed.part, level) for level in levels(sim)} for listed in self.bonds
        ]
        self._moved = neighbor_loops.moved()
        self._bond_calls: list[dict[tuple[int, bool], Call]] = []
        self._moved_call: Call = lambda: 0.0
        self._moving_faces = False
        self._forces = np.zeros((0, 3))
        self._sums = np.zeros(2)
        self._virial = np.zeros(6)
        self._shares = np.zeros((0, SHARES))
        self._held = np.zeros((0, 3))
        self._held_box = sim.box.corners()
        self._limit2 = np.zeros(1)

    def prepare(self, sim: Simulation, more: list[Function]) -> tuple[int, int]:
        """Compile what the store does not have, all at once, more included: how many kernels there are, how many were compiled."""
        functions = [*sim.box.functions(), *self.ghosts.functions(), self._moved, *more]
        if self.lists:
            functions += self.lists.functions()
        functions += self._pairs.functions()
        for listed, mine in zip(self.bonds, self._bond, strict=True):
            functions += [*listed.functions(), *mine.values()]
        for fix in sim.fixes:
            functions += fix.functions()
        return prepare(functions, sim.console.screen)

    def _compose_bond(self, sim: Simulation, part: BondPart, level: int) -> Function:
        style = part.style
        alone = self._alone if style.subtract_pair else None
        return bond_loop(
            part.law, part.table.shape[1], part.memory, alone.law if alone else None, alone.width if alone else 0,
            newton=sim.newton_bond, velocity=style.velocity or (alone is not None and alone.velocity),
            lower_id_first=style.lower_id_first, reference=style.reference, can_break=part.can_break,
            one_type=sim.bond_types == 1, tally=level > 0, tabled=part.tabled, individual=style.volumes(part.options), watch=part.watch, share=level > 1,
        )  # fmt: skip

    # ---- after each rebuild -----------------------------------------------------------------------------------

    def rebuild(self, sim: Simulation, cutoff: float) -> None:
        """New lists; remember where the atoms stood; bind the kernels to the arrays as they now are."""
        atoms = sim.atoms
        if self.lists is not None:
            self.lists.build(sim, cutoff)
        for listed in self.bonds:
            first = not listed.part.stored
            if first:
                store_reference(sim, listed.part)
            listed.build(sim, self.ghosts, sim.lost_bonds != "error")
            if first and len(self.bonds) > 1 and listed.part.style.misplaces:
                listed.misplace(sim, self.ghosts)
        check_bonded(sim)
        if len(self._held) != atoms.n:
            self._held = np.zeros((atoms.n, 3))
        self._held[:] = atoms.x[: atoms.n]
        self._held_box = sim.box.corners()
        self._bind(sim)

    def _bind(self, sim: Simulation) -> None:
        atoms = sim.atoms
        self._pairs.bind(sim)
        alone = self._alone
        table, data = (alone.table, alone.data) if alone else (np.zeros((0, 0, 0)), np.zeros(0))
        rows = atoms.total if self._pairs.shared else 0
        if len(self._shares) != rows:
            self._shares = np.zeros((rows, SHARES))
        for listed in self.bonds:
            if listed.volumes:
                listed.volumes.bind(sim, listed)
        self._bond_calls = [
            {
                (level, may_break): kernel(functions[level]).bind(
                    atoms.x, atoms.v, atoms.f, atoms.tag, atoms.type, listed.bonds, listed.history, listed.count,
                    listed.part.table, listed.part.data, listed.own, table, data, len(table), self._sums, self._virial,
                    self._pairs.virial, self._shares, self._pairs.shares, listed.broken, listed.noted, int(may_break), atoms.n,
                )
                for level in functions
                for may_break in (False, True)
            }
            for listed, functions in zip(self.bonds, self._bond, strict=True)
        ]  # fmt: skip
        self._forces = atoms.f[: atoms.total]
        self._limit2[0] = 0.25 * sim.neighbor.skin * sim.neighbor.skin
        self._moving_faces = sim.box.changing and any(sim.box.periodic[: sim.dimension])
        self._moved_call = kernel(self._moved).bind(atoms.x, self._held, self._limit2, atoms.n)

    # ---- every step -------------------------------------------------------------------------------------------

    def clear(self) -> None:
        self._forces.fill(0.0)

    def able(self, wanted: int) -> int:
        """What of wanted this run can sum: shares of atoms only if a compute asked for them when it was set up, as in LAMMPS."""
        return wanted if self._pairs.shared else wanted & (ENERGY | VIRIAL)

    def pairs(self, sim: Simulation, wanted: int, setup: bool) -> None:
        """wanted: what to sum besides forces (ENERGY | VIRIAL | ...), 0 for nothing."""
        self._pairs.evaluate(sim, level_of(wanted) if wanted else 0, setup)

    def bonded(self, sim: Simulation, wanted: int, setup: bool, breaks: Breaks) -> None:
        """Bonds of each style in turn; then what breaks is booked. For forces alone no sums are touched."""
        if not wanted:
            for listed, calls in zip(self.bonds, self._bond_calls, strict=True):
                self._precede(sim, listed)
                self._follow(sim, listed, calls[0, not setup or listed.part.style.breaks_in_setup](), breaks)
            return
        energy = 0.0
        self._sums[1] = self._pairs.energy
        virial = np.zeros(6)
        level = level_of(wanted)
        shares = np.zeros_like(self._shares)
        for listed, calls in zip(self.bonds, self._bond_calls, strict=True):
            self._virial[:] = 0.0
            self._shares[:] = 0.0
            self._precede(sim, listed)
            broken = calls[level, not setup or listed.part.style.breaks_in_setup]()
            energy += self._sums[0]
            virial += self._virial
            if level == SHARED:
                shares += self._shares
            self._follow(sim, listed, broken, breaks)
        self._pairs.energy = float(self._sums[1])
        sim.tally.pair, sim.tally.bond = float(self._sums[1]), float(energy)
        sim.tally.pair_virial[:] = self._pairs.virial.tolist()
        sim.tally.bond_virial[:] = virial.tolist()
        if level == SHARED:
            sim.tally.pair_shares, sim.tally.bond_shares = self._pairs.shares.copy(), shares

    def _precede(self, sim: Simulation, listed: BondList) -> None:
        """What an evaluation of bonds needs."""
        if listed.volumes:
            listed.volumes.measure(sim, self.ghosts)

    def _follow(self, sim: Simulation, listed: BondList, broken: float, breaks: Breaks) -> None:
        """What follows from an evaluation of bonds: reports of a style, broken bonds."""
        if listed.part.style.report is not None and (notes := int(listed.noted[0])):
            listed.part.style.report(sim, listed.part, listed.bonds[listed.noted[1 : 1 + notes]])
        if broken:
            breaks.record(sim, listed, int(broken))
            if listed.volumes:
                listed.volumes.lose(sim, self.ghosts, listed, int(broken))

    def anybody_moved(self, sim: Simulation) -> bool:
        """Has an atom moved more than half the skin, less what the faces moved, since the last build?"""
        if self._moving_faces:
            delta = max(0.5 * (sim.neighbor.skin - sim.box.travel(self._held_box)), 0.0)
            self._limit2[0] = delta * delta
        return self._moved_call() != 0.0
