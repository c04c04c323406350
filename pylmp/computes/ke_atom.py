"""compute ID GROUP ke/atom: kinetic energy of each atom, m v^2/2. Source: LAMMPS manual, compute_ke_atom.html."""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@COMPUTES.register("ke/atom")
class KineticEnergyOfAtoms(Compute):
    style = "ke/atom"
    columns = 0

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())

    def init(self, sim: Simulation) -> None:
        if sum(compute.style == self.style for compute in sim.computes.values()) > 1:
            sim.console.warning("More than one compute ke/atom")

    def per_atom(self, sim: Simulation) -> Floats:
        """(n,)"""
        x, y, z = sim.atoms.v[: sim.atoms.n].T
        energies = 0.5 * sim.units.mvv2e * sim.masses() * (x * x + y * y + z * z)
        return np.where(self.members(sim), energies, 0.0)
