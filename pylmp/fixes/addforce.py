"""fix ID GROUP addforce fx fy fz: a constant force on every atom.

scalar: potential energy of that force, -sum(f . x) with unwrapped x; vector: total force before.
Source: LAMMPS manual, fix_addforce.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.forces import read_components
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.text.words import Args


@FIXES.register("addforce")
class AddForce(Fix):
    style = "addforce"
    extensive_scalar = extensive_vector = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.force = [force or 0.0 for force in read_components(args, ("region", "every", "energy"), null=False)]
        self._before = np.zeros(3)
        self._energy = 0.0

    def post_force(self, sim: Simulation) -> None:
        atoms = sim.atoms
        rows = self.members(sim)
        f = atoms.f[: atoms.n]
        x = sim.box.unwrap(atoms.x[: atoms.n], atoms.image[: atoms.n])[rows]
        a, b, c = self.force
        self._energy = total(-(a * x[:, 0] + b * x[:, 1] + c * x[:, 2]))
        self._before = totals(f[rows])
        f[rows] += np.array(self.force)

    setup = post_force

    def scalar(self, sim: Simulation) -> float:
        return self._energy

    def vector(self, sim: Simulation) -> Floats:
        return self._before
