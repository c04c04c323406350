"""The simulation box: faces, boundaries, wrapping, minimum image. Orthogonal boxes.

Every formula keeps LAMMPS's order of operations, so that coordinates agree to the last bit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats, Ints
from pylmp.text.diagnostic import ScriptError

SHRINK_MARGIN = 1.0e-4  # of the box length: how far a shrink-wrapped face stays outside the extreme atom


class Box:
    """lo, hi: (3,) float64 faces. boundary: three pairs of letters p f s m (low face, high face)."""

    def __init__(self, lo: Floats, hi: Floats, boundary: tuple[tuple[str, str], ...], dimension: int) -> None:
        self.lo = np.array(lo, float)
        self.hi = np.array(hi, float)
        self.boundary = boundary
        self.dimension = dimension
        self.margin = np.zeros(3)
        self.least_lo = np.zeros(3)  # boundary m: the face never moves inside these
        self.least_hi = np.zeros(3)
        self.deforming = False  # a fix changes the box during the run

    @property
    def length(self) -> Floats:
        """(3,) box lengths hi - lo."""
        return self.hi - self.lo

    @property
    def periodic(self) -> tuple[bool, bool, bool]:
        a, b, c = (faces[0] == "p" for faces in self.boundary)
        return a, b, c

    @property
    def shrinking(self) -> bool:
        return any(letter in "sm" for faces in self.boundary for letter in faces)

    @property
    def changing(self) -> bool:
        """Bins and ghosts must be laid out anew at each rebuild."""
        return self.deforming or self.shrinking

    @property
    def volume(self) -> float:
        """Lx*Ly*Lz, in two dimensions the area Lx*Ly."""
        a, b, c = (float(q) for q in self.length)
        return a * b * c if self.dimension == 3 else a * b

    def set_initial(self) -> None:
        """What LAMMPS does whenever the box is set: margins, and shrink-wrapped faces moved outward."""
        if np.any(self.lo >= self.hi):
            raise ScriptError("Box bounds are invalid or missing")
        self.margin = SHRINK_MARGIN * self.length
        for d, (low, high) in enumerate(self.boundary):
            if low == "s":
                self.lo[d] -= self.margin[d]
            elif low == "m":
                self.least_lo[d] = self.lo[d]
            if high == "s":
                self.hi[d] += self.margin[d]
            elif high == "m":
                self.least_hi[d] = self.hi[d]

    def shrink(self, x: Floats) -> None:
        """Move shrink-wrapped faces to the extreme atoms x (n, 3), plus the margin."""
        if len(x) == 0:
            return
        for d, (low, high) in enumerate(self.boundary):
            if low in "sm":
                face = float(x[:, d].min()) - self.margin[d]
                self.lo[d] = face if low == "s" else min(face, self.least_lo[d])
            if high in "sm":
                face = float(x[:, d].max()) + self.margin[d]
                self.hi[d] = face if high == "s" else max(face, self.least_hi[d])

    def wrap(self, x: Floats, image: Ints) -> None:
        """LAMMPS's pbc: periodic coordinates move by at most one box length a side, in place."""
        for d, periodic in enumerate(self.periodic):
            if not periodic:
                continue
            lo, hi = self.lo[d], self.hi[d]
            length = hi - lo
            below = x[:, d] < lo
            if below.any():
                x[below, d] += length
                image[below, d] -= 1
            above = x[:, d] >= hi
            if above.any():
                x[above, d] -= length
                x[above, d] = np.maximum(x[above, d], lo)
                image[above, d] += 1

    def remap(self, x: Floats, image: Ints) -> None:
        """LAMMPS's remap: wrap as often as it takes, in place."""
        for d, periodic in enumerate(self.periodic):
            if not periodic:
                continue
            lo, hi = self.lo[d], self.hi[d]
            length = hi - lo
            while (out := x[:, d] < lo).any():
                x[out, d] += length
                image[out, d] -= 1
            while (out := x[:, d] >= hi).any():
                x[out, d] -= length
                image[out, d] += 1
            x[:, d] = np.maximum(x[:, d], lo)

    def unwrap(self, x: Floats, image: Ints) -> Floats:
        """(n, 3) coordinates with image flags undone: x + image*L."""
        return x + image * self.length

    def minimum_image(self, delta: Floats) -> Floats:
        """(n, 3) separations moved to their nearest periodic image; strict > half, as often as it takes."""
        delta = np.array(delta)
        for d, periodic in enumerate(self.periodic):
            if not periodic:
                continue
            length = self.hi[d] - self.lo[d]
            half = 0.5 * length
            column: NDArray[np.float64] = delta[:, d]
            while (out := np.abs(column) > half).any():
                column[out] += np.where(column[out] < 0.0, length, -length)
        return delta
