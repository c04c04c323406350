"""fix ID GROUP nve/limit XMAX: velocity Verlet in which no atom goes farther than XMAX in a step.

    v += (dt/2)(f/m);  v *= XMAX/(dt |v|) where that is below 1;  x += dt v

scalar: how often velocities were limited in this run. Source: LAMMPS manual, fix_nve_limit.html.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.kernels.exact.integrate import limited_kick
from pylmp.kernels.store import kernel
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@FIXES.register("nve/limit")
class NVELimit(Fix):
    style = "nve/limit"
    integrates = True
    extensive_scalar = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) != 1:
            args.missing("fix ID GROUP nve/limit XMAX")
        self.farthest = args.number()
        self._count = np.zeros(1, np.int64)
        self._first, self._second = (limited_kick(bit == 1, drift) for drift in (True, False))
        self._kicks = np.zeros(sim.atom_types + 1)
        self._calls: tuple[Callable[[], float], ...] = ()

    def functions(self) -> list[Any]:
        return [self._first, self._second]

    def init(self, sim: Simulation) -> None:
        self._count[0] = 0

    def post_neighbor(self, sim: Simulation) -> None:
        atoms, types, speed = sim.atoms, sim.atom_types, self.farthest / sim.dt
        values = (
            atoms.x, atoms.v, atoms.f, atoms.type, atoms.mask, sim.mass, self._kicks, 0.5 * sim.dt * sim.units.ftm2v, sim.dt,
            speed * speed, types, self.bit, self._count, atoms.n,
        )  # fmt: skip
        self._calls = tuple(kernel(function).bind(*values) for function in (self._first, self._second))

    def reset_dt(self, sim: Simulation) -> None:
        self.post_neighbor(sim)

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        return [self._calls[hook == "final_integrate"]]

    def initial_integrate(self, sim: Simulation) -> None:
        self._calls[0]()

    def final_integrate(self, sim: Simulation) -> None:
        self._calls[1]()

    def scalar(self, sim: Simulation) -> float:
        return float(self._count[0])
