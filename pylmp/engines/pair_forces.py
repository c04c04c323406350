"""The pair forces of a run: each style's kernels over its neighbor list, one style after the other."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact import SHARES
from pylmp.kernels.exact.pair import pair_loop
from pylmp.kernels.store import kernel
from pylmp.model.asking import SHARED, levels

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.pair import PairPart
    from pylmp.model.pair_lists import AnyList, PairLists
    from pylmp.model.simulation import Simulation

Call = Callable[[], float]


class PartForces:
    """One style's kernels by level (model/settings.py): forces alone, with energy and virial, with the atoms' shares of them.

    virial   (6,) of this part alone; with newton pair on, where it is summed over the forces of all, the last part has it
    shares   (rows, 7) of this part alone: energy and virial of each atom
    noted    how many pairs the style wants reported, the rows of the first
    """

    def __init__(self, sim: Simulation, part: PairPart, neighbors: AnyList, last: bool) -> None:
        self.part = part
        self.neighbors = neighbors
        self.weights = np.array([1.0, *(part.settings.lj or sim.special.lj)])
        self.virial = np.zeros(6)
        self.noted = np.zeros(3, np.int64)
        self.shares = np.zeros((0, SHARES))
        self.functions = {level: self._compose(sim, level, last) for level in levels(sim)}
        self.calls: dict[int, Call] = {}

    def _compose(self, sim: Simulation, level: int, last: bool) -> Function:
        part, style = self.part, self.part.style
        weighted = bool((self.neighbors.policy == 2).any()) and sim.has_bonds
        return pair_loop(
            part.law, part.width, newton=sim.newton_pair, velocity=style.velocity, one_type=sim.atom_types == 1,
            weighted=weighted, tally=level > 0, tabled=style.data is not None, watch=part.watch, last=last, share=level > 1,
            fdotr=sim.pair.settings.fdotr,
        )  # fmt: skip

    def bind(self, sim: Simulation) -> None:
        atoms, part = sim.atoms, self.part
        rows = atoms.total if SHARED in self.functions else 0
        if len(self.shares) != rows:
            self.shares = np.zeros((rows, SHARES))
        self.calls = {
            level: kernel(function).bind(
                atoms.x, atoms.v, atoms.f, atoms.type, self.neighbors.first, self.neighbors.neighbors, part.table,
                len(part.table), part.data, self.weights, self.virial, self.shares, self.noted, atoms.n, atoms.total,
            )
            for level, function in self.functions.items()
        }  # fmt: skip

    def evaluate(self, sim: Simulation, level: int) -> float:
        """Add this part's forces; its energy from level 1 on. Raises ScriptError where the style cannot evaluate a pair."""
        if level:
            self.virial[:] = 0.0
            if level == SHARED:
                self.shares[:] = 0.0
        energy = self.part.energy = self.calls[level]()
        if self.part.style.report is not None and self.noted[0]:
            self.part.style.report(sim, self.part, int(self.noted[1]), int(self.noted[2]))
        return energy


class PairForces:
    """energy, virial (6,), shares (rows, 7): of all parts, of the last evaluation that summed them."""

    def __init__(self, sim: Simulation, lists: PairLists | None) -> None:
        self.energy = 0.0
        self.virial = np.zeros(6)
        self.shares = np.zeros((0, SHARES))
        self.shared = SHARED in levels(sim)
        working = [part for part in sim.pair.working if part.settings.compute] if lists else []
        self.parts = [PartForces(sim, part, lists.of(part), part is working[-1]) for part in working if lists]

    def functions(self) -> list[Function]:
        return [function for part in self.parts for function in part.functions.values()]

    def bind(self, sim: Simulation) -> None:
        for part in self.parts:
            part.bind(sim)
        rows = sim.atoms.total if self.shared else 0
        if len(self.shares) != rows:
            self.shares = np.zeros((rows, SHARES))

    def evaluate(self, sim: Simulation, level: int, setup: bool) -> None:
        """Add the forces of all parts; their energies from level 1 on.

        Under `pair_modify compute no` LAMMPS lets its sums stand, except in set-up: what bond_style quartic takes out adds up.
        """
        if sim.pair is not None and not sim.pair.acts and not setup:
            return
        self.energy = 0.0
        if not level:
            for forces in self.parts:
                forces.evaluate(sim, 0)
            return
        self.virial[:] = 0.0
        self.shares[:] = 0.0
        for forces in self.parts:
            energy = forces.evaluate(sim, level)
            self.energy += energy
            self.virial += forces.virial
            if level == SHARED:
                self.shares += forces.shares
