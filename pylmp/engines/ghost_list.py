"""The neighbor list of fast runs with ghosts: the exact engine's, laid out in lanes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact import INDEX_MASK, SPECIAL_SHIFT
from pylmp.kernels.exact.neighbor import FULL
from pylmp.kernels.fast import blocks
from pylmp.kernels.simd import LANES
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
        self.first, self.depth, self.edges = np.zeros(0, np.int64), np.zeros(0, np.int32), np.zeros(0, np.uint8)
        self.neighbors, self.weights = np.zeros(1, np.int32), np.zeros(1)

    def functions(self) -> list[Function]:
        return self._list.functions()

    @property
    def half(self) -> int:
        return self._list.count // 2

    def build(self, sim: Simulation, filler: int) -> None:
        listed, n = self._list, sim.atoms.n
        listed.build(sim, ghost_cutoff(sim))
        count = blocks(n)
        held = np.zeros(LANES * count, np.int64)
        held[:n] = np.diff(listed.first)
        self.depth = held.reshape(count, LANES).max(axis=1).astype(np.int32)
        self.edges = np.zeros(count, np.uint8)
        slots = np.concatenate([[0], np.cumsum(LANES * self.depth.astype(np.int64))])
        self.first = slots[:-1]
        rows = np.repeat(np.arange(n), held[:n])
        nth = np.arange(listed.count) - np.repeat(listed.first[:-1], held[:n])
        at = slots[rows // LANES] + LANES * nth + rows % LANES
        entries = listed.neighbors[: listed.count]
        self.neighbors = np.full(int(slots[-1]) + LANES, 3 * filler, np.int32)
        self.neighbors[at] = 3 * (entries & INDEX_MASK)
        if self.weighted:
            self.weights = np.ones(len(self.neighbors))
            self.weights[at] = np.array([1.0, *sim.special.lj])[(entries >> SPECIAL_SHIFT) & 3]
