"""min_style sd: steepest descent. Each search goes along the force. Source: LAMMPS manual, min_style.html."""

from __future__ import annotations

from pylmp.model.linesearch import LineMinimizer
from pylmp.model.minimize import MAX_EVALUATIONS
from pylmp.model.registry import MINIMIZERS


@MINIMIZERS.register("sd")
class SteepestDescent(LineMinimizer):
    style = "sd"

    def iterate(self) -> str | None:
        failed = self.search()
        if failed:
            return failed
        if self.count >= self.plan.maxeval:
            return MAX_EVALUATIONS
        stop = self.converged()
        if stop is None:
            self.store("h")[:] = self.f
        return stop
