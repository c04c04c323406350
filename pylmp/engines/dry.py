"""The engine of tools that only look at a script: runs are set up as far as nothing has to be compiled, and no atom moves."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from pylmp.engines.timers import SECTIONS
from pylmp.model.engine import RunPlan, RunReport
from pylmp.model.minimize import MAX_ITERATIONS, MinPlan, MinReport
from pylmp.model.scene import Scene
from pylmp.model.simulation import Simulation

Look = Callable[[Simulation, Scene, int], None]


class Dry:
    """look(sim, scene, steps) is told of each run that would begin. The step number goes on as if it had been made."""

    name = "none"

    def __init__(self, look: Look = lambda sim, scene, steps: None) -> None:
        self.look = look

    def run(self, sim: Simulation, scene: Scene, plan: RunPlan) -> RunReport:
        self.look(sim, scene, plan.steps)
        sim.step += plan.steps
        return self._report(plan.steps)

    def minimize(self, sim: Simulation, scene: Scene, plan: MinPlan) -> tuple[RunReport, MinReport]:
        self.look(sim, scene, plan.maxiter)
        sim.step += plan.maxiter
        nothing = MinReport(MAX_ITERATIONS, (0.0, 0.0, 0.0), (0.0, 0.0), (0.0, 0.0), 0.0, plan.maxiter, plan.maxeval)
        return self._report(plan.maxiter), nothing

    def replay(self, sim: Simulation, scene: Scene, frames: Iterator[None]) -> RunReport:
        self.look(sim, scene, 0)
        return self._report(0)

    @staticmethod
    def _report(steps: int) -> RunReport:
        return RunReport(steps, 1.0, dict.fromkeys(SECTIONS, 0.0), neighbors=0, ghosts=0, builds=0, dangerous=0)
