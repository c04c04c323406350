"""compute ID GROUP temp: temperature, and the kinetic energy tensor.

T = sum(m v^2) / (dof kB), dof = dimension*N - dimension. Source: LAMMPS manual, compute_temp.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.motion import temperature_dof, temperature_of
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import totals
from pylmp.text.words import Args


@COMPUTES.register("temp")
class Temp(Compute):
    style = "temp"
    length = 6
    extensive_vector = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())
        self._dof = 0.0

    def setup(self, sim: Simulation) -> None:
        self._dof = temperature_dof(sim, self.members(sim))

    def dof(self, sim: Simulation) -> float:
        """Degrees of freedom, counted when the run was set up: atoms lost since then still count. Anew for a dynamic group."""
        if self.group in sim.groups.dynamic:
            self.setup(sim)
        return self._dof

    def scalar(self, sim: Simulation) -> float:
        return temperature_of(sim, self.members(sim), self.dof(sim))

    def vector(self, sim: Simulation) -> Floats:
        """(6,) sum(m v_a v_b): xx yy zz xy xz yz."""
        rows = self.members(sim)
        m = sim.masses()[rows]
        x, y, z = sim.atoms.v[: sim.atoms.n][rows].T
        products = np.stack([m * x * x, m * y * y, m * z * z, m * x * y, m * x * z, m * y * z], axis=1)
        return totals(products) * sim.units.mvv2e
