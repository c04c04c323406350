"""fix ID GROUP langevin Tstart Tstop damp seed [scale TYPE RATIO] [tally yes|no] [zero yes|no]: a heat bath.

    f += -(m/damp) v + sqrt(24 kB T m/(damp dt)) (u - 1/2), u uniform in (0, 1)

zero takes the mean random force out; scalar, with tally: energy given to the bath since the start of the run.
Source: LAMMPS manual, fix_langevin.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.kernels.exact import integrate
from pylmp.kernels.random import RanMars
from pylmp.kernels.store import kernel
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args


@FIXES.register("langevin")
class Langevin(Fix):
    style = "langevin"
    extensive_scalar = True
    couples = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) < 4:
            args.illegal(args.owner, hint="fix ID GROUP langevin Tstart Tstop damp seed")
        first = args.peek()
        if first is not None and first.text.startswith("v_"):
            raise Unsupported(
                "LAMMPS has variable temperatures in fix langevin, pylmp's native engines do not", first.span
            )
        self.start, self.stop, self.damp = args.number(), args.number(), args.number()
        if self.damp <= 0.0:
            args.fail("Fix langevin period must be > 0.0", hint="damp is a time")
        seed = args.word()
        if args.as_integer(seed) <= 0:
            args.illegal(seed, hint="a seed from 1 to 900000000")
        if args.as_integer(seed) > 900000000:
            args.fail("Invalid seed for Marsaglia random # generator", seed, hint="a seed from 1 to 900000000")
        self.random = RanMars(args.as_integer(seed))
        self.ratio = np.ones(sim.atom_types + 1)
        self.zero = self.tally = False
        while len(args):
            self._option(sim, args)
        self._drag = self._noise = np.zeros(0)
        self._function = integrate.langevin(bit == 1, self.zero, self.tally)
        self._heat = np.zeros(1)
        self._push = np.zeros((1, 3))
        self._power = self._energy = 0.0
        self._call: Callable[[], float] = lambda: 0.0

    def _option(self, sim: Simulation, args: Args) -> None:
        key = args.word()
        if key.text == "scale" and len(args) >= 2:
            kind = args.integer()
            ratio = args.number()
            if not 1 <= kind <= sim.atom_types:
                args.illegal(key)
            self.ratio[kind] = ratio
        elif key.text == "zero" and len(args):
            self.zero = args.yes()
        elif key.text == "tally" and len(args):
            self.tally = args.yes()
        elif key.text in ("angmom", "gjf", "omega") and len(args):
            if args.word().text not in ("no", "off", "false"):
                raise Unsupported(f"LAMMPS has fix langevin {key.text}, pylmp's native engines do not", key.span)
        else:
            args.illegal(key, hint="scale TYPE RATIO, tally yes|no, zero yes|no")

    def functions(self) -> list[Any]:
        return [self._function]

    def init(self, sim: Simulation) -> None:
        units = sim.units
        self._drag, self._noise = np.zeros(sim.atom_types + 1), np.zeros(sim.atom_types + 1)
        for kind in range(1, sim.atom_types + 1):
            mass, ratio = float(sim.mass[kind]), float(self.ratio[kind])
            drag = -mass / self.damp / units.ftm2v
            noise = math.sqrt(mass) / units.ftm2v
            noise *= math.sqrt(24.0 * units.boltz / self.damp / sim.dt / units.mvv2e)
            self._drag[kind] = drag * (1.0 / ratio)
            self._noise[kind] = noise * (1.0 / math.sqrt(ratio))

    def post_neighbor(self, sim: Simulation) -> None:
        atoms = sim.atoms
        count = int(self.members(sim).sum())
        if self.zero and count == 0:
            raise ScriptError("Cannot zero Langevin force of 0 atoms", hint="zero no, or a group with atoms")
        if self.tally and len(self._push) < atoms.n:
            self._push = np.zeros((atoms.capacity, 3))
        self._call = kernel(self._function).bind(
            atoms.v, atoms.f, atoms.type, atoms.mask, self._drag, self._noise, self._heat, self.random.table,
            self.random.state, self._push, self.bit, count, atoms.n,
        )  # fmt: skip

    def post_force(self, sim: Simulation) -> None:
        part = 0.0 if sim.step == sim.begin else (sim.step - sim.begin) / (sim.end - sim.begin)
        self._heat[0] = math.sqrt(self.start + part * (self.stop - self.start))
        self._call()

    setup = post_force

    def end_of_step(self, sim: Simulation) -> None:
        if self.tally:
            self._power = self._work(sim)
            self._energy += self._power * sim.dt

    def _work(self, sim: Simulation) -> float:
        """Power of drag and noise."""
        rows = self.members(sim)
        push, v = self._push[: sim.atoms.n][rows], sim.atoms.v[: sim.atoms.n][rows]
        return total(push[:, 0] * v[:, 0] + push[:, 1] * v[:, 1] + push[:, 2] * v[:, 2])

    def scalar(self, sim: Simulation) -> float:
        """LAMMPS starts the count anew when it is asked at the first step of a run, and only then."""
        if not self.tally:
            return 0.0
        if sim.step == sim.begin:
            self._power = self._work(sim)
            self._energy = 0.5 * self._power * sim.dt
        return -(self._energy - 0.5 * self._power * sim.dt)
