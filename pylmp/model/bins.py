"""Bins of space that atoms are sorted into: layers along axes, shells around a point. Numbers as LAMMPS rounds them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats, Ints
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

Bounds = dict[int, tuple[float | None, float | None]]


@dataclass
class Spacing:
    """Layers along one axis. origin: lower, center, upper or a coordinate, where a layer begins; delta: their thickness.

    low count: where the first begins and how many there are, once laid
    """

    axis: int
    origin: str | float
    delta: float
    low: float = 0.0
    count: int = 0

    @classmethod
    def read(cls, args: Args) -> Spacing:
        """DIM ORIGIN DELTA."""
        if len(args) < 3:
            args.missing(hint="DIM ORIGIN DELTA")
        word = args.word()
        if word.text not in ("x", "y", "z"):
            args.fail(f"Illegal compute chunk/atom dimension {word.text}", word, hint="x y z")
        origin = args.word()
        start = origin.text if origin.text in ("lower", "center", "upper") else args.as_number(origin)
        return cls("xyz".index(word.text), start, args.number())

    def lay(self, lo: float, hi: float, least: float | None, most: float | None) -> None:
        """Layers from a face at lo to a face at hi, or between least and most: whole ones, counted from the origin."""
        low, high = lo if least is None else least, hi if most is None else most
        named = {"lower": low, "center": 0.5 * (low + high), "upper": high}
        origin = named[self.origin] if isinstance(self.origin, str) else self.origin
        inverse = 1.0 / self.delta
        if origin < low:
            begin = origin + int((low - origin) * inverse) * self.delta
        else:
            begin = origin - int((origin - low) * inverse) * self.delta
            if begin > low:
                begin -= self.delta
        if origin < high:
            end = origin + int((high - origin) * inverse) * self.delta
            if end < high:
                end += self.delta
        else:
            end = origin - int((origin - high) * inverse) * self.delta
        if begin > end:
            raise ScriptError("Invalid bin bounds in compute chunk/atom", hint="the lower bound comes first")
        self.low, self.count = begin, int((end - begin) * inverse + 0.5)

    @property
    def middles(self) -> Floats:
        return np.asarray(self.low + (np.arange(self.count) + 0.5) * self.delta, np.float64)


@dataclass
class Layers:
    """Bins of one, two or three spacings; the last one's index runs fastest."""

    spacings: list[Spacing]
    reduced: bool = False
    bounds: Bounds = field(default_factory=dict)

    @property
    def coordinates(self) -> int:
        return len(self.spacings)

    @property
    def count(self) -> int:
        return int(np.prod([spacing.count for spacing in self.spacings]))

    def scale(self, sim: Simulation, units: str, bounds: Bounds, pbc: bool) -> None:
        """Coordinates given in lattice units become distances. As in LAMMPS 22 Jul 2025 bounds along y and z do not."""
        self.reduced = units == "reduced"
        self.bounds = dict(bounds)
        if units != "lattice":
            return
        for spacing in self.spacings:
            factor = sim.spacing[spacing.axis]
            spacing.delta *= factor
            if not isinstance(spacing.origin, str):
                spacing.origin *= factor
        if 0 in bounds:
            low, high = bounds[0]
            self.bounds[0] = (low and low * sim.spacing[0], high and high * sim.spacing[0])

    def lay(self, sim: Simulation) -> None:
        """Place the bins in the box as it is now."""
        for spacing in self.spacings:
            lo, hi = (0.0, 1.0) if self.reduced else (float(sim.box.lo[spacing.axis]), float(sim.box.hi[spacing.axis]))
            spacing.lay(lo, hi, *self.bounds.get(spacing.axis, (None, None)))

    def place(self, sim: Simulation, discard: str) -> Ints:
        """(n,) bin of each owned atom from 1, 0 for none."""
        n = sim.atoms.n
        x = sim.atoms.x[:n]
        if self.reduced:  # LAMMPS turns positions into fractions and back, which changes their last digits
            fractions = sim.box.fractions(x)
            x[:] = sim.box.positions(fractions)
            x = fractions
        result, kept = np.zeros(n, np.int64), np.ones(n, bool)
        for spacing in self.spacings:
            axis = spacing.axis
            lo, hi = (0.0, 1.0) if self.reduced else (float(sim.box.lo[axis]), float(sim.box.hi[axis]))
            c = _wrapped(x[:, axis], lo, hi) if sim.box.periodic[axis] else x[:, axis]
            layer = ((c - spacing.low) * (1.0 / spacing.delta)).astype(np.int64)
            layer[c < spacing.low] -= 1
            low, high = self.bounds.get(axis, (None, None))
            below, above = _clip(discard, low), _clip(discard, high)
            layer = np.where(below, np.maximum(layer, 0), layer)
            layer = np.where(above, np.minimum(layer, spacing.count - 1), layer)
            kept &= (layer >= 0) & (layer < spacing.count)
            result = result * spacing.count + layer
        return np.where(kept, result + 1, 0)

    def centers(self) -> Floats:
        """(bins, coordinates)"""
        grids = np.meshgrid(*(spacing.middles for spacing in self.spacings), indexing="ij")
        return np.stack([grid.ravel() for grid in grids], axis=1)


