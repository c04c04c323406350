"""The pair forces of a run: each style's kernels over its neighbor list, one style after the other."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact.pair import pair_loop
from pylmp.kernels.store import kernel

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.neighbor import NeighborList
    from pylmp.model.pair import PairPart
    from pylmp.model.simulation import Simulation

Call = Callable[[], float]


class PartForces:
    """One style's kernels: forces alone, and with energy and virial.

    virial   (6,) of this part alone; with newton pair on, where it is summed over the forces of all, the last part has it
    noted    how many pairs the style wants reported, the rows of the first
    """

    def __init__(self, sim: Simulation, part: PairPart, neighbors: NeighborList, last: bool) -> None:
        self.part = part
        self.neighbors = neighbors
        self.weights = np.array([1.0, *sim.special.lj])
        self.virial = np.zeros(6)
        self.noted = np.zeros(3, np.int64)
        self.functions = {tally: self._compose(sim, tally, last) for tally in (False, True)}
        self.calls: dict[bool, Call] = {}

    def _compose(self, sim: Simulation, tally: bool, last: bool) -> Function:
        part, style = self.part, self.part.style
        weighted = bool((self.neighbors.policy == 2).any()) and sim.has_bonds
        return pair_loop(
            part.law, part.width, newton=sim.newton_pair, velocity=style.velocity, one_type=sim.atom_types == 1,
            weighted=weighted, tally=tally, tabled=style.data is not None, watch=style.watch, last=last,
        )  # fmt: skip

    def bind(self, sim: Simulation) -> None:
        atoms, part = sim.atoms, self.part
        self.calls = {
            tally: kernel(function).bind(
                atoms.x, atoms.v, atoms.f, atoms.type, self.neighbors.first, self.neighbors.neighbors, part.table,
                len(part.table), part.data, self.weights, self.virial, self.noted, atoms.n, atoms.total,
            )
            for tally, function in self.functions.items()
        }  # fmt: skip

    def evaluate(self, sim: Simulation, tally: bool) -> float:
        """Add this part's forces; its energy if tally. Raises ScriptError where the style cannot evaluate a pair."""
        self.virial[:] = 0.0
        energy = self.calls[tally]()
        if self.part.style.report is not None and self.noted[0]:
            self.part.style.report(sim, self.part, int(self.noted[1]), int(self.noted[2]))
        return energy


class PairForces:
    """energies: of each part of sim.pair, in order; virial (6,): of all. Both of the last evaluation that tallied."""

    def __init__(self, sim: Simulation, neighbors: NeighborList | None) -> None:
        self.virial = np.zeros(6)
        working = [part for part in sim.pair.parts if part.law is not None] if neighbors and sim.pair else []
        self.parts = [PartForces(sim, part, neighbors, part is working[-1]) for part in working if neighbors]

    def functions(self) -> list[Function]:
        return [function for part in self.parts for function in part.functions.values()]

    def bind(self, sim: Simulation) -> None:
        for part in self.parts:
            part.bind(sim)

    def evaluate(self, sim: Simulation, tally: bool) -> float:
        """Add the forces of all parts; the energy of all if tally."""
        total = 0.0
        self.virial[:] = 0.0
        for forces in self.parts:
            energy = forces.evaluate(sim, tally)
            total += energy
            self.virial += forces.virial
            forces.part.energy = energy
        return total
