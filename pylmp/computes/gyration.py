"""compute ID GROUP gyration: radius of gyration of a group, and the tensor of which its square is the trace.

Rg^2 = sum(m |x - x_cm|^2)/M of unwrapped positions; vector xx yy zz xy xz yz. Source: LAMMPS manual, compute_gyration.html.
"""

from __future__ import annotations

import math

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.motion import center_of_mass, unwrapped
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.text.words import Args


@COMPUTES.register("gyration")
class Gyration(Compute):
    style = "gyration"
    length = 6

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())

    def init(self, sim: Simulation) -> None:
        self.mass = total(sim.masses()[self.members(sim)])

    def _arms(self, sim: Simulation) -> tuple[Floats, Floats]:
        """(k, 3) positions relative to the center, (k,) masses."""
        if self.group_varies(sim):
            self.init(sim)
        rows = self.members(sim)
        return unwrapped(sim, rows) - center_of_mass(sim, rows, self.mass), sim.masses()[rows]

    def scalar(self, sim: Simulation) -> float:
        d, m = self._arms(sim)
        x, y, z = d.T
        squares = total((x * x + y * y + z * z) * m)
        return math.sqrt(squares / self.mass) if self.mass > 0.0 else 0.0

    def vector(self, sim: Simulation) -> Floats:
        d, m = self._arms(sim)
        x, y, z = d.T
        sums = totals(np.stack([x * x * m, y * y * m, z * z * m, x * y * m, x * z * m, y * z * m], axis=1))
        return sums / self.mass if self.mass > 0.0 else sums
