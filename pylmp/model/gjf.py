"""The Gronbech-Jensen/Farago form of fix langevin: the same bath, with half the error of the time step.

    a = (1 - dt/(2 damp))/(1 + dt/(2 damp)),  b = sqrt(1 + dt/(2 damp))

Velocity Verlet then moves a velocity that no output shows; what is shown is the half-step velocity b v (vhalf) or the full-step
one (vfull). Source: LAMMPS manual, fix_langevin.html; Gronbech-Jensen and Farago, Mol. Phys. 111, 983 (2013); order of operations
as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.exact.langevin import gaussians
from pylmp.kernels.random import RanMars
from pylmp.kernels.store import kernel
from pylmp.model.atoms import Floats

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

Rows = NDArray[np.bool_]


class Gjf:
    """full: the shown velocity is the full-step one. The other velocity and the last noise ride along with the atoms."""

    def __init__(self, sim: Simulation, identity: str, random: RanMars, damp: float, full: bool) -> None:
        self.random, self.damp, self.full = random, damp, full
        self._spare = np.zeros(2)
        self._names = f"fix langevin {identity} velocity", f"fix langevin {identity} noise"
        for name in self._names:
            sim.atoms.extra[name] = np.zeros((sim.atoms.capacity, 3))
        self._draw = gaussians()
        self.a = self.b = 1.0

    def removed(self, sim: Simulation) -> None:
        for name in self._names:
            sim.atoms.extra.pop(name, None)

    def functions(self) -> list[Any]:
        return [self._draw]

    def init(self, sim: Simulation) -> None:
        self.a = (1.0 - sim.dt / 2.0 / self.damp) / (1.0 + sim.dt / 2.0 / self.damp)
        self.b = math.sqrt(1.0 + sim.dt / 2.0 / self.damp)

    def noise(self, sim: Simulation) -> float:
        """What multiplies a gaussian number besides sqrt(m T)."""
        return math.sqrt(2.0 * sim.units.boltz / self.damp / sim.dt / sim.units.mvv2e)

    def other(self, sim: Simulation) -> Any:
        """(n, 3) the velocity that is not in v."""
        return sim.atoms.extra[self._names[0]][: sim.atoms.n]

    def last(self, sim: Simulation) -> Any:
        """(n, 3) the noise of the step before."""
        return sim.atoms.extra[self._names[1]][: sim.atoms.n]

    def _kick(self, sim: Simulation, rows: Rows) -> Floats:
        return np.asarray(((sim.units.ftm2v * 0.5 * sim.dt) / sim.masses()[rows])[:, None])

    def before_setup(self, sim: Simulation, rows: Rows) -> None:
        v, f = sim.atoms.v[: sim.atoms.n], sim.atoms.f[: sim.atoms.n]
        v[rows] -= self._kick(sim, rows) * f[rows]
        v[rows] /= self.a * self.b * self.b

    def after_setup(self, sim: Simulation, rows: Rows) -> None:
        v, f = sim.atoms.v[: sim.atoms.n], sim.atoms.f[: sim.atoms.n]
        v[rows] += self._kick(sim, rows) * f[rows]
        self.other(sim)[rows] = v[rows]

    def initial_integrate(self, sim: Simulation, rows: Rows) -> None:
        sim.atoms.f[: sim.atoms.n][rows] /= self.a
        sim.atoms.v[: sim.atoms.n][rows] = self.other(sim)[rows]

    def push(self, sim: Simulation, rows: Rows, drag: Floats, noise: Floats) -> tuple[Floats, Floats, Floats]:
        """Draw, and scale the forces: (drag, noise, what the bath is said to do), each (k, 3) for the chosen atoms.

        drag noise  (k,) coefficients
        """
        n = sim.atoms.n
        v, last = sim.atoms.v[:n], self.last(sim)
        numbers = np.empty(3 * int(rows.sum()))
        kernel(self._draw).bind(numbers, self.random.table, self.random.state, self._spare, len(numbers))()
        fresh = noise[:, None] * numbers.reshape(-1, 3)
        pull = drag[:, None] * v[rows]
        other = self.b * v[rows]
        self.other(sim)[rows] = other
        before = last[rows]
        random = 0.5 * (fresh + before)
        last[rows] = fresh
        pull, random = pull * self.a, random * self.a
        sim.atoms.f[:n][rows] *= self.a
        claimed = drag[:, None] * other / self.b / self.b + (2.0 * random / self.a - fresh) / self.b
        return pull, random, claimed

    def end_of_step(self, sim: Simulation, rows: Rows, claimed: Floats) -> None:
        """Swap velocities, so that the one to show is in v."""
        n = sim.atoms.n
        v, other = sim.atoms.v[:n], self.other(sim)
        mine, theirs = v[rows], other[rows]
        if self.full:
            kick, a, b = self._kick(sim, rows), self.a, self.b
            last = self.last(sim)[rows]
            v[rows] = (
                0.5 * b * b * (mine + kick * sim.atoms.f[:n][rows] / a)
                + kick * 0.5 * (b * claimed - last)
                + (b * a * 0.5 + sim.dt * 0.25 / self.damp / b) * theirs
            )
        else:
            v[rows] = theirs
        other[rows] = mine
