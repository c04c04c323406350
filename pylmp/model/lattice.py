"""Lattices: where sites are, and the spacings that scale coordinates given in lattice units.

Source: LAMMPS manual, lattice.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import product

Vector = tuple[float, float, float]
Rows = tuple[Vector, Vector, Vector]

_H = 0.5
BASES: dict[str, tuple[Vector, ...]] = {
    "sc": ((0.0, 0.0, 0.0),),
    "bcc": ((0.0, 0.0, 0.0), (_H, _H, _H)),
    "fcc": ((0.0, 0.0, 0.0), (_H, _H, 0.0), (_H, 0.0, _H), (0.0, _H, _H)),
    "sq": ((0.0, 0.0, 0.0),),
    "sq2": ((0.0, 0.0, 0.0), (_H, _H, 0.0)),
    "hex": ((0.0, 0.0, 0.0), (_H, _H, 0.0)),
    "hcp": ((0.0, 0.0, 0.0), (_H, _H, 0.0), (_H, 5.0 / 6.0, _H), (0.0, 1.0 / 3.0, _H)),
    "diamond": (
        (0.0, 0.0, 0.0), (0.0, _H, _H), (_H, 0.0, _H), (_H, _H, 0.0),
        (0.25, 0.25, 0.25), (0.25, 0.75, 0.75), (0.75, 0.25, 0.75), (0.75, 0.75, 0.25),
    ),
}  # fmt: skip
FLAT = ("sq", "sq2", "hex")
_UNIT: Rows = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def primitive(style: str) -> Rows:
    """a1, a2, a3 of a style."""
    if style == "hex":
        return (1.0, 0.0, 0.0), (0.0, math.sqrt(3.0), 0.0), (0.0, 0.0, 1.0)
    if style == "hcp":
        return (1.0, 0.0, 0.0), (0.0, math.sqrt(3.0), 0.0), (0.0, 0.0, math.sqrt(8.0 / 3.0))
    return _UNIT


def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@dataclass
class Lattice:
    """style none has spacings only. scale: size of a cell edge a1 in distance units."""

    style: str = "none"
    scale: float = 1.0
    origin: Vector = (0.0, 0.0, 0.0)
    orient: tuple[tuple[int, int, int], ...] = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    vectors: Rows = _UNIT
    basis: tuple[Vector, ...] = ()
    given_spacing: Vector | None = None
    spacing: Vector = (1.0, 1.0, 1.0)
    _columns: Rows = field(default=_UNIT, repr=False)
    _inverse: Rows = field(default=_UNIT, repr=False)
    _rotation: Rows = field(default=_UNIT, repr=False)

    def finish(self) -> None:
        """Derive matrices and spacings from what the command said."""
        a1, a2, a3 = self.vectors
        self._columns = p = tuple(zip(a1, a2, a3, strict=True))  # type: ignore[assignment]
        det = (
            p[0][0] * p[1][1] * p[2][2] + p[0][1] * p[1][2] * p[2][0] + p[0][2] * p[1][0] * p[2][1]
            - p[0][0] * p[1][2] * p[2][1] - p[0][1] * p[1][0] * p[2][2] - p[0][2] * p[1][1] * p[2][0]
        )  # fmt: skip
        self._inverse = (
            ((p[1][1] * p[2][2] - p[1][2] * p[2][1]) / det, (p[0][2] * p[2][1] - p[0][1] * p[2][2]) / det,
             (p[0][1] * p[1][2] - p[0][2] * p[1][1]) / det),
            ((p[1][2] * p[2][0] - p[1][0] * p[2][2]) / det, (p[0][0] * p[2][2] - p[0][2] * p[2][0]) / det,
             (p[0][2] * p[1][0] - p[0][0] * p[1][2]) / det),
            ((p[1][0] * p[2][1] - p[1][1] * p[2][0]) / det, (p[0][1] * p[2][0] - p[0][0] * p[2][1]) / det,
             (p[0][0] * p[1][1] - p[0][1] * p[1][0]) / det),
        )  # fmt: skip
        rows = []
        for x, y, z in self.orient:
            length = math.sqrt(float(x * x + y * y + z * z))
            rows.append((x / length, y / length, z / length))
        self._rotation = rows[0], rows[1], rows[2]
        if self.given_spacing is not None:
            a, b, c = self.given_spacing
            self.spacing = a * self.scale, b * self.scale, c * self.scale
            return
        self.spacing = (0.0, 0.0, 0.0)
        corners = [self.to_box((float(i), float(j), float(k))) for i, j, k in product((0, 1), repeat=3)]
        a, b, c = (max(q[d] for q in corners) - min(q[d] for q in corners) for d in range(3))
        self.spacing = a, b, c

    def to_box(self, site: Vector) -> Vector:
        """Lattice coordinates to distance units."""
        t0, t1, t2 = ((r[0] * site[0] + r[1] * site[1] + r[2] * site[2]) * self.scale for r in self._columns)
        s, o = self.spacing, self.origin
        r = self._rotation
        return (
            r[0][0] * t0 + r[0][1] * t1 + r[0][2] * t2 + s[0] * o[0],
            r[1][0] * t0 + r[1][1] * t1 + r[1][2] * t2 + s[1] * o[1],
            r[2][0] * t0 + r[2][1] * t1 + r[2][2] * t2 + s[2] * o[2],
        )

    def from_box(self, x: Vector) -> Vector:
        """Distance units to lattice coordinates."""
        s, o, r = self.spacing, self.origin, self._rotation
        d = x[0] - s[0] * o[0], x[1] - s[1] * o[1], x[2] - s[2] * o[2]
        t = [r[0][i] * d[0] + r[1][i] * d[1] + r[2][i] * d[2] for i in range(3)]
        t = [q / self.scale for q in t]
        m = self._inverse
        a, b, c = (m[i][0] * t[0] + m[i][1] * t[1] + m[i][2] * t[2] for i in range(3))
        return a, b, c
