"""Runs of the fast engine in scenes where the nearest image is not all that counts: its force loops over ghosts and over lists as
the exact engine builds them.

So it goes in tilted and in narrow boxes, in a flow (fix deform remap v), and where pairs have weights or are excluded.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pylmp.engines.exact import Run
from pylmp.engines.fast_forces import FastForces
from pylmp.engines.guests import FastLists
from pylmp.model.engine import RunReport
from pylmp.model.fix import hooks
from pylmp.model.ghosts import Ghosts
from pylmp.model.occasional import Occasional

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


def wants_ghosts(sim: Simulation) -> bool:
    """The nearest image is not all that counts."""
    box = sim.box
    reach = 2.0 * sim.neighbor_cutoff
    narrow = any(periodic and length < reach for periodic, length in zip(box.periodic[: sim.dimension], box.length, strict=False))
    fractions = sim.pair is not None and sim.has_bonds and not set(sim.special.lj) <= {0.0, 1.0}
    return bool(box.triclinic or box.rate_group or sim.neighbor.exclude or sim.neighbor.style == "nsq" or narrow or fractions)


class GhostRun(Run):
    """A run of the exact engine's order with the fast engine's forces."""

    forces: FastForces

    @staticmethod
    def _field(sim: Simulation) -> tuple[Any, Any]:
        return Ghosts(sim), FastForces(sim, ghosts=True)

    def _lists_of_computes(self, sim: Simulation) -> Occasional:
        return FastLists(sim)

    def _forces(self, wanted: int, setup: bool) -> None:
        sim, timers = self.sim, self.timers
        if wanted and (wanted := self.forces.able(wanted)):
            sim.tally.step, sim.tally.wanted = sim.step, wanted
        if setup:
            for hook in hooks(sim.fixes, "setup_pre_force"):
                hook(sim)
        elif self.hooks["pre_force"]:
            self.call("pre_force")
            timers.stamp("Modify")
        self.forces.evaluate(sim, wanted, setup)
        timers.stamp("Pair")

    def advance(self, steps: int) -> RunReport:
        try:
            report = super().advance(steps)
        finally:
            self.sim.team.dismiss()
        self.forces.copy_back(self.sim)
        return report

    def step(self) -> None:
        self.sim.team.gather()
        super().step()
