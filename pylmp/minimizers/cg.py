"""min_style cg: conjugate gradients, Polak and Ribiere's, begun anew along the force where a direction does not lead downhill.

    h = f + beta h,   beta = max(0, (f.f - f.g)/g.g),   g: the force before

Source: LAMMPS manual, min_style.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.linesearch import LineMinimizer
from pylmp.model.minimize import dot
from pylmp.model.registry import MINIMIZERS


@MINIMIZERS.register("cg")
class ConjugateGradient(LineMinimizer):
    style = "cg"

    def begin(self) -> None:
        super().begin()
        self.sim.atoms.extra["minimize g"] = np.zeros((self.sim.atoms.capacity, 3))
        self.store("g")[:] = self.f
        self.gg = dot(self.f, self.f)

    def turn(self) -> None:
        f, g, h = self.f, self.store("g"), self.store("h")
        ff, fg = dot(f, f), dot(f, g)
        beta = max(0.0, (ff - fg) / self.gg)
        if (self.iterations + 1) % (3 * self.sim.natoms) == 0:
            beta = 0.0
        self.gg = ff
        g[:] = f
        h[:] = g + beta * h
        if dot(g, h) <= 0.0:
            h[:] = g
