"""Neighbor lists made from others after each rebuild: some types, or a shorter cutoff."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact import derived as loops
from pylmp.kernels.kinds import Function
from pylmp.kernels.store import kernel
from pylmp.model.atoms import Floats, Ints

if TYPE_CHECKING:
    from pylmp.model.neighbor import NeighborList
    from pylmp.model.simulation import Simulation


class DerivedList:
    """What another list has of some pairs; first, neighbors, policy as there."""

    def __init__(self, source: NeighborList | DerivedList, take: Function) -> None:
        self.source = source
        self.policy: Ints = source.policy
        self._take = take
        self.first = np.zeros(1, np.int64)
        self.neighbors = np.zeros(0, np.int32)

    def functions(self) -> list[Function]:
        return [self._take]

    @property
    def count(self) -> int:
        return int(self.first[-1])

    def build(self, sim: Simulation, ghost_cutoff: float) -> None:
        """After source was built."""
        source, n = self.source, sim.atoms.n
        if len(self.neighbors) < len(source.neighbors):
            self.neighbors = np.zeros(len(source.neighbors), np.int32)
        self.first = np.zeros(n + 1, np.int64)
        lists = source.first, source.neighbors, self.first, self.neighbors
        kernel(self._take).bind(*self.chosen(sim), *lists, n)()

    def chosen(self, sim: Simulation) -> tuple[object, ...]:
        """The kernel's first arguments."""
        raise NotImplementedError


class SkipList(DerivedList):
    def __init__(self, source: NeighborList | DerivedList, cut: Floats) -> None:
        """cut (nt+1, nt+1): pairs of types are taken where it is not 0."""
        super().__init__(source, loops.skipping())
        self._mine = (cut > 0.0).astype(np.uint8)

    def chosen(self, sim: Simulation) -> tuple[object, ...]:
        return sim.atoms.type, self._mine, len(self._mine)


class TrimList(DerivedList):
    def __init__(self, source: NeighborList | DerivedList, cutoff: float) -> None:
        super().__init__(source, loops.trimming())
        self._cut2 = cutoff * cutoff

    def chosen(self, sim: Simulation) -> tuple[object, ...]:
        return sim.atoms.x, self._cut2
