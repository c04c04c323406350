"""The neighbor list of fast runs with ghosts: the exact engine's, laid out in lanes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact.neighbor import FULL
from pylmp.kernels.fast import blocks
from pylmp.kernels.fast.layout import laying_out
from pylmp.kernels.fast.neighbor import SHORT
from pylmp.kernels.store import kernel
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.neighbor import NeighborList

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.simulation import Simulation


class GhostList:
    """A full list of the exact engine, laid side by side as FullList is. weights: of each entry, by its special kind."""

    full = whole = None

    def __init__(self, sim: Simulation) -> None:
        self._list = NeighborList(sim, FULL)
        self.weighted = sim.has_bonds and not set(sim.special.lj) <= {1.0}
        self._lay_out = laying_out(self.weighted)
        self.first, self.depth, self.edges = np.zeros(0, np.int64), np.zeros(0, np.int32), np.zeros(0, np.uint8)
        self.neighbors, self.weights = np.zeros(1024, np.int32), np.zeros(1024 if self.weighted else 1)

    def functions(self) -> list[Function]:
        return [*self._list.functions(), self._lay_out]

    @property
    def half(self) -> int:
        return self._list.count // 2

    def build(self, sim: Simulation, filler: int) -> None:
        """List the neighbors of all atoms; ghosts are there. filler: the row of nobody."""
        listed, n = self._list, sim.atoms.n
        listed.build(sim, ghost_cutoff(sim))
        count = blocks(n)
        if len(self.depth) != count:
            self.first, self.depth, self.edges = np.zeros(count, np.int64), np.zeros(count, np.int32), np.zeros(count, np.uint8)
        kinds = np.array([1.0, *sim.special.lj])
        while True:
            lacking = kernel(self._lay_out).bind(
                listed.first, listed.neighbors, kinds, self.first, self.depth, self.neighbors, self.weights, len(self.neighbors), filler, count, n
            )()
            if lacking != SHORT:
                break
            self.neighbors = np.zeros(2 * len(self.neighbors), np.int32)
            self.weights = np.zeros(len(self.neighbors) if self.weighted else 1)
