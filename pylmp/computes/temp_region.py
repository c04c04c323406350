"""compute ID GROUP temp/region REGION: temperature of the atoms that are inside the region now.

T = sum(m v^2) / (dof kB), dof = dimension*N - dimension over the N atoms inside. Thermostats leave the atoms outside alone. Source: LAMMPS manual, compute_temp_region.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.region import named
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.temperature import Rows, Temperature
from pylmp.text.words import Args


@COMPUTES.register("temp/region")
class TempRegion(Temperature):
    style = "temp/region"
    bias = True
    recount = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) != 1:
            args.illegal(args.owner, hint="the ID of a region")
        word = args.word()
        if word.text not in sim.regions:
            args.fail(f"Region {word.text} for compute temp/region does not exist", word, hint="region comes first")
        self.region = word.text

    def init(self, sim: Simulation) -> None:
        named(sim, self.region, "compute temp/region")

    def members(self, sim: Simulation) -> Rows:
        return super().members(sim) & self._inside(sim)

    def _inside(self, sim: Simulation) -> Rows:
        return np.asarray(named(sim, self.region, "compute temp/region").inside(sim.atoms.x[: sim.atoms.n]))

    @staticmethod
    def of(sim: Simulation, t: float, dof: float) -> float:
        return sim.units.mvv2e * t / (dof * sim.units.boltz)

    def thermal(self, sim: Simulation, rows: Rows) -> Floats:
        return np.where(self._inside(sim)[rows, None], sim.atoms.v[: sim.atoms.n][rows], 0.0)

    def remove_bias(self, sim: Simulation, rows: Rows) -> tuple[Rows, Floats]:
        outside = rows & ~self._inside(sim)
        kept = sim.atoms.v[: sim.atoms.n][outside]
        sim.atoms.v[: sim.atoms.n][outside] = 0.0
        return outside, kept

    def restore_bias(self, sim: Simulation, rows: Rows, kept: tuple[Rows, Floats]) -> None:
        outside, velocities = kept
        sim.atoms.v[: sim.atoms.n][outside] = velocities
