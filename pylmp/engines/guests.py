"""Neighbor lists of computes in a fast run without ghosts: ghosts are guests then, from the first list of a step to the next step."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.ghosts import Ghosts, ghost_cutoff
from pylmp.model.occasional import Occasional, Pairs
from pylmp.model.wish import Wish

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.atoms import Ints
    from pylmp.model.simulation import Simulation


class FastLists(Occasional):
    """Lists of computes where the run's own list is none that they could use.

    As in LAMMPS the half list knows in the next step that atoms of broken bonds interact as pairs.
    """

    def __init__(self, sim: Simulation) -> None:
        super().__init__(sim, None)
        self._step, self._broken = -1, np.zeros((2, 0), np.int64)

    def broke(self, sim: Simulation, tags: Ints) -> None:
        """In this step bonds broke between atoms of these IDs, (2, k)."""
        before = self._broken if self._step == sim.step else tags[:, :0]
        self._step, self._broken = sim.step, np.concatenate([before, tags], axis=1)
        self._current.discard(Wish())

    def pairs(self, sim: Simulation, wish: Wish) -> Pairs:
        pairs = super().pairs(sim, wish)
        if wish == Wish() and self._step == sim.step:
            tag, span = sim.atoms.tag, sim.atoms.span()
            still = np.isin(tag[pairs.i] * span + tag[pairs.j], self._broken[0] * span + self._broken[1])
            pairs.kind[still] = 1
        return pairs


class Guests(FastLists):
    """Lists as the exact engine's. Which atoms have ghosts is found out with the first list after a rebuild; they follow their atoms later."""

    def __init__(self, sim: Simulation, moved: Callable[[], None]) -> None:
        """moved: called when the arrays of the atoms had to grow."""
        super().__init__(sim)
        self._moved = moved
        self._ghosts = Ghosts(sim)
        self._count = -1

    def functions(self) -> list[Function]:
        return [*super().functions(), *self._ghosts.functions()] if self._lists else []

    def forget(self) -> None:
        super().forget()
        self._count = -1

    def make_room(self, sim: Simulation) -> None:
        """Let the arrays of the atoms grow now, at a rebuild: amid a step others hold them."""
        if self._lists:
            self._ghosts.build(sim, ghost_cutoff(sim) + sim.neighbor.skin)
            rows = sim.atoms.total
            sim.atoms.clear_ghosts()
            sim.atoms.reserve(rows + rows // 4)

    def pairs(self, sim: Simulation, wish: Wish) -> Pairs:
        if wish in self._lists:
            self._invite(sim)
        return super().pairs(sim, wish)

    def _invite(self, sim: Simulation) -> None:
        if self._count < 0:
            before = sim.atoms.x
            self._ghosts.build(sim, ghost_cutoff(sim))
            self._count = sim.atoms.ghosts
            if sim.atoms.x is not before:
                self._moved()
        else:
            sim.atoms.ghosts = self._count
            self._ghosts.bind_refresh(sim)()
