"""fix ID GROUP recenter X Y Z [shift GROUP] [units box|lattice|fraction]: the center of mass of a group is put back in every step.

X Y Z are coordinates, INIT (where it was when the run began) or NULL (leave it). shift: which atoms are moved for it (default: the
group). scalar: distance of the last shift; vector: the shift. Source: LAMMPS manual, fix_recenter.html.
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


@FIXES.register("recenter")
class Recenter(Fix):
    style = "recenter"
    extensive_scalar = extensive_vector = True
    length = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(3)
        if not self.members(sim).any():
            args.fail(f"Fix recenter group {group} has no atoms", hint="a group with atoms")
        self.to: list[float | str] = []
        for _ in range(3):
            word = args.word()
            self.to.append(word.text if word.text in ("INIT", "NULL") else args.as_number(word))
        self.shift_bit, self.units = bit, "lattice"
        while len(args):
            self._keyword(sim, args)
        if self.units == "lattice":
            self.to = [c if isinstance(c, str) else s * c for c, s in zip(self.to, sim.spacing, strict=True)]
        self._start = self._shift = np.zeros(3)

    def _keyword(self, sim: Simulation, args: Args) -> None:
        key = args.word()
        if key.text not in ("shift", "units"):
            args.fail(f"Unknown fix recenter keyword {key.text}", key, hint="shift units")
        args.need(1, key.text)
        value = args.word()
        if key.text == "shift":
            self.shift_bit = sim.groups.bit(value.text)
            if not self.shift_bit:
                args.fail(f"Group ID {value.text} requested by fix recenter does not exist", value)
        elif value.text not in ("box", "lattice", "fraction"):
            args.fail(f"Unknown fix recenter units argument {value.text}", value, hint="box, lattice or fraction")
        else:
            self.units = value.text

    def init(self, sim: Simulation) -> None:
        rows = self.members(sim)
        later = sim.fixes[sim.fixes.index(self) + 1 :]
        if any(fix.integrates or fix.style == self.style for fix in later):
            sim.console.warning("Fix recenter should come after all other integration fixes")
        self._mass = total(sim.masses()[rows])  # LAMMPS divides by the mass there was when the run began
        self._start = center_of_mass(sim, rows, self._mass)

    def initial_integrate(self, sim: Simulation) -> None:
        (low, high), goal = sim.box.bounds, []
        for d, to in enumerate(self.to):
            if isinstance(to, str):
                goal.append(float(self._start[d]))
            elif self.units == "fraction":
                goal.append(float(low[d] + to * (high[d] - low[d])))
            else:
                goal.append(to)
        now = center_of_mass(sim, self.members(sim), self._mass)
        self._shift = np.array([0.0 if self.to[d] == "NULL" else goal[d] - float(now[d]) for d in range(3)])
        moved = (sim.atoms.mask[: sim.atoms.n] & self.shift_bit) != 0
        for d in range(3):
            if self.to[d] != "NULL":
                sim.atoms.x[: sim.atoms.n][moved, d] += self._shift[d]

    def scalar(self, sim: Simulation) -> float:
        a, b, c = self._shift
        return math.sqrt(a * a + b * b + c * c)

    def vector(self, sim: Simulation) -> Floats:
        return self._shift
