"""Turning points about an axis, and the displacement and rotation of a region that variables drive.

Source: LAMMPS manual, displace_atoms.html and region.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.variables import EQUAL_STYLES, Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

Vector = tuple[float, float, float]


def unit(axis: Vector) -> Vector:
    """axis over its length, which is not 0."""
    a, b, c = axis
    length = math.sqrt(a * a + b * b + c * c)
    return a / length, b / length, c / length


def rotated(x: Floats, point: Vector, axis: Vector, angle: float) -> Floats:
    """(n, 3) points turned by angle (radians) about the line through point along the unit vector axis."""
    cosine, sine = math.cos(angle), math.sin(angle)
    r0, r1, r2 = axis
    d = x - np.array(point)
    along = d[:, 0] * r0 + d[:, 1] * r1 + d[:, 2] * r2
    c = along[:, None] * np.array(axis)
    a = d - c
    b = np.stack([r1 * a[:, 2] - r2 * a[:, 1], r2 * a[:, 0] - r0 * a[:, 2], r0 * a[:, 1] - r1 * a[:, 0]], axis=1)
    return np.asarray(np.array(point) + c + (a * cosine + b * sine))


@dataclass
class Motion:
    """``move`` and ``rotate`` of a region: names of equal-style variables, ``None`` where nothing moves.

    A displacement is in distance units also where the region is in lattice units (measured).
    shift angle    as they are now; point axis: of the rotation
    """

    style: str
    region: str
    moves: list[Word | None] = field(default_factory=list)
    rotates: Word | None = None
    point: Vector = (0.0, 0.0, 0.0)
    axis: Vector = (0.0, 0.0, 1.0)
    shift: Vector = (0.0, 0.0, 0.0)
    angle: float = 0.0

    def read_move(self, args: Args) -> None:
        self.moves = []
        for axis in "xyz":
            word = args.word()
            if word.text != "NULL" and not word.text.startswith("v_"):
                args.fail(f"Illegal region move {axis} displacement variable: {word.text}", word, hint="v_NAME or NULL")
            self.moves.append(None if word.text == "NULL" else word)

    def read_rotate(self, args: Args) -> None:
        word = args.word()
        if not word.text.startswith("v_"):
            args.fail("Illegal region command", word, hint="v_NAME, an angle in radians")
        self.rotates = word
        a, b, c, d, e, f = (args.number() for _ in range(6))
        self.point, self.axis = (a, b, c), (d, e, f)

    def finish(self, args: Args, scale: Vector) -> None:
        """Once all keywords are known: lattice units, the axis's length."""
        if self.rotates:
            a, b, c = self.point
            self.point = a * scale[0], b * scale[1], c * scale[2]
            if self.axis == (0.0, 0.0, 0.0):
                args.fail("Region cannot have 0 length rotation vector", self.rotates)
            self.axis = unit(self.axis)

    def check(self, sim: Simulation) -> None:
        """Raise ScriptError unless all variables are there and equal-style."""
        for place, word in enumerate((*self.moves, self.rotates)):
            if word is None:
                continue
            style = Variables(sim).style(word.text[2:])
            if style in EQUAL_STYLES:
                continue
            first = place == 0 and len(self.moves) > 0  # of three displacements
            why = "does not exist" if style is None else f"is {'invalid' if first else 'not equal'} style"
            raise ScriptError(
                f"Variable {word.text[2:]} for region {self.style} {self.region} {why}", word.span, manual="region.html",
                hint="an equal-style variable",
            )  # fmt: skip

    def update(self, sim: Simulation) -> None:
        """Evaluate the variables."""
        self.check(sim)
        values = Variables(sim)
        if self.moves:
            a, b, c = (values.number(word.text[2:]) if word else 0.0 for word in self.moves)
            self.shift = a, b, c
        if self.rotates:
            self.angle = values.number(self.rotates.text[2:])

    def undo(self, x: Floats) -> Floats:
        """Where points x (n, 3) would be had the region not moved."""
        if self.moves:
            x = x - np.array(self.shift)
        if self.rotates:
            x = rotated(x, self.point, self.axis, -self.angle)
        return x

    def redo(self, x: Floats) -> Floats:
        """Where points x of the region at rest are now."""
        if self.rotates:
            x = rotated(x, self.point, self.axis, self.angle)
        if self.moves:
            x = x + np.array(self.shift)
        return x
