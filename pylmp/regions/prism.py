"""region ID prism xlo xhi ylo yhi zlo zhi xy xz yz: a parallelepiped; the box of create_box becomes triclinic.

A point belongs to it if its fractions of the vectors (xhi-xlo 0 0), (xy yhi-ylo 0), (xz yz zhi-zlo) are within 0 and 1. Bounds
may be INF or EDGE, bounds and tilts equal-style variables. Source: LAMMPS manual, region.html.
"""

from __future__ import annotations

import math

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.quantity import Quantity
from pylmp.model.region import BIG, Corner, Inside, Options, Region, Scale
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.model.surface import Contact
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("prism")
class Prism(Region):
    style = "prism"
    words = 9

    def __init__(self, sim: Simulation, args: Args, options: Options, scale: Scale) -> None:
        super().__init__(sim, options)
        words = args.words[args.at :]
        self._bounds = [self.bound(args, axis, high, scale[axis]) for axis in range(3) for high in (False, True)]
        self._tilts = [self.quantity(args, scale[axis]) for axis in (0, 0, 1)]
        self.check()
        self._take()
        flat, says = self._flat()
        if flat is not None:
            args.fail(says, words[2 * flat], hint="the lower bound comes first")
        low, high = self.low.tolist(), self.high.tolist()
        endless = [low[d] == -BIG and high[d] == BIG for d in range(3)]
        for name, tilt, place in zip(("xy", "xz", "yz"), self._tilts, (6, 7, 8), strict=True):
            for axis in name:
                if tilt.value != 0.0 and endless["xyz".index(axis)]:
                    args.fail(f"Illegal region prism non-zero {name} tilt with infinite {axis} size", words[place])
        xy, xz, yz = self.tilt
        self.cell = (low[0], low[1], low[2]), (high[0], high[1], high[2]), (xy, xz, yz)
        least_x, most_x = min(low[0], low[0] + xy), max(high[0], high[0] + xy)
        self.extent = (
            (min(least_x, least_x + xz), min(low[1], low[1] + yz), low[2]),
            (max(most_x, most_x + xz), max(high[1], high[1] + yz), high[2]),
        )

    def edge(self, args: Args, axis: int, high: bool) -> Quantity:
        """The box's own face, not that of the brick around it."""
        super().edge(args, axis, high)
        return Quantity(float((self.sim.box.hi if high else self.sim.box.lo)[axis]))

    def _take(self) -> None:
        values = [bound.number(self.sim) for bound in self._bounds]
        self.low, self.high = np.array(values[0::2]), np.array(values[1::2])
        self.tilt = xy, xz, yz = [tilt.number(self.sim) for tilt in self._tilts]
        a, b, c = (self.high - self.low).tolist()
        if a != 0.0 and b != 0.0 and c != 0.0:
            self.inverse = 1.0 / a, -xy / (a * b), (xy * yz - xz * b) / (a * b * c), 1.0 / b, -yz / (b * c), 1.0 / c

    def _flat(self) -> tuple[int | None, str]:
        """The first direction in which nothing lies between the bounds, and what LAMMPS says of it."""
        for d, (low, high) in enumerate(zip(self.low.tolist(), self.high.tolist(), strict=True)):
            if low >= high:
                axis = "xyz"[d]
                return d, f"Illegal region prism {axis}lo: {shortest(low)} >= {axis}hi: {shortest(high)}"
        return None, ""

    def reshape(self) -> None:
        self._take()
        flat, says = self._flat()
        if flat is not None:
            self.bad_value(says)

    def contains(self, x: Floats) -> Inside:
        xx, xy, xz, yy, yz, zz = self.inverse
        d = x - self.low
        a = xx * d[:, 0] + xy * d[:, 1] + xz * d[:, 2]
        b = yy * d[:, 1] + yz * d[:, 2]
        c = zz * d[:, 2]
        return np.asarray((a >= 0.0) & (a <= 1.0) & (b >= 0.0) & (b <= 1.0) & (c >= 0.0) & (c <= 1.0))

    def from_inside(self, x: Floats, cutoff: float) -> list[Contact]:
        inside = self.contains(x)
        contacts = []
        for face, normal in enumerate(self._normals()):
            a, b, c = ((x[:, d] - (self.corner if face % 2 else self.low)[d]) * normal[d] for d in range(3))
            distance = a + b + c
            contacts.append(Contact(inside & (distance < cutoff), distance, distance[:, None] * np.array(normal)))
        return contacts

    @property
    def corner(self) -> Floats:
        """The corner that is farthest from low."""
        a, b, c = self._edges()
        return np.asarray(self.low + np.array(a) + np.array(b) + np.array(c))

    def _edges(self) -> tuple[Corner, Corner, Corner]:
        lx, ly, lz = (self.high - self.low).tolist()
        xy, xz, yz = self.tilt
        return (lx, 0.0, 0.0), (xy, ly, 0.0), (xz, yz, lz)

    def _normals(self) -> list[Corner]:
        """Inward unit normals of the six faces, those across the third of the vectors a b c first."""
        a, b, c = self._edges()
        normals = []
        for u, v in ((a, b), (c, a), (b, c)):
            n = u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
            inverse = 1.0 / math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])
            normals.append((n[0] * inverse, n[1] * inverse, n[2] * inverse))
        return [(s * n[0], s * n[1], s * n[2]) for n in normals for s in (1.0, -1.0)]
