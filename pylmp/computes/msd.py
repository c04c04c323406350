"""compute ID GROUP msd [com yes|no] [average yes|no]: mean squared displacement since the compute was defined.

sum |x - x0|^2 / N of unwrapped positions: x, y, z, total. com: the motion of the group's center is taken off. average: x0 is the mean
of the positions at all evaluations so far. Source: LAMMPS manual, compute_msd.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.keepsake import Keepsake
from pylmp.model.motion import center_of_mass, unwrapped
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@COMPUTES.register("msd")
class MeanSquaredDisplacement(Keepsake):
    style = "msd"
    length = 4

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.com = self.average = False
        while len(args):
            key = args.word()
            if key.text not in ("com", "average"):
                args.fail(f"Unknown compute msd keyword: {key.text}", key, hint="com average")
            args.need(1, key.text)
            setattr(self, key.text, args.yes())
        rows = self.members(sim)
        start = np.zeros((sim.atoms.n, 3))
        start[rows] = unwrapped(sim, rows)
        if self.com:
            start[rows] -= center_of_mass(sim, rows)
        self.keep(sim, start)
        self.evaluations = 0

    def init(self, sim: Simulation) -> None:
        rows = self.members(sim)
        self.mass, self.count = total(sim.masses()[rows]), int(rows.sum())

    def vector(self, sim: Simulation) -> Floats:
        rows = self.members(sim)
        if int(rows.sum()) != self.count:
            raise ScriptError("Number of atoms in compute msd group must not change.", hint="atoms were lost, or a group changed")
        now, start = unwrapped(sim, rows), self.kept(sim)[rows]
        if self.com:
            now = now - center_of_mass(sim, rows, self.mass)
        if self.average:
            self.evaluations += 1
            part = 1.0 / (self.evaluations + 1)
            start = (start * self.evaluations + now) * part
            if sim.box.triclinic:  # LAMMPS takes x for y and z there (measured on 22 Jul 2025)
                start[:, 1:] = ((start[:, 0] * self.evaluations + now[:, 0]) * part)[:, None]
            sim.atoms.extra[self.key][: sim.atoms.n][rows] = start
        x, y, z = (now - start).T
        sums = totals(np.stack([x * x, y * y, z * z, x * x + y * y + z * z], axis=1))
        return sums / self.count if self.count else sums
