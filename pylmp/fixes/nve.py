"""fix ID GROUP nve: velocity Verlet at constant energy.

    v += (dt/2)(f/m);  x += dt v;  (new forces)  v += (dt/2)(f/m)

Source: LAMMPS manual, fix_nve.html.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.kernels.exact import integrate
from pylmp.kernels.store import kernel
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@FIXES.register("nve")
class NVE(Fix):
    style = "nve"
    integrates = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.fail("Unsupported additional arguments for fix nve", args.peek())
        scene = bit == 1, sim.atom_types == 1
        self._first, self._second = integrate.kick_and_drift(*scene), integrate.kick(*scene)
        self._calls: tuple[Callable[[], float], Callable[[], float]] = (lambda: 0.0, lambda: 0.0)

    def functions(self) -> list[Any]:
        return [self._first, self._second]

    def post_neighbor(self, sim: Simulation) -> None:
        atoms, types = sim.atoms, sim.atom_types
        half = 0.5 * sim.dt * sim.units.ftm2v

        def rows(begin: int) -> tuple[Any, ...]:
            kicks = np.zeros(types + 1)
            return atoms.v[begin:], atoms.f[begin:], atoms.type[begin:], atoms.mask[begin:], sim.mass, kicks, half

        self._calls = (
            sim.team.split(atoms.n, lambda a, b: kernel(self._first).bind(atoms.x[a:], *rows(a), sim.dt, types, self.bit, b - a)),
            sim.team.split(atoms.n, lambda a, b: kernel(self._second).bind(*rows(a), types, self.bit, b - a)),
        )

    def reset_dt(self, sim: Simulation) -> None:
        self.post_neighbor(sim)

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        return [self._calls[hook == "final_integrate"]]

    def initial_integrate(self, sim: Simulation) -> None:
        self._calls[0]()

    def final_integrate(self, sim: Simulation) -> None:
        self._calls[1]()
