"""compute ID GROUP vacf: velocity autocorrelation, the mean of v . v0 over the group; v0 when the compute was defined.

vector: x, y, z, total. Source: LAMMPS manual, compute_vacf.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.keepsake import Keepsake
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import totals
from pylmp.text.words import Args


@COMPUTES.register("vacf")
class VelocityAutocorrelation(Keepsake):
    style = "vacf"
    length = 4
    array = "v"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.fail("Compute vacf does not accept any arguments", args.peek())
        rows = self.members(sim)
        start = np.zeros((sim.atoms.n, 3))
        start[rows] = sim.atoms.v[: sim.atoms.n][rows]
        self.keep(sim, start)

    def init(self, sim: Simulation) -> None:
        self.count = int(self.members(sim).sum())

    def vector(self, sim: Simulation) -> Floats:
        rows = self.members(sim)
        x, y, z = (sim.atoms.v[: sim.atoms.n][rows] * self.kept(sim)[rows]).T
        sums = totals(np.stack([x, y, z, x + y + z], axis=1))
        return sums / self.count if self.count else sums
