"""fix ID GROUP setforce fx fy fz [region ID]: forces are replaced (NULL leaves a component alone).

fx fy fz are numbers, equal-style or atom-style variables. vector: total force before, three components.
Source: LAMMPS manual, fix_setforce.html.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.kernels.exact import pushes
from pylmp.kernels.store import kernel
from pylmp.model.atoms import Floats
from pylmp.model.forces import ForceFix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import totals
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@FIXES.register("setforce")
class SetForce(ForceFix):
    style = "setforce"
    minimizes = True
    extensive_vector = True
    length = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.read_force(args, null=True)
        self.read_keywords(sim, args, {})
        self._before = np.zeros(3)
        self._plain = not (self.region or self.varies)  # numbers, for a group: a kernel does it
        x, y, z = (force.absent for force in self.force)
        self._function = pushes.replace(bit == 1, (x, y, z))
        self._call: Callable[[], float] = lambda: 0.0

    def functions(self) -> list[Any]:
        return [self._function] if self._plain else []

    def post_neighbor(self, sim: Simulation) -> None:
        if self._plain:
            atoms, value = sim.atoms, np.array([force.value for force in self.force])
            self._call = kernel(self._function).bind(atoms.f, atoms.mask, value, self._before, self.bit, atoms.n)

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        return [self._call] if self._plain else None

    def init(self, sim: Simulation) -> None:
        super().init(sim)
        if sim.relaxing and any(force.varies or force.value != 0.0 for force in self.force):
            raise ScriptError("Cannot use non-zero forces in an energy minimization", hint="0.0 or NULL, or fix addforce")

    def post_force(self, sim: Simulation) -> None:
        if self._plain:
            self._call()
            return
        f = sim.atoms.f[: sim.atoms.n]
        rows = self.members(sim)
        self._before = totals(f[rows])
        for d, value in enumerate(self.values(sim, rows)):
            if not self.force[d].absent:
                f[rows, d] = value

    setup = post_force

    def vector(self, sim: Simulation) -> Floats:
        return self._before.copy()
