"""fix ID GROUP nvt temp Tstart Tstop Tdamp [tchain M] [tloop N] [drag D]: velocity Verlet with a chain of Nose-Hoover thermostats.

    v' = f/m - eta0' v,  Q0 eta0'' = dof kB (T - target) - ...,  Q0 = dof kB target Tdamp^2,  Qk = kB target Tdamp^2

scalar: energy of the chain, which added to the total energy is conserved; vector: eta and eta' of each link, then their potential
and kinetic energies. Source: LAMMPS manual, fix_nh.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.thermostat import Thermostat, ramp
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_PRESSURE = ("iso", "aniso", "tri", "x", "y", "z", "xy", "xz", "yz")
_ELSEWHERE = (
    "couple", "pchain", "ploop", "nreset", "mtk", "ptemp", "dilate", "fixedpoint", "scalexy", "scalexz", "scaleyz", "flip",
    "update", "psllod", "eta", "etap",
)  # fmt: skip


@FIXES.register("nvt")
class NVT(Thermostat):
    style = "nvt"
    integrates = True
    extensive_scalar = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        self.start, self.stop, self.damp = Quantity(), 0.0, 0.0
        self.links, self.loops, self.drag = 3, 1, 0.0
        pressure = None
        while len(args):
            key = args.word()
            if key.text in _PRESSURE:
                pressure = key
                args.need(3, key.text)
                args.at += 3
            else:
                self._keyword(args, key)
        if self.damp == 0.0 and not self.start.value:
            args.fail("Temperature control must be used with fix nvt", args.owner, hint="temp Tstart Tstop Tdamp")
        if pressure is not None:
            args.fail("Pressure control can not be used with fix nvt", pressure, hint="fix npt")
        if self.damp <= 0.0:
            args.fail("Fix nvt damping parameters must be > 0.0", args.owner)
        self.eta, self.speed, self.push = ([0.0] * self.links for _ in range(3))
        self.mass = [0.0] * self.links
        self.length = 4 * self.links
        self._now = self._dof = self._goal = 0.0
        self.measure_group(sim, group, bit)

    def _keyword(self, args: Args, key: Word) -> None:
        if key.text == "temp":
            args.need(3, "temp")
            words = [args.word() for _ in range(3)]
            start, self.stop, self.damp = (args.as_number(word) for word in words)
            self.start = Quantity(start)
            if start <= 0.0 or self.stop <= 0.0:
                args.fail("Target temperature for fix nvt cannot be 0.0", words[0])
            return
        if key.text in _ELSEWHERE:
            raise Unsupported(f"LAMMPS has fix nvt keyword {key.text}, pylmp's native engines do not", key.span)
        if key.text not in ("tchain", "tloop", "drag"):
            args.fail(f"Unknown fix nvt keyword: {key.text}", key, hint="temp tchain tloop drag")
        args.need(1, key.text)
        if key.text == "drag":
            self.drag = args.number()
            if self.drag < 0.0:
                args.fail(f"Invalid fix nvt drag argument: {self.drag:g}")
            return
        value = args.integer()
        if value < (1 if key.text == "tchain" else 0):
            args.fail(f"Invalid fix nvt {key.text} argument: {value}")
        if key.text == "tchain":
            self.links = value
        else:
            self.loops = value

    def warn_group(self, sim: Simulation, found: Any) -> None:
        if found.bit != 1:
            sim.console.warning("Temperature for fix modify is not for group all")

    # ---- a run ----------------------------------------------------------------------------------------------

    def setup(self, sim: Simulation) -> None:
        self._measure(sim)
        self._goal = ramp(sim, self.start.value, self.stop)
        self._weigh(sim)
        for k in range(1, self.links):
            self.push[k] = self._pushed(sim, k)

    def _measure(self, sim: Simulation) -> None:
        compute = self.compute(sim)
        self._now, self._dof = compute.scalar(sim), compute.dof(sim)

    def _weigh(self, sim: Simulation) -> None:
        frequency = 1.0 / self.damp
        heat = sim.units.boltz * self._goal
        self.mass = [heat / (frequency * frequency)] * self.links
        self.mass[0] = self._dof * sim.units.boltz * self._goal / (frequency * frequency)

    def _pushed(self, sim: Simulation, k: int) -> float:
        """Acceleration of link k > 0 by the one before it."""
        return (self.mass[k - 1] * self.speed[k - 1] * self.speed[k - 1] - sim.units.boltz * self._goal) / self.mass[k]

    def initial_integrate(self, sim: Simulation) -> None:
        self._goal = ramp(sim, self.start.value, self.stop)
        self._chain(sim)
        rows, n = self.members(sim), sim.atoms.n
        self._kick(sim)
        sim.atoms.x[:n][rows] += sim.dt * sim.atoms.v[:n][rows]

    def final_integrate(self, sim: Simulation) -> None:
        self._kick(sim)
        self._measure(sim)
        self._chain(sim)

    def _kick(self, sim: Simulation) -> None:
        rows, n = self.members(sim), sim.atoms.n
        kick = (0.5 * sim.dt * sim.units.ftm2v) / sim.masses()[rows]
        sim.atoms.v[:n][rows] += kick[:, None] * sim.atoms.f[:n][rows]

    def _chain(self, sim: Simulation) -> None:
        """Half a step of the thermostats, and what they do to the velocities."""
        boltz, dt, speed = sim.units.boltz, sim.dt, self.speed
        half, quarter, eighth = 0.5 * dt, 0.25 * dt, 0.125 * dt
        drag = 1.0 - (dt * (1.0 / self.damp) * self.drag / self.loops) if self.loops else 1.0
        wanted = self._dof * boltz * self._goal
        self._weigh(sim)
        kinetic = self._dof * boltz * self._now
        self.push[0] = (kinetic - wanted) / self.mass[0] if self.mass[0] > 0.0 else 0.0
        part = 1.0 / self.loops if self.loops else 0.0
        for _ in range(self.loops):
            slowed = 1.0
            for k in range(self.links - 1, -1, -1):
                slowed = math.exp(-part * eighth * (speed[k + 1] if k + 1 < self.links else 0.0))
                speed[k] *= slowed
                speed[k] += self.push[k] * part * quarter
                speed[k] *= drag
                speed[k] *= slowed
            factor = math.exp(-part * half * speed[0])
            self.scale(sim, self.members(sim), factor)
            self._now *= factor * factor
            kinetic = self._dof * boltz * self._now
            self.push[0] = (kinetic - wanted) / self.mass[0] if self.mass[0] > 0.0 else 0.0
            for k in range(self.links):
                self.eta[k] += part * half * speed[k]
            speed[0] *= slowed
            speed[0] += self.push[0] * part * quarter
            speed[0] *= slowed
            for k in range(1, self.links):
                slowed = math.exp(-part * eighth * (speed[k + 1] if k + 1 < self.links else 0.0))
                speed[k] *= slowed
                self.push[k] = self._pushed(sim, k)
                speed[k] += self.push[k] * part * quarter
                speed[k] *= slowed

    # ---- what others read -----------------------------------------------------------------------------------

    def _energies(self, sim: Simulation) -> tuple[list[float], list[float]]:
        heat = sim.units.boltz * self._goal
        potential = [heat * eta for eta in self.eta]
        potential[0] = self._dof * sim.units.boltz * self._goal * self.eta[0]
        return potential, [0.5 * mass * v * v for mass, v in zip(self.mass, self.speed, strict=True)]

    def scalar(self, sim: Simulation) -> float:
        potential, kinetic = self._energies(sim)
        energy = potential[0] + kinetic[0]
        for k in range(1, self.links):
            energy += potential[k] + kinetic[k]
        return energy

    def vector(self, sim: Simulation) -> Floats:
        potential, kinetic = self._energies(sim)
        return np.array([*self.eta, *self.speed, *potential, *kinetic])

    # ---- restart files --------------------------------------------------------------------------------------

    def state(self, sim: Simulation) -> bytes | None:
        return np.array([1.0, float(self.links), *self.eta, *self.speed, 0.0]).tobytes()

    def restore(self, sim: Simulation, state: bytes) -> None:
        values = np.frombuffer(state).tolist()
        if values[0] and int(values[1]) == self.links:
            self.eta = values[2 : 2 + self.links]
            self.speed = values[2 + self.links : 2 + 2 * self.links]
