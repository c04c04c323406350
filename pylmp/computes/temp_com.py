"""compute ID GROUP temp/com: temperature of the velocities relative to the group's center of mass.

T = sum(m |v - v_cm|^2) / (dof kB). Thermostats leave the motion of the center alone. Source: LAMMPS manual, compute_temp_com.html.
"""

from __future__ import annotations

from typing import Any

from pylmp.model.atoms import Floats
from pylmp.model.motion import center_of_mass_velocity
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.model.temperature import Rows, Temperature
from pylmp.text.words import Args


@COMPUTES.register("temp/com")
class TempCom(Temperature):
    style = "temp/com"
    bias = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.fail("Illegal compute temp command", args.peek())

    def init(self, sim: Simulation) -> None:
        self.mass = total(sim.masses()[self.members(sim)])

    def drift(self, sim: Simulation) -> Floats:
        """(3,) velocity of the center. Like LAMMPS it divides by the mass that the group had when the run began."""
        if self.dynamic or self.group_varies(sim):
            self.init(sim)
        return center_of_mass_velocity(sim, self.members(sim), self.mass)

    def thermal(self, sim: Simulation, rows: Rows) -> Floats:
        return sim.atoms.v[: sim.atoms.n][rows] - self.drift(sim)

    def remove_bias(self, sim: Simulation, rows: Rows) -> Floats:
        drift = self.drift(sim)
        sim.atoms.v[: sim.atoms.n][rows] -= drift
        return drift

    def restore_bias(self, sim: Simulation, rows: Rows, kept: Any) -> None:
        sim.atoms.v[: sim.atoms.n][rows] += kept
