"""The lines of a log that say who carries out a run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.model.sanity import warn_stiff

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

PRECISION = {"exact": "float64, the bits of LAMMPS", "fast": "float64, distances of the neighbor list float32 with a margin"}


class Announcer:
    """Says it at the first run, and again when the engine changes or kernels were compiled."""

    def __init__(self) -> None:
        self._said = ""
        self._warned: set[str] = set()

    def say(self, sim: Simulation, engine: str, kernels: tuple[int, int]) -> None:
        """kernels: how many there are, how many of them were compiled."""
        many, new = kernels
        if engine == self._said and not new:
            return
        self._said = engine
        came = f"{new} compiled" if new == many else f"{many - new} from the store, {new} compiled" if new else "from the store"
        threads = f"{sim.team.threads} threads" if engine == "fast" and sim.team.threads > 1 else "1 thread"
        sim.console.both(f"Engine {engine}: {many} kernels ({came}), {threads}, {PRECISION[engine]}\n")

    def heed(self, sim: Simulation) -> None:
        """After a set-up: what of it will not go well."""
        sim.watchful = not sim.strict
        warn_stiff(sim, self._warned)
