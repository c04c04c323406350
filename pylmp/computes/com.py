"""compute ID GROUP com: center of mass, sum(m x)/M of unwrapped positions. Source: LAMMPS manual, compute_com.html."""

from __future__ import annotations

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.motion import center_of_mass
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.text.words import Args


@COMPUTES.register("com")
class CenterOfMass(Compute):
    style = "com"
    length = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())

    def init(self, sim: Simulation) -> None:
        self.mass = total(sim.masses()[self.members(sim)])

    def vector(self, sim: Simulation) -> Floats:
        """(3,) Like LAMMPS it divides by the mass that the group had when the run began."""
        if self.group_varies(sim):
            self.init(sim)
        return center_of_mass(sim, self.members(sim), self.mass)
