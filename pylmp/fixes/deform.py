"""fix ID GROUP deform N x|y|z erate|final|scale|delta|vel values... [remap x|none] [units lattice|box]

The box changes during the run; with remap x the atoms of the group move with it. Rates refer to the box at the start of each run.
Source: LAMMPS manual, fix_deform.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from dataclasses import dataclass

from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args

_WORDS = {"final": 2, "delta": 2, "scale": 1, "vel": 1, "erate": 1}


@dataclass
class _Direction:
    """style and values of one direction; from and to: (lo, hi) at the start and the end of the run."""

    style: str
    values: list[float]
    start: tuple[float, float] = (0.0, 0.0)
    stop: tuple[float, float] = (0.0, 0.0)


@FIXES.register("deform")
class Deform(Fix):
    style = "deform"
    changes_box = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.every = args.integer()
        if self.every <= 0:
            args.fail("Fix deform Nevery must be > 0", hint="every so many steps")
        self.directions: dict[int, _Direction] = {}
        self.remap = True
        lattice = True
        while len(args):
            key = args.word()
            if key.text in ("x", "y", "z"):
                self._direction(args, "xyz".index(key.text))
            elif key.text in ("xy", "xz", "yz", "flip"):
                raise Unsupported(f"LAMMPS has fix deform {key.text}, pylmp's native engines do not", key.span)
            elif key.text == "remap":
                args.need(1, key.text)
                value = args.word()
                if value.text == "v":
                    raise Unsupported("LAMMPS has fix deform remap v, pylmp's native engines do not", value.span)
                if value.text not in ("x", "none"):
                    args.fail(f"Illegal fix deform remap command: {value.text}", value, hint="x or none")
                self.remap = value.text == "x"
            elif key.text == "units":
                args.need(1, key.text)
                value = args.word()
                if value.text not in ("box", "lattice"):
                    args.fail(f"Illegal fix deform units command: {value.text}", value, hint="box or lattice")
                lattice = value.text == "lattice"
            else:
                args.fail(f"Unknown fix deform keyword: {key.text}", key, hint="x y z remap units")
        for axis, direction in self.directions.items():
            direction.start = float(sim.box.lo[axis]), float(sim.box.hi[axis])
            if any(letter in "sm" for letter in sim.box.boundary[axis]):
                args.fail("Cannot use fix deform on a shrink-wrapped boundary", args.owner)
            if lattice and direction.style in ("final", "delta", "vel"):
                direction.values = [v * sim.spacing[axis] for v in direction.values]

    def _direction(self, args: Args, axis: int) -> None:
        style = args.word()
        if style.text in ("trate", "volume", "wiggle", "variable", "pressure", "pressure/mean"):
            raise Unsupported(f"LAMMPS has fix deform {style.text}, pylmp's native engines do not", style.span)
        if style.text not in _WORDS:
            args.fail(f"Illegal fix deform command argument: {style.text}", style, hint="erate final scale delta vel")
        if len(args) < _WORDS[style.text]:
            args.fail(f"Illegal fix deform {style.text} command: missing argument(s)", style)
        self.directions[axis] = _Direction(style.text, [args.number() for _ in range(_WORDS[style.text])])

    def init(self, sim: Simulation) -> None:
        """Where each face is at the end of this run."""
        if sum(fix.changes_box for fix in sim.fixes) > 1:
            raise ScriptError("More than one fix deform", hint="one fix deform takes several directions")
        time = (sim.end - sim.begin) * sim.dt
        for axis, direction in self.directions.items():
            if sim.step == sim.begin:  # else an earlier part of the same ramp, from where the box was when the fix was defined
                direction.start = float(sim.box.lo[axis]), float(sim.box.hi[axis])
            lo, hi = direction.start
            value = direction.values[0]
            if direction.style == "final":
                direction.stop = value, direction.values[1]
            elif direction.style == "delta":
                direction.stop = lo + value, hi + direction.values[1]
            elif direction.style == "scale":
                shift = 0.5 * value * (hi - lo)
                direction.stop = 0.5 * (lo + hi) - shift, 0.5 * (lo + hi) + shift
            elif direction.style == "vel":
                direction.stop = lo - 0.5 * time * value, hi + 0.5 * time * value
            else:
                shift = 0.5 * time * value * (hi - lo)
                direction.stop = lo - shift, hi + shift
                if direction.stop[1] <= direction.stop[0]:
                    raise ScriptError(
                        "Final box dimension due to fix deform is < 0.0", hint="a smaller rate or fewer steps"
                    )

    def end_of_step(self, sim: Simulation) -> None:
        """Every direction, changing or not, makes the round trip through scaled coordinates."""
        part = 0.0 if sim.step == sim.begin else (sim.step - sim.begin) / (sim.end - sim.begin)
        box, atoms = sim.box, sim.atoms
        rows = self.members(sim)
        x = atoms.x[: atoms.n]
        for axis in range(3):
            lo, hi = float(box.lo[axis]), float(box.hi[axis])
            if self.remap:
                x[rows, axis] = (1.0 / (hi - lo)) * (x[rows, axis] - lo)
            direction = self.directions.get(axis)
            if direction is not None:
                (lo0, hi0), (lo1, hi1) = direction.start, direction.stop
                lo, hi = lo0 + part * (lo1 - lo0), hi0 + part * (hi1 - hi0)
                box.lo[axis], box.hi[axis] = lo, hi
            if self.remap:
                x[rows, axis] = (hi - lo) * x[rows, axis] + lo
