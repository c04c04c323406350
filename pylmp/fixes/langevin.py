"""fix ID GROUP langevin Tstart Tstop damp seed [scale TYPE RATIO] [zero yes|no]: a heat bath.

    f += -(m/damp) v + sqrt(24 kB T m/(damp dt)) (u - 1/2), u uniform in (0, 1)

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
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


@FIXES.register("langevin")
class Langevin(Fix):
    style = "langevin"

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
        if not 0 < args.as_integer(seed) <= 900000000:
            args.illegal(seed, hint="a seed from 1 to 900000000")
        self.random = RanMars(args.as_integer(seed))
        self.ratio = np.ones(sim.atom_types + 1)
        while len(args):
            self._option(sim, args)
        self._drag = self._noise = np.zeros(0)
        self._function = integrate.langevin(bit == 1)
        self._heat = np.zeros(1)
        self._call: Callable[[], float] = lambda: 0.0

    def _option(self, sim: Simulation, args: Args) -> None:
        key = args.word()
        if key.text == "scale" and len(args) >= 2:
            kind = args.integer()
            ratio = args.number()
            if not 1 <= kind <= sim.atom_types:
                args.illegal(key)
            self.ratio[kind] = ratio
        elif key.text in ("angmom", "gjf", "omega", "tally", "zero"):
            word = args.word() if len(args) else key
            if word.text not in ("no", "off", "false"):
                raise Unsupported(f"LAMMPS has fix langevin {key.text}, pylmp's native engines do not", key.span)
        else:
            args.illegal(key, hint="scale")

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
        self._call = kernel(self._function).bind(
            atoms.v, atoms.f, atoms.type, atoms.mask, self._drag, self._noise, self._heat, self.random.table,
            self.random.state, self.bit, atoms.n,
        )  # fmt: skip

    def post_force(self, sim: Simulation) -> None:
        part = 0.0 if sim.step == sim.begin else (sim.step - sim.begin) / (sim.end - sim.begin)
        self._heat[0] = math.sqrt(self.start + part * (self.stop - self.start))
        self._call()

    setup = post_force
