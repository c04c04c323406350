"""compute ID GROUP temp/partial XFLAG YFLAG ZFLAG: temperature of the velocity components whose flag is 1.

T = sum(m v^2) / (dof kB) over those components, dof = k*N - (k/dimension)*dimension for k of them. Thermostats leave the others
alone. Source: LAMMPS manual, compute_temp_partial.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.temperature import Rows, Temperature
from pylmp.text.words import Args


@COMPUTES.register("temp/partial")
class TempPartial(Temperature):
    style = "temp/partial"
    bias = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) != 3:
            args.illegal(args.owner, hint="three flags, 1 or 0: x y z")
        self.flags = np.array([float(args.integer()) for _ in range(3)])
        if sim.dimension == 2 and self.flags[2]:
            args.fail("Compute temp/partial cannot use vz for 2d systemx", hint="x y 0")

    def count_dof(self, sim: Simulation) -> float:
        per_atom = self.flags.sum()
        return float(per_atom * float(self.members(sim).sum()) - (1.0 * per_atom / sim.dimension) * self.extra_dof)

    def thermal(self, sim: Simulation, rows: Rows) -> Floats:
        return np.where(self.flags != 0.0, sim.atoms.v[: sim.atoms.n][rows], 0.0)

    def remove_bias(self, sim: Simulation, rows: Rows) -> Floats:
        kept = sim.atoms.v[: sim.atoms.n][rows]
        sim.atoms.v[: sim.atoms.n][rows] = self.thermal(sim, rows)
        return kept

    def restore_bias(self, sim: Simulation, rows: Rows, kept: Floats) -> None:
        v = sim.atoms.v[: sim.atoms.n]
        v[rows] = np.where(self.flags != 0.0, v[rows], kept)
