"""fix ID GROUP aveforce fx fy fz [region ID]: every atom gets the average force of all of them, plus fx fy fz.

NULL leaves a component alone; fx fy fz are numbers or equal-style variables. vector: total force before, three components.
Source: LAMMPS manual, fix_aveforce.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.forces import ForceFix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import totals
from pylmp.text.words import Args


@FIXES.register("aveforce")
class AveForce(ForceFix):
    style = "aveforce"
    minimizes = True
    extensive_vector = True
    length = 3
    per_atom = False
    missing, invalid = "Variable name for {1} does not exist", "Variable for {1} is invalid style"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) < 3 or (len(args) > 3 and (args.words[3].text != "region" or len(args) == 4)):
            args.illegal(args.words[3] if len(args) > 3 else args.owner, hint="fx fy fz [region ID]")
        self.read_force(args, null=True)
        self.read_keywords(sim, args, {})
        self._before = np.zeros(3)

    def post_force(self, sim: Simulation) -> None:
        f = sim.atoms.f[: sim.atoms.n]
        rows = self.members(sim)
        count = int(rows.sum())
        self._before = totals(f[rows])
        if count == 0:
            return
        for d, value in enumerate(self.values(sim, rows)):
            if not self.force[d].absent:
                f[rows, d] = float(self._before[d]) / count + value

    setup = post_force

    def vector(self, sim: Simulation) -> Floats:
        return self._before
