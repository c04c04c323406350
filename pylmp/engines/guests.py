"""Neighbor lists of computes in a fast run without ghosts: ghosts are guests then, from the first list of a step to the next step."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.model.ghosts import Ghosts, ghost_cutoff
from pylmp.model.occasional import Occasional, Pairs

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.simulation import Simulation
    from pylmp.model.wish import Wish


class Guests(Occasional):
    """Lists as the exact engine's. Which atoms have ghosts is found out with the first list after a rebuild; they follow their atoms later."""

    def __init__(self, sim: Simulation) -> None:
        super().__init__(sim, None)
        self._ghosts = Ghosts(sim)
        self._count = -1

    def functions(self) -> list[Function]:
        return [*super().functions(), *self._ghosts.functions()] if self._lists else []

    def forget(self) -> None:
        super().forget()
        self._count = -1

    def pairs(self, sim: Simulation, wish: Wish) -> Pairs:
        if wish in self._lists:
            self._invite(sim)
        return super().pairs(sim, wish)

    def _invite(self, sim: Simulation) -> None:
        if self._count < 0:
            self._ghosts.build(sim, ghost_cutoff(sim))
            self._count = sim.atoms.ghosts
        else:
            sim.atoms.ghosts = self._count
            self._ghosts.bind_refresh(sim)()
