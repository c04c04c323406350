"""fix ID GROUP move MODE values ... [units lattice|box]: atoms follow a path, whatever the forces.

    linear Vx Vy Vz                      x = x0 + V t
    wiggle Ax Ay Az T                    x = x0 + A sin(2 pi t/T)
    rotate Px Py Pz Rx Ry Rz T           around the axis R through P, once in T
    transrot Vx Vy Vz Px ... Rz T        both
    variable v_x v_y v_z v_vx v_vy v_vz  x = x0 + variable; velocities as the others say

x0, unwrapped, is where an atom was when the fix was defined. A component given as NULL moves freely, by velocity Verlet.
per_atom: x0. Source: LAMMPS manual, fix_move.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Atoms, Floats
from pylmp.model.fix import Fix
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args

_TURN = 2.0 * math.pi
_WORDS = {"linear": 3, "wiggle": 4, "rotate": 7, "transrot": 10, "variable": 6}
_MISSING = "Expected floating point parameter instead of NULL or empty string in input script or data file"
Rows = NDArray[np.bool_]
Target = tuple[Any, Any]  # of one component: position and velocity, None where the path does not say


class Path(Protocol):
    """free: for each component, whether it moves by velocity Verlet."""

    free: list[bool]

    def scale(self, spacing: tuple[float, float, float]) -> None:
        """Lattice units to distances."""

    def targets(self, sim: Simulation, rows: Rows, start: Floats, time: float) -> list[Target]:
        """Where atoms that were at start (k, 3) are after time."""


class Line:
    """linear, and wiggle with a period."""

    def __init__(self, sizes: list[Quantity], period: float = 0.0) -> None:
        self.sizes = [None if size.absent else size.value for size in sizes]
        self.free = [size is None for size in self.sizes]
        self.period = period

    def scale(self, spacing: tuple[float, float, float]) -> None:
        self.sizes = [None if size is None else size * s for size, s in zip(self.sizes, spacing, strict=True)]

    def targets(self, sim: Simulation, rows: Rows, start: Floats, time: float) -> list[Target]:
        result: list[Target] = []
        for d, size in enumerate(self.sizes):
            if size is None:
                result.append((None, None))
            elif self.period:
                omega = _TURN / self.period
                result.append((start[:, d] + size * math.sin(omega * time), size * omega * math.cos(omega * time)))
            else:
                result.append((start[:, d] + size * time, size))
        return result


@dataclass
class Turn:
    """rotate, and transrot with a velocity."""

    center: list[float]
    axis: list[float]
    period: float
    velocity: list[float] | None = None

    def __post_init__(self) -> None:
        a, b, c = self.axis
        length = math.sqrt(a * a + b * b + c * c)
        self.unit = [q / length for q in self.axis] if length else []
        self.free = [False] * 3

    def scale(self, spacing: tuple[float, float, float]) -> None:
        self.center = [p * s for p, s in zip(self.center, spacing, strict=True)]
        if self.velocity:
            self.velocity = [v * s for v, s in zip(self.velocity, spacing, strict=True)]

    def targets(self, sim: Simulation, rows: Rows, start: Floats, time: float) -> list[Target]:
        omega = _TURN / self.period
        cosine, sine = math.cos(omega * time), math.sin(omega * time)
        p, r = self.center, self.unit
        d = [start[:, k] - p[k] for k in range(3)]
        along = d[0] * r[0] + d[1] * r[1] + d[2] * r[2]
        c = [along * r[k] for k in range(3)]
        a = [d[k] - c[k] for k in range(3)]
        swung = [u * cosine + w * sine for u, w in zip(a, _cross(r, a), strict=True)]
        result: list[Target] = []
        for k, turning in enumerate(_cross(r, swung)):
            x, v = p[k] + c[k] + swung[k], omega * turning
            if self.velocity:
                x, v = x + self.velocity[k] * time, v + self.velocity[k]
            result.append((x, v))
        return result


class Given:
    """variable: displacements and velocities."""

    def __init__(self, quantities: list[Quantity]) -> None:
        self.quantities = quantities
        self.free = [quantities[d].absent and quantities[d + 3].absent for d in range(3)]

    def scale(self, spacing: tuple[float, float, float]) -> None:
        """Variables are distances as they are."""

    def targets(self, sim: Simulation, rows: Rows, start: Floats, time: float) -> list[Target]:
        values: list[Any] = [None if q.absent else q.numbers(sim) for q in self.quantities]
        values = [v[rows] if isinstance(v, np.ndarray) else v for v in values]
        return [(None if values[d] is None else start[:, d] + values[d], values[d + 3]) for d in range(3)]


def _cross(r: list[float], a: list[Floats]) -> list[Floats]:
    return [r[1] * a[2] - r[2] * a[1], r[2] * a[0] - r[0] * a[2], r[0] * a[1] - r[1] * a[0]]


@FIXES.register("move")
class Move(Fix):
    style = "move"
    integrates = True
    columns = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        mode = args.word()
        if mode.text not in _WORDS:
            args.fail(f"Unknown fix move mode {mode.text}", mode, hint=" ".join(_WORDS))
        if mode.text == "transrot" and 7 <= len(args) < _WORDS["transrot"]:
            args.fail(_MISSING, hint="Vx Vy Vz Px Py Pz Rx Ry Rz period")
        args.need(_WORDS[mode.text], mode.text)
        self.path = self._read(args, mode.text)
        spacing = sim.spacing
        while len(args):
            key = args.word()
            if key.text not in ("units", "update"):
                args.fail(f"Unknown fix move keyword {key.text}", key, hint="units")
            args.need(1, key.text)
            value = args.word()
            if key.text == "update":
                if value.text != "dipole":
                    args.fail(f"Unkown fix move update argument {value.text}", value)
                raise Unsupported("LAMMPS has fix move update dipole, pylmp's native engines do not", value.span)
            if value.text not in ("box", "lattice"):
                args.fail(f"Unknown fix move units setting {value.text}", value, hint="box or lattice")
            spacing = sim.spacing if value.text == "lattice" else (1.0, 1.0, 1.0)
        self.path.scale(spacing)
        self._check(sim, args, mode.text)
        self.began = sim.step
        self._name = f"fix move {identity}"
        atoms, rows = sim.atoms, self.members(sim)
        start = np.zeros((atoms.capacity, 3))
        start[: atoms.n][rows] = sim.box.unwrap(atoms.x[: atoms.n][rows], atoms.image[: atoms.n][rows])
        atoms.extra[self._name] = start
        atoms.newcomers[self._name] = lambda atoms, rows: self._newcomer(sim, atoms, rows)

    def reset_dt(self, sim: Simulation) -> None:
        raise ScriptError("Resetting timestep size is not allowed with fix move", hint=f"unfix {self.id} first")

    @staticmethod
    def _read(args: Args, mode: str) -> Path:
        if mode == "variable":
            for word in args.words[args.at : args.at + 6]:
                if word.text != "NULL" and not word.text.startswith("v_"):
                    args.fail("Argument must be either NULL or variable reference", word)
            return Given([Quantity.read(args, null=True) for _ in range(6)])
        if mode in ("linear", "wiggle"):
            sizes = [Quantity(absent=True) if args.take("NULL") else Quantity(args.number()) for _ in range(3)]
            if mode == "linear":
                return Line(sizes)
            word = args.word()
            period = args.as_number(word)
            if period <= 0.0:
                args.fail(f"Illegal fix move wiggle period {word}", word, hint="a positive time")
            return Line(sizes, period)
        velocity = [args.number() for _ in range(3)] if mode == "transrot" else None
        center, axis = [args.number() for _ in range(3)], [args.number() for _ in range(3)]
        word = args.word()
        period = args.as_number(word)
        if period <= 0.0:
            args.fail(f"Illegal fix move rotate period {word}", word, hint="a positive time")
        return Turn(center, axis, period, velocity)

    def _check(self, sim: Simulation, args: Args, mode: str) -> None:
        path = self.path
        flat = sim.dimension == 2
        if flat and isinstance(path, Line) and path.sizes[2] not in (None, 0.0):
            args.fail(f"Fix move cannot set {mode} z motion for 2d problem", args.owner)
        if flat and isinstance(path, Given) and not path.free[2]:
            args.fail("Fix move cannot define z or vz variable for 2d problem", args.owner, hint="NULL")
        if not isinstance(path, Turn):
            return
        if flat and path.velocity and path.velocity[2] != 0.0:
            args.fail("Fix move cannot set linear z motion for 2d problem", args.owner)
        if flat and (path.axis[0] != 0.0 or path.axis[1] != 0.0):
            args.fail("Fix move cannot rotate around non z-axis for 2d problem", args.owner, hint="0 0 1")
        if not path.unit:
            args.fail("Zero length rotation vector with fix move", args.owner)

    def _newcomer(self, sim: Simulation, atoms: Atoms, rows: slice) -> Floats:
        """Where a new atom of the group would have begun, to be now where it is; under transrot LAMMPS only turns it back."""
        x = atoms.x[rows].copy()
        if not self.bit & 1:
            return np.zeros_like(x)
        path, back = self.path, -(sim.step - self.began) * sim.dt
        if isinstance(path, Turn) and path.velocity:
            path = Turn(path.center, path.axis, path.period)
        if isinstance(path, Given):
            if back != 0.0:
                raise ScriptError("Cannot add atoms with fix move style variable", hint="unfix comes first")
            return x
        for d, (target, _) in enumerate(path.targets(sim, np.ones(len(x), bool), x.copy(), back)):
            if target is not None:
                x[:, d] = target
        return x

    def removed(self, sim: Simulation) -> None:
        sim.atoms.extra.pop(self._name, None)
        sim.atoms.newcomers.pop(self._name, None)

    def init(self, sim: Simulation) -> None:
        if isinstance(self.path, Given):
            says = "Variable name {} for {} does not exist", "Variable name {} for {} is invalid style"
            for quantity in self.path.quantities:
                quantity.check(sim, "fix move", atoms=True, missing=says[0], invalid=says[1])

    def per_atom(self, sim: Simulation) -> Floats:
        return np.asarray(sim.atoms.extra[self._name][: sim.atoms.n], float)

    def state(self, sim: Simulation) -> bytes:
        return struct.pack("<d", self.began)

    def restore(self, sim: Simulation, state: bytes) -> None:
        self.began = int(struct.unpack("<d", state)[0])

    def atom_state(self, sim: Simulation) -> Floats:
        return self.per_atom(sim)

    def restore_atoms(self, sim: Simulation, values: Floats) -> None:
        sim.atoms.extra[self._name][: sim.atoms.n] = values

    # ---- every step -------------------------------------------------------------------------------------------

    def _kick(self, sim: Simulation, rows: Rows, d: int) -> None:
        atoms = sim.atoms
        atoms.v[: atoms.n][rows, d] += (0.5 * sim.dt * sim.units.ftm2v) / sim.masses()[rows] * atoms.f[: atoms.n][rows, d]

    def initial_integrate(self, sim: Simulation) -> None:
        atoms, rows = sim.atoms, self.members(sim)
        x, v = atoms.x[: atoms.n], atoms.v[: atoms.n]
        before, start = x[rows], self.per_atom(sim)[rows]
        if isinstance(self.path, Given):
            with self.reading(sim, sim.step + 1):
                targets = self.path.targets(sim, rows, start, 0.0)
        else:
            targets = self.path.targets(sim, rows, start, (sim.step - self.began) * sim.dt)
        for d, (position, velocity) in enumerate(targets):
            if position is None and velocity is None:
                self._kick(sim, rows, d)
                velocity = v[rows, d]
            elif velocity is not None:
                v[rows, d] = velocity
            x[rows, d] = position if position is not None else x[rows, d] + sim.dt * velocity
        new = x[rows]
        sim.box.near(new, before)
        x[rows] = new

    def final_integrate(self, sim: Simulation) -> None:
        rows = self.members(sim)
        for d in range(3):
            if self.path.free[d]:
                self._kick(sim, rows, d)