def _wrapped(c: Floats, lo: float, hi: float) -> Floats:
    """Coordinates moved into the box by at most one length."""
    c = c.copy()
    c[c < lo] += hi - lo
    c[c >= hi] -= hi - lo
    return c


def _clip(discard: str, bound: float | None) -> bool:
    """Atoms beyond this end belong to the last bin there."""
    return discard == "no" or (discard == "mixed" and bound is None)


@dataclass
class Shells:
    """Spherical shells of equal thickness around a point."""

    center: NDArray[np.float64]
    least: float
    most: float
    count: int
    pbc: bool = False
    coordinates = 1

    @classmethod
    def read(cls, args: Args) -> Shells:
        """X Y Z RMIN RMAX N."""
        if len(args) < 6:
            args.missing(hint="X Y Z RMIN RMAX N")
        return cls(np.array([args.number() for _ in range(3)]), args.number(), args.number(), args.integer())

    def scale(self, sim: Simulation, units: str, bounds: Bounds, pbc: bool) -> None:
        self.pbc = pbc
        if units == "lattice":
            self.center *= sim.spacing
            self.least *= sim.spacing[0]
            self.most *= sim.spacing[0]

    def lay(self, sim: Simulation) -> None:
        """They stay where they are; with pbc they must fit into the box. Raises ScriptError."""
        if self.pbc and np.any(np.array(sim.box.periodic) & (self.most > 0.5 * sim.box.length)):
            text = "Compute chunk/atom bin/sphere radius is too large for periodic box"
            raise ScriptError(text, hint=f"at most {0.5 * float(sim.box.length.min()):g}")

    def place(self, sim: Simulation, discard: str) -> Ints:
        n = sim.atoms.n
        x, box = sim.atoms.x[:n].copy(), sim.box
        for axis in np.flatnonzero(box.periodic):
            x[:, axis] = _wrapped(x[:, axis], float(box.lo[axis]), float(box.hi[axis]))
        d = x - self.center
        if self.pbc:
            d = box.minimum_image(d)
        r = np.sqrt(d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2])
        shell = ((r - self.least) * (self.count / (self.most - self.least))).astype(np.int64)
        shell[r < self.least] -= 1
        if discard in ("no", "mixed"):
            shell = np.clip(shell, 0, self.count - 1)
        return np.where((shell >= 0) & (shell < self.count), shell + 1, 0)

    def centers(self) -> Floats:
        return (self.least + (np.arange(self.count) + 0.5) * (self.most - self.least) / self.count)[:, None]
