"""Neighbor lists that computes ask for now and then: built when first used after a rebuild of the run's own list, from the
positions of that moment, as in LAMMPS."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact import INDEX_MASK, SPECIAL_SHIFT
from pylmp.kernels.exact.neighbor import FULL, HALF, HALF_OWNED
from pylmp.model.atoms import Floats, Ints
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.neighbor import NeighborList
from pylmp.model.wish import Wish

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.simulation import Simulation


@dataclass(frozen=True)
class Pairs:
    """Listed pairs in list order: rows i (owned), rows j (owned or ghost), special kind (0 none, 1 to 3), separation x_i - x_j now."""

    i: Ints
    j: Ints
    kind: Ints
    d: Floats

    @property
    def r2(self) -> Floats:
        x, y, z = self.d.T
        return np.asarray(x * x + y * y + z * z)

    def take(self, chosen: Ints) -> Pairs:
        return Pairs(self.i[chosen], self.j[chosen], self.kind[chosen], self.d[chosen])


class Occasional:
    """The lists of one run. A half list of the pair style's reach is the run's own."""

    def __init__(self, sim: Simulation, own: NeighborList | None) -> None:
        self._own = own
        mode = HALF if sim.newton_pair else HALF_OWNED
        wishes = dict.fromkeys(compute.wish(sim) for compute in sim.computes.values())
        self._lists: dict[Wish, NeighborList] = {}
        for wish in wishes if sim.pair and sim.neighbor_cutoff > 0.0 else ():
            if wish is not None:
                self._lists[wish] = own if wish == Wish() and own else NeighborList(sim, FULL if wish.full else mode, wish.cutoff)
        self._current: set[Wish] = set()

    def functions(self) -> list[Function]:
        return [function for listed in self._lists.values() if listed is not self._own for function in listed.functions()]

    def forget(self) -> None:
        """The run's list was rebuilt."""
        self._current.clear()

    @property
    def full_count(self) -> int | None:
        """Entries of a full list when it was last built; None without one."""
        return next((listed.count for wish, listed in self._lists.items() if wish.full), None)

    @property
    def half_count(self) -> int:
        """The same of a half list; 0 without one."""
        return next((listed.count for wish, listed in self._lists.items() if not wish.full), 0)

    def pairs(self, sim: Simulation, wish: Wish) -> Pairs:
        """The pairs listed for wish, with positions of now."""
        if wish not in self._lists:
            nobody = np.zeros(0, np.int64)
            return Pairs(nobody, nobody, nobody, np.zeros((0, 3)))
        listed = self._built(sim, wish)
        first = np.repeat(np.arange(len(listed.first) - 1), np.diff(listed.first))
        entries = listed.neighbors[: listed.count].astype(np.int64)
        second, kind = entries & INDEX_MASK, (entries >> SPECIAL_SHIFT) & 3
        return Pairs(first, second, kind, sim.atoms.x[first] - sim.atoms.x[second])

    def _built(self, sim: Simulation, wish: Wish) -> NeighborList:
        listed = self._lists[wish]
        if wish not in self._current and listed is not self._own:
            listed.build(sim, ghost_cutoff(sim))
            self._current.add(wish)
        return listed


def listed_pairs(sim: Simulation, wish: Wish) -> Pairs:
    """The pairs that a compute wished for."""
    found: Pairs = sim.lists.occasional.pairs(sim, wish)
    return found
