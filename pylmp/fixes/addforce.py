"""fix ID GROUP addforce fx fy fz [every N] [region ID]: a constant force on every atom.

scalar: potential energy of that force, -sum(f . x) with unwrapped x; vector: total force before. fix_modify energy and
virial count them in. Source: LAMMPS manual, fix_addforce.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.forces import ForceFix, read_components
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


@FIXES.register("addforce")
class AddForce(ForceFix):
    style = "addforce"
    minimizes = True
    extensive_scalar = extensive_vector = True
    has_energy = has_virial = True
    length = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.force = [force or 0.0 for force in read_components(args, null=False)]
        self.interval = 1
        self.read_keywords(sim, args, {"every": self._every, "energy": self._elsewhere})
        self._before = np.zeros(3)
        self._energy = 0.0
        self._virial = np.zeros(6)

    def _every(self, args: Args) -> None:
        self.interval = args.integer()
        if self.interval <= 0:
            args.fail(f"Invalid fix addforce every argument: {self.interval}", hint="every so many steps")

    @staticmethod
    def _elsewhere(args: Args) -> None:
        raise Unsupported("LAMMPS has fix addforce energy, pylmp's native engines do not", args.word().span)

    def post_force(self, sim: Simulation) -> None:
        if sim.step % self.interval:
            return
        atoms = sim.atoms
        rows = self.members(sim)
        f = atoms.f[: atoms.n]
        x = sim.box.unwrap(atoms.x[: atoms.n], atoms.image[: atoms.n])[rows]
        a, b, c = self.force
        self._energy = total(-(a * x[:, 0] + b * x[:, 1] + c * x[:, 2]))
        self._before = totals(f[rows])
        f[rows] += np.array(self.force)
        products = (a * x[:, 0], b * x[:, 1], c * x[:, 2], a * x[:, 1], a * x[:, 2], b * x[:, 2])
        self._virial = totals(np.stack(products, axis=1))

    setup = post_force

    def scalar(self, sim: Simulation) -> float:
        return self._energy

    def vector(self, sim: Simulation) -> Floats:
        return self._before

    def virial(self, sim: Simulation) -> Floats:
        return self._virial
