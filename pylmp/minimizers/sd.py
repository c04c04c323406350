"""min_style sd: steepest descent. Each search goes along the force. Source: LAMMPS manual, min_style.html."""

from __future__ import annotations

from pylmp.model.linesearch import LineMinimizer
from pylmp.model.registry import MINIMIZERS


@MINIMIZERS.register("sd")
class SteepestDescent(LineMinimizer):
    style = "sd"

    def turn(self) -> None:
        self.store("h")[:] = self.f
