"""The triclinic box: cell vectors (Lx 0 0), (xy Ly 0), (xz yz Lz). Source: LAMMPS manual, Howto_triclinic.html.

Frame coordinates are fractions of the cell vectors, LAMMPS's lamda; every passage through them changes the last digits of x,
so it happens exactly where LAMMPS makes it.
"""

from __future__ import annotations

from itertools import product
from typing import ClassVar, Self

import numpy as np

from pylmp.model.atoms import AnyInts, Atoms, Floats
from pylmp.model.box import Boundary, Box, check_near, extremes
from pylmp.model.console import Console
from pylmp.text.diagnostic import ScriptError

SKEW = 0.5  # of the box length along which a tilt goes: more is inefficient, and what fix deform flips
_UNIT = np.zeros(3), np.ones(3)


class Triclinic(Box):
    """tilt: (3,) xy xz yz. h, h_inv: (6,) in the order xx yy zz yz xz xy, kept in step by place."""

    triclinic: ClassVar[bool] = True

    def __init__(self, lo: Floats, hi: Floats, boundary: Boundary, dimension: int, tilt: Floats | None = None) -> None:
        super().__init__(lo, hi, boundary, dimension)
        self._h, self.h_inv = np.zeros(6), np.zeros(6)
        self.place(lo, hi, np.zeros(3) if tilt is None else tilt)

    @classmethod
    def of(cls, other: Box) -> Self:
        box = super().of(other)
        box.place(other.lo, other.hi, other.tilt)
        return box

    def place(self, lo: Floats, hi: Floats, tilt: Floats | None = None) -> None:
        super().place(lo, hi)
        if tilt is not None:
            self.tilt[:] = tilt
        h = self._h
        h[:3], h[3:] = self.length, self.tilt[::-1]
        self.h_inv[:3] = 1.0 / h[:3]
        self.h_inv[3] = -h[3] / (h[1] * h[2])
        self.h_inv[4] = (h[3] * h[5] - h[1] * h[4]) / (h[0] * h[1] * h[2])
        self.h_inv[5] = -h[5] / (h[0] * h[1])

    @property
    def h(self) -> Floats:
        return self._h

    @property
    def skewed(self) -> bool:
        (xy, xz, yz), (_, ly, lz), (_, y, z) = self.tilt, self.length, self.periodic
        return bool((y and abs(xy / ly) > SKEW) or (z and (abs(xz) + abs(yz)) / lz > SKEW))

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        xy, xz, yz = self.tilt
        low, high = self.lo.copy(), self.hi.copy()
        low[0] = min(low[0], low[0] + xy)
        low[0] = min(low[0], low[0] + xz)
        low[1] = min(low[1], low[1] + yz)
        high[0] = max(high[0], high[0] + xy)
        high[0] = max(high[0], high[0] + xz)
        high[1] = max(high[1], high[1] + yz)
        return low, high

    # ---- frame coordinates ------------------------------------------------------------------------------------

    @property
    def frame(self) -> tuple[Floats, Floats]:
        return _UNIT

    def enter(self, x: Floats) -> None:
        x[:] = self.fractions(x)

    def leave(self, x: Floats) -> None:
        x[:] = self.positions(x)

    def fractions(self, x: Floats) -> Floats:
        d, g = x - self.lo, self.h_inv
        result = np.empty_like(d)
        result[:, 0] = g[0] * d[:, 0] + g[5] * d[:, 1] + g[4] * d[:, 2]
        result[:, 1] = g[1] * d[:, 1] + g[3] * d[:, 2]
        result[:, 2] = g[2] * d[:, 2]
        return result

    def positions(self, fractions: Floats) -> Floats:
        f, h, lo = fractions, self.h, self.lo
        result = np.empty_like(f)
        result[:, 0] = h[0] * f[:, 0] + h[5] * f[:, 1] + h[4] * f[:, 2] + lo[0]
        result[:, 1] = h[1] * f[:, 1] + h[3] * f[:, 2] + lo[1]
        result[:, 2] = h[2] * f[:, 2] + lo[2]
        return result

    def frame_reach(self, cutoff: float) -> Floats:
        g = self.h_inv
        a = np.sqrt(g[0] * g[0] + g[5] * g[5] + g[4] * g[4])
        b = np.sqrt(g[1] * g[1] + g[3] * g[3])
        return np.array([cutoff * a, cutoff * b, cutoff * g[2]])

    def brick(self, lo: Floats, hi: Floats) -> tuple[Floats, Floats]:
        corners = self.positions(np.array(list(product(*zip(lo.tolist(), hi.tolist(), strict=True)))))
        return corners.min(axis=0), corners.max(axis=0)

    # ---- changes ----------------------------------------------------------------------------------------------

    def set_initial(self, console: Console) -> None:
        if self.dimension == 2 and self.tilt[1:].any() and (self.lo < self.hi).all():
            raise ScriptError("Cannot skew triclinic box in z for 2d simulation", hint="xz and yz are 0.0")
        super().set_initial(console)

    def shrink(self, atoms: Atoms, natoms: int) -> None:
        """Extremes are sought among fractions. All atoms pass through positions, and are wrapped once more."""
        if not self.shrinks(atoms, natoms):
            return
        f = atoms.x[: atoms.n]
        least, most = extremes(f)
        self.leave(f)
        self.shrink_to(*(self.h[:3] * extreme + self.lo for extreme in (least, most)))
        self.enter(f)
        self.wrap(atoms)

    def corners(self) -> Floats:
        """Fractions of z slowest, of x fastest."""
        return self.positions(np.array([(a, b, c) for c, b, a in product((0.0, 1.0), repeat=3)]))

    @staticmethod
    def _farthest(first: float, second: float, far: float) -> tuple[float, float]:
        """LAMMPS forgets the farthest when one still farther comes."""
        return (far, second) if far > first else (first, max(second, far))

    # ---- periodic images --------------------------------------------------------------------------------------

    def remap(self, x: Floats, image: AnyInts) -> None:
        f = self.fractions(x)
        self._wrap_all(f, image, *_UNIT)
        x[:] = self.positions(f)

    def near(self, new: Floats, old: Floats) -> None:
        f = self.fractions(new)
        self._bring_near(f, self.fractions(old), _UNIT[1])
        new[:] = self.positions(f)

    def unwrap(self, x: Floats, image: AnyInts) -> Floats:
        h, (a, b, c) = self.h, image.T
        result = np.empty_like(x)
        result[:, 0] = x[:, 0] + h[0] * a + h[5] * b + h[4] * c
        result[:, 1] = x[:, 1] + h[1] * b + h[3] * c
        result[:, 2] = x[:, 2] + h[2] * c
        return result

    def unmap(self, x: Floats, image: AnyInts) -> None:
        h, (a, b, c) = self.h, image.T
        x[:, 0] += h[0] * a + h[5] * b + h[4] * c
        x[:, 1] += h[1] * b + h[3] * c
        x[:, 2] += h[2] * c

    def minimum_image(self, delta: Floats) -> Floats:
        """z first, with its tilts, then y, then x."""
        delta = np.array(delta)
        xy, xz, yz = self.tilt
        for d in (2, 1, 0):
            if not self.periodic[d]:
                continue
            length = self.hi[d] - self.lo[d]
            half = 0.5 * length
            shift = np.array(((length, 0.0, 0.0), (xy, length, 0.0), (xz, yz, length))[d])
            check_near(delta[:, d], length)
            while (out := np.abs(delta[:, d]) > half).any():
                delta[out] += np.where(delta[out, d] < 0.0, 1.0, -1.0)[:, None] * shift
        return delta
