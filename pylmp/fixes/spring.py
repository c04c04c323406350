"""fix ID GROUP spring tether K x y z R0
fix ID GROUP spring couple GROUP2 K x y z R0

A spring between the center of mass of a group and a point, or between the centers of two groups:

    F = -K (r - R0) d/r,  E = K/2 (r - R0)^2

d is center - (x, y, z), or center2 - center1 - (x, y, z), 0 where x, y or z is NULL. Every atom gets its share by mass.
scalar: E; vector: the three components of the force on the group, and its magnitude. Source: LAMMPS manual, fix_spring.html.
"""

from __future__ import annotations

import math

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.motion import center_of_mass
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.text.words import Args

_SMALL = 1.0e-10


@FIXES.register("spring")
class Spring(Fix):
    style = "spring"
    minimizes = True
    has_energy = True
    extensive_scalar = extensive_vector = True
    length = 4

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(6)
        mode = args.word()
        if mode.text not in ("tether", "couple"):
            args.fail(f"Unknown fix spring keyword {mode.text}", mode, hint="tether or couple")
        self.other = 0
        if len(args.words) != (7 if mode.text == "couple" else 6):
            args.fail(f"Incorrect number of arguments for {mode.text} mode", mode)
        if mode.text == "couple":
            second = args.word()
            self.other = sim.groups.bit(second.text)
            if not self.other:
                args.fail(f"Could not find fix spring couple second group ID {second.text}", second)
            if self.other == bit:
                args.fail("The two groups cannot be the same in fix spring couple", second)
        self.stiffness = args.number()
        words = [args.word() for _ in range(3)]
        self.point = [None if word.text == "NULL" else args.as_number(word) for word in words]
        self.rest = args.number()
        if self.rest < 0.0:
            args.fail("R0 < 0 for fix spring command", hint="a length")
        self._energy = 0.0
        self._force = np.zeros(4)

    def post_force(self, sim: Simulation) -> None:
        mine = self.members(sim)
        theirs = (sim.atoms.mask[: sim.atoms.n] & self.other) != 0
        center = center_of_mass(sim, mine)
        if self.other:
            far = center_of_mass(sim, theirs)
            d = [0.0 if p is None else float(far[k]) - float(center[k]) - p for k, p in enumerate(self.point)]
        else:
            d = [0.0 if p is None else float(center[k]) - p for k, p in enumerate(self.point)]
        r = max(math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]), _SMALL)
        stretch = r - self.rest
        pull = [self.stiffness * component * stretch / r for component in d]
        size = math.sqrt(pull[0] * pull[0] + pull[1] * pull[1] + pull[2] * pull[2])
        self._energy = 0.5 * self.stiffness * stretch * stretch
        sign = 1.0 if self.other else -1.0
        self._force = np.array([*(sign * p for p in pull), -size if stretch < 0.0 else size])
        self._share(sim, mine, pull, sign)
        if self.other:
            self._share(sim, theirs, pull, -sign)

    setup = post_force

    @staticmethod
    def _share(sim: Simulation, rows: Floats, pull: list[float], sign: float) -> None:
        """Every chosen atom gets (pull/M) m."""
        m = sim.masses()[rows]
        whole = total(m)
        f = sim.atoms.f[: sim.atoms.n]
        for d in range(3):
            f[rows, d] += sign * (pull[d] / whole * m if whole > 0.0 else 0.0 * m)

    def scalar(self, sim: Simulation) -> float:
        return self._energy

    def vector(self, sim: Simulation) -> Floats:
        return self._force
