"""fix ID GROUP langevin Tstart Tstop damp seed [scale TYPE RATIO] [tally yes|no] [zero yes|no] [gjf no|vfull|vhalf]: a heat bath.

    f += -(m/damp) v + sqrt(24 kB T m/(damp dt)) (u - 1/2), u uniform in (0, 1)

Tstart may be an equal-style or atom-style variable: the target itself. zero takes the mean random force out; gjf: model/gjf.py;
scalar, with tally: energy given to the bath since the start of the run. fix_modify temp names a compute whose drift is left alone.
Source: LAMMPS manual, fix_langevin.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.kernels.exact.langevin import CHUNK, drag_and_noise, ramp_up
from pylmp.kernels.random import STEPS, RanMars, room
from pylmp.kernels.store import kernel
from pylmp.model.atoms import Floats
from pylmp.model.gjf import Gjf
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.model.thermostat import Thermostat, ramp
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args, Word

_KEYWORDS = {"scale": 2, "zero": 1, "tally": 1, "gjf": 1, "angmom": 1, "omega": 1}
_NEGATIVE = "Fix langevin variable returned negative temperature"
_DEPRECATED = (
    "The GJF formulation in fix langevin is deprecated and will be removed soon. \n"
    "Please use fix gjf instead: https://docs.lammps.org/fix_gjf.html"
)


@FIXES.register("langevin")
class Langevin(Thermostat):
    style = "langevin"
    extensive_scalar = True
    per_atom = True
    unknown = "Could not find fix_modify temperature compute ID: {}"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) < 4:
            args.illegal(args.owner, hint="fix ID GROUP langevin Tstart Tstop damp seed")
        self.start, self.stop, self.damp = Quantity.read(args), args.number(), args.number()
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
        self.gjf: Gjf | None = None
        self._wants = ""  # what point particles lack
        while len(args):
            self._option(sim, args, args.word())
        self._drag = self._noise = np.zeros(sim.atom_types + 1)
        self._room = room(3 * CHUNK)
        self._push = np.zeros((1, 3))
        self._power = self._energy = 0.0
        self._found: Any = None  # the compute of fix_modify temp
        self._function: Any = None
        self._ramp: Any = ramp_up
        self._shape = (False, False)  # biased, each: what the kernel at hand was made for
        self._heat, self._hot = np.zeros(1), np.zeros((1, 3))
        self._call: Callable[[], float] = lambda: 0.0

    def _option(self, sim: Simulation, args: Args, key: Word) -> None:
        if len(args) < _KEYWORDS.get(key.text, 999):
            args.illegal(key, hint="scale TYPE RATIO, tally yes|no, zero yes|no, gjf no|vfull|vhalf")
        if key.text == "scale":
            kind = args.integer()
            ratio = args.number()
            if not 1 <= kind <= sim.atom_types:
                args.illegal(key)
            self.ratio[kind] = ratio
        elif key.text in ("zero", "tally"):
            setattr(self, key.text, args.yes())
        elif key.text == "gjf":
            value = args.word()
            if value.text not in ("no", "vfull", "vhalf"):
                args.illegal(value, hint="no, vfull or vhalf")
            if value.text != "no":
                sim.console.warning(_DEPRECATED)
                self.gjf = Gjf(sim, self.id, self.random, self.damp, value.text == "vfull")
        elif key.text == "omega":
            if args.yes():
                self._wants = "omega requires atom attribute omega"
        elif not args.take("no"):
            args.number()
            self._wants = "angmom requires atom style ellipsoid"

    def removed(self, sim: Simulation) -> None:
        super().removed(sim)
        if self.gjf is not None:
            self.gjf.removed(sim)

    # ---- a run ----------------------------------------------------------------------------------------------

    def functions(self) -> list[Any]:
        if self.gjf is not None:
            return self.gjf.functions()
        self._shape = self._biased(), self.start.per_atom
        self._function = drag_and_noise(self.bit == 1, len(self._drag) == 2, self.zero, self.tally, *self._shape)
        return [self._function, *([self._ramp] if self._ramps else [])]

    @property
    def _ramps(self) -> bool:
        return not self.start.varies and self.start.value != self.stop

    def _biased(self) -> bool:
        return bool(self.temperature) and self._found.bias

    def init(self, sim: Simulation) -> None:
        super().init(sim)
        if self._wants:
            raise ScriptError(f"Fix langevin {self._wants}", hint="atoms here are points: leave it out")
        self._found = self.compute(sim) if self.temperature else None
        if self.gjf is not None:
            self.gjf.init(sim)
            if self._biased():
                raise Unsupported(
                    "LAMMPS has fix langevin gjf with a compute that knows a drift, pylmp's native engines do not",
                    hint="fix_modify temp with compute temp, or no gjf",
                )
            before = sim.fixes[: sim.fixes.index(self)]
            if any(fix.style.startswith("nve") for fix in before):
                raise ScriptError("Fix langevin gjf should come before fix nve", hint="define fix langevin first")
        self._coefficients(sim)

    def reset_dt(self, sim: Simulation) -> None:
        if self._function is None:  # not yet in a run
            return
        if self.gjf is not None:
            self.gjf.init(sim)
        self._coefficients(sim)
        self.post_neighbor(sim)

    def _coefficients(self, sim: Simulation) -> None:
        """Drag and noise of each type."""
        units = sim.units
        self._drag, self._noise = np.zeros(sim.atom_types + 1), np.zeros(sim.atom_types + 1)
        for kind in range(1, sim.atom_types + 1):
            mass, ratio = float(sim.mass[kind]), float(self.ratio[kind])
            drag = -mass / self.damp / units.ftm2v
            noise = math.sqrt(mass) / units.ftm2v
            if self.gjf is not None:
                noise *= self.gjf.noise(sim)
            else:
                noise *= math.sqrt(24.0 * units.boltz / self.damp / sim.dt / units.mvv2e)
            self._drag[kind] = drag * (1.0 / ratio if ratio else math.inf)
            self._noise[kind] = noise * (1.0 / math.sqrt(ratio) if ratio > 0.0 else math.inf if ratio == 0.0 else math.nan)

    def post_neighbor(self, sim: Simulation) -> None:
        atoms = sim.atoms
        count = atoms.n if self.bit == 1 else int(self.members(sim).sum())
        if self.zero and count == 0:
            raise ScriptError("Cannot zero Langevin force of 0 atoms", hint="zero no, or a group with atoms")
        if len(self._push) < atoms.n:
            self._push = np.zeros((atoms.capacity, 3))
        if self.gjf is not None:
            return
        biased, each = self._shape
        self._heat = np.zeros(atoms.capacity if each else 1)
        self._hot = np.zeros((atoms.capacity, 3)) if biased else atoms.v
        self._call = kernel(self._function).bind(
            self._hot, atoms.f, atoms.type, atoms.mask, self._drag, self._noise, self._heat, self.random.table,
            self.random.state, *self._room, STEPS, self._push, self.bit, count, atoms.n,
        )  # fmt: skip

    def _target(self, sim: Simulation) -> Floats | float:
        """Square root of the target temperature: a number, or (n,) numbers."""
        if not self.start.varies:
            heat = ramp(sim, self.start.value, self.stop)
            return math.sqrt(heat) if heat >= 0.0 else math.nan
        with self.reading(sim, sim.step + 1):
            value = self.start.numbers(sim, self.members(sim))
        checked = value[self.members(sim)] if isinstance(value, np.ndarray) else np.array([value])
        if (checked < 0.0).any():
            raise ScriptError(_NEGATIVE, hint=f"v_{self.start.name} is below zero")
        with np.errstate(invalid="ignore"):
            return np.sqrt(value)

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        if self.gjf is not None or self.tally or self._biased() or self.start.varies:
            return None
        if hook != "post_force":
            return []
        if self._ramps:
            heat = kernel(self._ramp).bind(sim.ticks, sim.begin, sim.end, self.start.value, self.stop, self._heat)
            return [heat, self._call]
        self._heat[0] = self._target(sim)
        return [self._call]

    def post_force(self, sim: Simulation) -> None:
        heat = self._target(sim)
        if self._found is not None and self._found.bias:
            self._found.scalar(sim)
        if self.gjf is not None:
            self._push_gjf(sim, heat)
            return
        if self._shape[0]:
            rows = self.members(sim)
            self._hot[: sim.atoms.n][rows] = self.thermal(sim, rows)
        self._heat[: sim.atoms.n if self._shape[1] else 1] = heat
        self._call()

    def _push_gjf(self, sim: Simulation, heat: Floats | float) -> None:
        assert self.gjf is not None
        rows, kinds = self.members(sim), sim.atoms.type[: sim.atoms.n]
        noise = (self._noise[kinds] * heat)[rows]
        pull, random, claimed = self.gjf.push(sim, rows, self._drag[kinds][rows], noise)
        f = sim.atoms.f[: sim.atoms.n]
        f[rows] += pull + random
        if self.zero:
            mean = totals(random) / int(rows.sum())
            f[rows] -= mean
            claimed = claimed - mean
        self._push[: sim.atoms.n][rows] = claimed

    def setup(self, sim: Simulation) -> None:
        if self.gjf is None:
            self.post_force(sim)
            return
        rows = self.members(sim)
        self.gjf.before_setup(sim, rows)
        self.post_force(sim)
        self.gjf.after_setup(sim, rows)

    def initial_integrate(self, sim: Simulation) -> None:
        if self.gjf is not None:
            self.gjf.initial_integrate(sim, self.members(sim))

    def end_of_step(self, sim: Simulation) -> None:
        if self.tally:
            self._power = self._work(sim)
        if self.gjf is not None:
            rows = self.members(sim)
            self.gjf.end_of_step(sim, rows, self._push[: sim.atoms.n][rows])
        if self.tally:
            self._energy += self._power * sim.dt

    def _work(self, sim: Simulation) -> float:
        """Power of drag and noise."""
        rows = self.members(sim)
        velocity = sim.atoms.v[: sim.atoms.n] if self.gjf is None else self.gjf.other(sim)
        push, v = self._push[: sim.atoms.n][rows], velocity[rows]
        return total(push[:, 0] * v[:, 0] + push[:, 1] * v[:, 1] + push[:, 2] * v[:, 2])

    def scalar(self, sim: Simulation) -> float:
        """LAMMPS starts the count anew when it is asked at the first step of a run, and only then."""
        if not self.tally:
            return 0.0
        if sim.step == sim.begin:
            self._power = self._work(sim)
            self._energy = (0.5 if self.gjf is None else -0.5) * self._power * sim.dt
        return -(self._energy - 0.5 * self._power * sim.dt)
