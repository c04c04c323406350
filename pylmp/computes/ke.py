"""compute ID GROUP ke: kinetic energy, sum(m v^2)/2. Source: LAMMPS manual, compute_ke.html."""

from __future__ import annotations

from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.text.words import Args


@COMPUTES.register("ke")
class KineticEnergy(Compute):
    style = "ke"
    extensive_scalar = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())

    def scalar(self, sim: Simulation) -> float:
        rows = self.members(sim)
        x, y, z = sim.atoms.v[: sim.atoms.n][rows].T
        return total(sim.masses()[rows] * (x * x + y * y + z * z)) * (0.5 * sim.units.mvv2e)
