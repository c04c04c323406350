"""The simulation box: faces, boundaries, wrapping, minimum image. Here the orthogonal one; triclinic.py has the tilted one.

Every formula keeps LAMMPS's order of operations, so that coordinates agree to the last bit.

Atoms are wrapped, sorted and copied to ghosts in *frame* coordinates, in which the box is a brick: x itself here, fractions of
the cell vectors (LAMMPS's lamda) in a triclinic box. `enter` and `leave` change x in place; here they do nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.exact import wrapping
from pylmp.kernels.exact.wrapping import ten_bits, walk
from pylmp.kernels.kinds import Function
from pylmp.kernels.store import kernel
from pylmp.model.atoms import AnyInts, Atoms, Floats
from pylmp.model.console import Console
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest

FAR = 10.0  # box lengths: atoms farther out are wrapped one by one
_OPEN = 1.0e20  # LAMMPS seeks the least coordinate from here down, the greatest from its negative up
FARTHEST = 1.0e6  # box lengths: nobody means an atom farther out, and LAMMPS would wrap it for ever
_FAR = 16.0  # box lengths between two atoms that LAMMPS does not look beyond
SHRINK_MARGIN = 1.0e-4  # of the box length: how far a shrink-wrapped face stays outside the extreme atom
_WRAP, _OUTSIDE, _ALL = wrapping.wrap(), wrapping.outside(), np.ones(3, np.int64)
Boundary = tuple[tuple[str, str], ...]


def extremes(x: Floats) -> tuple[Floats, Floats]:
    """(3,) least and greatest coordinates of each direction, as LAMMPS finds them."""
    return np.minimum(x.min(axis=0), _OPEN), np.maximum(x.max(axis=0), -_OPEN)


def check_near(separations: Floats, length: float) -> None:
    """Raise ScriptError if one of (n,) is many box lengths."""
    far = np.abs(separations) > _FAR * length
    if far.any():
        worst = shortest(float(separations[int(np.argmax(far))]))
        says = f"Atoms have moved too far apart ({worst}) for minimum image"
        raise ScriptError(says, hint="a smaller timestep, or neighbor lists made anew more often")


class Box:
    """lo, hi: (3,) float64 faces. tilt: (3,) xy xz yz, 0 here. boundary: three pairs of letters p f s m (low face, high face).

    rate, rate_group: how fast the six numbers of h change, and the group whose velocities change with it when they cross a
    periodic face (fix deform remap v); rate_group 0: nobody's.
    """

    triclinic: ClassVar[bool] = False

    def __init__(self, lo: Floats, hi: Floats, boundary: Boundary, dimension: int) -> None:
        self.lo = np.array(lo, float)
        self.hi = np.array(hi, float)
        self.tilt = np.zeros(3)
        self.boundary = boundary
        self.dimension = dimension
        self.margin = np.zeros(3)
        self.least_lo = np.zeros(3)  # boundary m: the face never moves inside these
        self.least_hi = np.zeros(3)
        self.deforming = False  # a fix changes the box during the run
        self.rate = np.zeros(6)
        self.rate_group = 0
        self._wraps = np.zeros(3, np.int64)

    @classmethod
    def of(cls, other: Box) -> Self:
        """The same box, now of this kind."""
        box = cls(other.lo, other.hi, other.boundary, other.dimension)
        box.margin, box.least_lo, box.least_hi = other.margin, other.least_lo, other.least_hi
        return box

    # ---- what it is -----------------------------------------------------------------------------------------

    @property
    def length(self) -> Floats:
        """(3,) box lengths hi - lo."""
        return self.hi - self.lo

    @property
    def h(self) -> Floats:
        """(6,) Lx Ly Lz yz xz xy, in LAMMPS's order."""
        return np.array([*self.length, *self.tilt[::-1]])

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

    @property
    def skewed(self) -> bool:
        """A tilt is so large that LAMMPS warns."""
        return False

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lowest and highest corner of the brick around the box."""
        return self.lo, self.hi

    # ---- frame coordinates ------------------------------------------------------------------------------------

    @property
    def frame(self) -> tuple[Floats, Floats]:
        """Low and high faces in frame coordinates."""
        return self.lo, self.hi

    def enter(self, x: Floats) -> None:
        """x (n, 3) to frame coordinates, in place."""

    def leave(self, x: Floats) -> None:
        """Frame coordinates (n, 3) to x, in place."""

    def frame_reach(self, cutoff: float) -> Floats:
        """(3,) a distance between opposite faces, in frame coordinates."""
        return np.full(3, cutoff)

    def brick(self, lo: Floats, hi: Floats) -> tuple[Floats, Floats]:
        """Lowest and highest corner of the part of space between lo and hi in frame coordinates."""
        return lo, hi

    def fractions(self, x: Floats) -> Floats:
        """(n, 3) fractions of the box lengths."""
        return (1.0 / self.length) * (x - self.lo)

    def positions(self, fractions: Floats) -> Floats:
        """(n, 3) positions of fractions of the box lengths."""
        return self.length * fractions + self.lo

    # ---- changes ----------------------------------------------------------------------------------------------

    def place(self, lo: Floats, hi: Floats, tilt: Floats | None = None) -> None:
        """Move the faces (and tilts of a triclinic box): the way in for all who change a box."""
        self.lo[:], self.hi[:] = lo, hi

    def set_initial(self, console: Console) -> None:
        """What LAMMPS does whenever the box is set: margins, and shrink-wrapped faces moved outward."""
        if np.any(self.lo >= self.hi):
            raise ScriptError("Box bounds are invalid or missing")
        if self.skewed:
            console.warning("Triclinic box skew is large. LAMMPS will run inefficiently.")
        self.margin = SHRINK_MARGIN * self.length
        lo, hi = self.lo.copy(), self.hi.copy()
        for d, (low, high) in enumerate(self.boundary):
            if low == "s":
                lo[d] -= self.margin[d]
            elif low == "m":
                self.least_lo[d] = lo[d]
            if high == "s":
                hi[d] += self.margin[d]
            elif high == "m":
                self.least_hi[d] = hi[d]
        self.place(lo, hi)

    def shrink(self, atoms: Atoms, natoms: int) -> None:
        """Move shrink-wrapped faces to the extreme atoms, plus the margin. Atoms are in frame coordinates; natoms counts lost ones too."""
        if self.shrinks(atoms, natoms):
            self.shrink_to(*extremes(atoms.x[: atoms.n]))

    def shrinks(self, atoms: Atoms, natoms: int) -> bool:
        """There are faces to be moved, and atoms. Raises ScriptError."""
        if natoms and not atoms.n and self.shrinking:
            raise ScriptError("Illegal simulation box", hint="all atoms are lost, and shrink-wrapped faces have nothing to follow")
        return bool(atoms.n) and self.shrinking

    def shrink_to(self, least: Floats, most: Floats) -> None:
        """The same, of atoms between least and most (3,)."""
        lo, hi = self.lo.copy(), self.hi.copy()
        for d, (low, high) in enumerate(self.boundary):
            if low in "sm":
                face = least[d] - self.margin[d]
                lo[d] = face if low == "s" else min(face, self.least_lo[d])
            if high in "sm":
                face = most[d] + self.margin[d]
                hi[d] = face if high == "s" else max(face, self.least_hi[d])
        if (lo > hi).any():
            raise ScriptError("Illegal simulation box", hint="an atom is beyond the fixed face opposite a shrink-wrapped one")
        self.place(lo, hi)

    def corners(self) -> Floats:
        """(k, 3) the corners whose travel tells how far the box has moved."""
        return np.array([self.lo, self.hi])

    def travel(self, before: Floats) -> float:
        """How far two corners moved together at most, since corners() was before."""
        first = second = 0.0
        for d in self.corners() - before:
            far = float(np.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]))
            first, second = self._farthest(first, second, far)
        return first + second

    @staticmethod
    def _farthest(first: float, second: float, far: float) -> tuple[float, float]:
        return second, far

    # ---- periodic images --------------------------------------------------------------------------------------

    def wrap(self, atoms: Atoms) -> None:
        """LAMMPS's pbc: periodic coordinates move by at most one box length a side, in place, in frame coordinates. Raises ScriptError."""
        if not np.isfinite(atoms.x[: atoms.n]).all():
            raise ScriptError("Non-numeric atom coords - simulation unstable", hint="a smaller timestep, or forces that do not diverge")
        self.wrapping(atoms)()

    def wrapping(self, atoms: Atoms) -> Callable[[], float]:
        """The call that wrap makes when all positions are numbers."""
        self._wraps[:] = self.periodic
        return kernel(_WRAP).bind(atoms.x, atoms.v, atoms.image, atoms.mask, *self.frame, self._wraps, self.rate, self.rate_group, atoms.n)

    def lost(self, atoms: Atoms) -> bool:
        """Is an owned atom beyond a face? In frame coordinates."""
        return kernel(_OUTSIDE).bind(atoms.x, *self.frame, _ALL, atoms.n)() > 0.0

    @staticmethod
    def functions() -> list[Function]:
        """Kernels that wrap and lost call."""
        return [_WRAP, _OUTSIDE]

    def remap(self, x: Floats, image: AnyInts) -> None:
        """LAMMPS's remap: wrap positions as often as it takes, in place."""
        self._wrap_all(x, image, self.lo, self.hi)

    def _wrap_all(self, x: Floats, image: AnyInts, lows: Floats, highs: Floats) -> None:
        for d, periodic in enumerate(self.periodic):
            if not periodic:
                continue
            lo, hi = lows[d], highs[d]
            length = hi - lo
            if (np.abs(x[:, d] - lo) > FARTHEST * length).any():
                raise ScriptError("Atom is too far outside the periodic box", hint=f"within {FARTHEST:g} box lengths")
            for row in np.flatnonzero(np.abs(x[:, d] - lo) > FAR * length).tolist():
                x[row, d], turns = walk(float(x[row, d]), float(lo), float(hi), float(length))
                image[row, d] = ten_bits(image[row, d] + turns)
            while (out := x[:, d] < lo).any():
                x[out, d] += length
                image[out, d] = ten_bits(image[out, d] - 1)
            while (out := x[:, d] >= hi).any():
                x[out, d] -= length
                image[out, d] = ten_bits(image[out, d] + 1)
            x[:, d] = np.maximum(x[:, d], lo)

    def near(self, new: Floats, old: Floats) -> None:
        """LAMMPS's remap_near: new (n, 3) to its periodic image within half a box length of old, in place."""
        self._bring_near(new, old, self.length)

    def _bring_near(self, new: Floats, old: Floats, lengths: Floats) -> None:
        for d, periodic in enumerate(self.periodic):
            if not periodic:
                continue
            length = float(lengths[d])
            half = 0.5 * length
            for sign in (1.0, -1.0):
                gap = sign * (new[:, d] - old[:, d])
                far = gap > length
                if far.any():
                    new[far, d] -= sign * ((gap[far] / length).astype(np.int64) * length)
                while (out := sign * (new[:, d] - old[:, d]) > half).any():
                    new[out, d] -= sign * length

    def unwrap(self, x: Floats, image: AnyInts) -> Floats:
        """(n, 3) coordinates with image flags undone: x + image*L."""
        return x + image * self.length

    def unmap(self, x: Floats, image: AnyInts) -> None:
        """The same in place; in a triclinic box its last digits differ from unwrap's."""
        x += image * self.length

    def minimum_image(self, delta: Floats) -> Floats:
        """(n, 3) separations moved to their nearest periodic image; strict > half, as often as it takes. Raises ScriptError for
        those of many boxes."""
        delta = np.array(delta)
        for d, periodic in enumerate(self.periodic):
            if not periodic:
                continue
            length = self.hi[d] - self.lo[d]
            half = 0.5 * length
            column: NDArray[np.float64] = delta[:, d]
            check_near(column, length)
            while (out := np.abs(column) > half).any():
                column[out] += np.where(column[out] < 0.0, length, -length)
        return delta
