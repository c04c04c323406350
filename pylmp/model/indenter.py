"""The shapes that fix indent presses against atoms: how deep an atom is inside one, and which way it is pushed.

A shape is asked with (n, 3) positions and answers depth (n,), negative where it acts, and direction (n, 3) with its length (n,).
Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.quantity import Quantity
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

Answer = tuple[Floats, Floats, Floats]


@dataclass
class Shape:
    """numbers: in the order of the script's words. axis: of a cylinder, cone or plane. inward: atoms are kept inside (side in)."""

    numbers: list[Quantity]
    axis: int = -1
    inward: bool = False

    name = ""
    words = 0
    energy_sign = 1.0  # LAMMPS gets that of a cone wrong

    @classmethod
    def read(cls, args: Args) -> Shape:
        args.need(cls.words, cls.name)
        axis = read_axis(args, cls.name) if cls.name != "sphere" else -1
        return cls([Quantity.read(args) for _ in range(cls.words - (axis >= 0))], axis)

    def scales(self) -> list[int]:
        """Which lattice spacing each number is given in."""
        raise NotImplementedError

    def scale(self, spacing: tuple[float, float, float]) -> None:
        """Lattice units: numbers are scaled, variables are not."""
        for quantity, d in zip(self.numbers, self.scales(), strict=True):
            if not quantity.varies:
                quantity.value *= spacing[d]

    def now(self, sim: Simulation) -> list[float]:
        return [quantity.number(sim) for quantity in self.numbers]

    def answer(self, sim: Simulation, x: Floats) -> Answer:
        raise NotImplementedError

    @property
    def across(self) -> list[int]:
        return [d for d in range(3) if d != self.axis]


class Sphere(Shape):
    name, words = "sphere", 4

    def scales(self) -> list[int]:
        return [0, 1, 2, 0]

    def answer(self, sim: Simulation, x: Floats) -> Answer:
        a, b, c, radius = self.now(sim)
        check_radius(radius, "sphere radius")
        return self._round(sim, x, np.array([[a, b, c]]), radius)

    def _round(self, sim: Simulation, x: Floats, center: Floats, radius: float) -> Answer:
        d = away(sim, x, center, self.axis)
        r = np.sqrt(d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2])
        return radius - r if self.inward else r - radius, d, r


class Cylinder(Sphere):
    name, words = "cylinder", 4

    def scales(self) -> list[int]:
        return [*self.across, 0]

    def answer(self, sim: Simulation, x: Floats) -> Answer:
        a, b, radius = self.now(sim)
        check_radius(radius, "cylinder radius")
        center = sim.box.lo[None, :].copy()
        center[0, self.across] = a, b
        return self._round(sim, x, center, radius)


class Cone(Shape):
    name, words = "cone", 7
    energy_sign = -1.0

    def scales(self) -> list[int]:
        return [*self.across, 0, 0, self.axis, self.axis]

    def answer(self, sim: Simulation, x: Floats) -> Answer:
        a, b, low_radius, high_radius, lo, hi = self.now(sim)
        check_radius(low_radius, "cone lower radius")
        check_radius(high_radius, "cone high radius")
        middle = 0.5 * (lo + hi)
        center = np.empty((1, 3))
        center[0, self.across] = a, b
        center[0, self.axis] = middle
        d = away(sim, x, center)
        half = 0.5 * (hi - lo)
        lo, hi = center[0, self.axis] - half, center[0, self.axis] + half
        p = center + d  # rounded once more, as is the way back
        e = p - center
        u, v = (e[:, k] for k in self.across)
        out = np.sqrt(u * u + v * v)
        along = p[:, self.axis]
        width = low_radius + (along - lo) * (high_radius - low_radius) / (hi - lo)
        inside = (out <= width) & (along >= lo) & (along <= hi)
        with np.errstate(divide="ignore", invalid="ignore"):
            first, second = self._rim(center, e, out, low_radius, lo), self._rim(center, e, out, high_radius, hi)
            depth = to_segment(p, first, second)
            if self.inward:
                for rim, end in ((first, lo), (second, hi)):
                    foot = np.broadcast_to(center, p.shape).copy()
                    foot[:, self.axis] = end
                    depth = least(depth, to_segment(p, foot, rim))
            else:
                depth = least(least(depth, along - lo), hi - along)
        r = np.sqrt(d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2])
        return np.where(inside == self.inward, 1.0, -depth), d, r

    def _rim(self, center: Floats, d: Floats, out: Floats, radius: float, end: float) -> Floats:
        """(n, 3) the point of an end's rim in the direction of each atom."""
        rim = np.empty_like(d)
        for k in self.across:
            rim[:, k] = center[0, k] + radius * d[:, k] / out
        rim[:, self.axis] = end
        return rim


class Plane(Shape):
    name, words = "plane", 3

    @classmethod
    def read(cls, args: Args) -> Shape:
        args.need(3, "plane")
        axis = read_axis(args, "plane")
        place = Quantity.read(args)
        side = args.word()
        if side.text not in ("lo", "hi"):
            args.fail(f"Unknown fix indent plane argument: {side.text}", side, hint="lo or hi")
        shape = cls([place], axis)
        shape.high = side.text == "hi"
        return shape

    high = False

    def scales(self) -> list[int]:
        return [self.axis]

    def answer(self, sim: Simulation, x: Floats) -> Answer:
        (place,) = self.now(sim)
        sign = 1.0 if self.high else -1.0
        direction = np.zeros_like(x)
        direction[:, self.axis] = -sign
        return sign * (place - x[:, self.axis]), direction, np.ones(len(x))


SHAPES: dict[str, type[Shape]] = {shape.name: shape for shape in (Sphere, Cylinder, Cone, Plane)}


def read_axis(args: Args, shape: str) -> int:
    word = args.word()
    if word.text not in ("x", "y", "z"):
        args.fail(f"Unknown fix indent {shape} argument: {word.text}", word, hint="x, y or z")
    return "xyz".index(word.text)


def check_radius(radius: float, what: str) -> None:
    if radius < 0.0:
        raise ScriptError(f"Illegal fix indent {what}: {shortest(radius)}", hint="a length")


def away(sim: Simulation, x: Floats, center: Floats, axis: int = -1) -> Floats:
    """(n, 3) from the periodic image of center in the box to the nearest image of each atom; 0 along axis. center moves there."""
    sim.box.remap(center, np.zeros((1, 3), np.int64))
    d = x - center
    if axis >= 0:
        d[:, axis] = 0.0
    return sim.box.minimum_image(d)


def to_segment(p: Floats, a: Floats, b: Floats) -> Floats:
    """(n,) distance of each point to the segment from a to b; nan where it has no length."""
    w, v = b - a, p - a
    t = (v[:, 0] * w[:, 0] + v[:, 1] * w[:, 1] + v[:, 2] * w[:, 2]) / (w[:, 0] * w[:, 0] + w[:, 1] * w[:, 1] + w[:, 2] * w[:, 2])
    nearest = a + t[:, None] * w
    nearest = np.where((t <= 0.0)[:, None], a, np.where((t >= 1.0)[:, None], b, nearest))
    e = p - nearest
    return np.asarray(np.sqrt(e[:, 0] * e[:, 0] + e[:, 1] * e[:, 1] + e[:, 2] * e[:, 2]))


def least(a: Floats, b: Floats) -> Floats:
    """The smaller of each pair; b where one is nan, as C's a < b ? a : b has it."""
    return np.where(a < b, a, b)
