"""fix ID GROUP nve/limit XMAX: velocity Verlet in which no atom goes farther than XMAX in a step.

    v += (dt/2)(f/m);  v *= XMAX/(dt |v|) where that is below 1;  x += dt v

scalar: how often velocities were limited in this run. Source: LAMMPS manual, fix_nve_limit.html.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@FIXES.register("nve/limit")
class NVELimit(Fix):
    style = "nve/limit"
    integrates = True
    extensive_scalar = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) != 1:
            args.missing("fix ID GROUP nve/limit XMAX")
        self.farthest = args.number()
        self._count = 0

    def init(self, sim: Simulation) -> None:
        self._count = 0

    def _kick(self, sim: Simulation) -> tuple[NDArray[np.bool_], Floats]:
        """(members, their new velocities)."""
        rows = self.members(sim)
        n = sim.atoms.n
        v = sim.atoms.v[:n][rows]
        v += ((0.5 * sim.dt * sim.units.ftm2v) / sim.masses()[rows])[:, None] * sim.atoms.f[:n][rows]
        square = v[:, 0] * v[:, 0] + v[:, 1] * v[:, 1] + v[:, 2] * v[:, 2]
        limit = (self.farthest / sim.dt) * (self.farthest / sim.dt)
        fast = square > limit
        self._count += int(fast.sum())
        v[fast] *= np.sqrt(limit / square[fast])[:, None]
        sim.atoms.v[:n][rows] = v
        return rows, v

    def initial_integrate(self, sim: Simulation) -> None:
        rows, v = self._kick(sim)
        sim.atoms.x[: sim.atoms.n][rows] += sim.dt * v

    def final_integrate(self, sim: Simulation) -> None:
        self._kick(sim)

    def scalar(self, sim: Simulation) -> float:
        return float(self._count)
