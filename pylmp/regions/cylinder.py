"""region ID cylinder AXIS c1 c2 radius lo hi: c1, c2 and radius may be equal-style variables, lo and hi INF or EDGE."""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.region import Inside, Options, Region, Scale, around_axis
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.model.surface import Contact, along_axis, closest, radial, to_point, within
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("cylinder")
class Cylinder(Region):
    style = "cylinder"
    words = 6
    faces = 3

    def __init__(self, sim: Simulation, args: Args, options: Options, scale: Scale) -> None:
        super().__init__(sim, options)
        self.axis, self.across = self.read_axis(args)
        self._center = [self.quantity(args, scale[d]) for d in self.across]
        self._radius = self.quantity(args, scale[1 if self.axis == 0 else 0])
        ends = [self.bound(args, self.axis, high, scale[self.axis], variable=False) for high in (False, True)]
        self.low, self.high = (end.value for end in ends)
        self.shaped()
        self._take()
        if self.radius <= 0.0:
            args.fail(f"Illegal radius {shortest(self.radius)} in region cylinder command", args.words[5])
        self.extent = around_axis(self.axis, self.center, self.radius, self.low, self.high)

    def _take(self) -> None:
        self.center = [q.number(self.sim) for q in self._center]
        self.radius = self._radius.number(self.sim)

    def reshape(self) -> None:
        self._take()
        if self.radius < 0.0:
            self.bad_value()

    def contains(self, x: Floats) -> Inside:
        a, b = (x[:, d] - c for d, c in zip(self.across, self.center, strict=True))
        along = x[:, self.axis]
        return np.asarray((np.sqrt(a * a + b * b) <= self.radius) & (along >= self.low) & (along <= self.high))

    def from_inside(self, x: Floats, cutoff: float) -> list[Contact]:
        d, r = self._away(x)
        along = x[:, self.axis]
        inside = (r <= self.radius) & within(x, self.axis, self.low, self.high)
        gap = self.radius - r
        contacts = [radial(d, r, self.radius, inside & (gap < cutoff) & (r > 0.0), gap)]
        for face, gap in ((1, along - self.low), (2, self.high - along)):
            if not self.open_face(face):
                contacts.append(along_axis(gap, inside & (gap < cutoff), self.axis, face == 2))
        return contacts

    def from_outside(self, x: Floats, cutoff: float) -> list[Contact]:
        if self.open_face(3):
            raise self.no_surface("cylinder with an open curved face")  # its forces on atoms beyond the rims make no sense
        d, r = self._away(x)
        along = x[:, self.axis]
        far = (r >= self.radius + cutoff) | (along <= self.low - cutoff) | (along >= self.high + cutoff)
        inside = (r < self.radius) & (along > self.low) & (along < self.high)
        with np.errstate(divide="ignore", invalid="ignore"):
            rim = np.array([0.0 if k == self.axis else self.center[self.across.index(k)] for k in range(3)]) + (
                d * self.radius / r[:, None]
            )
        flat = np.where((r > self.radius)[:, None], rim, x)
        if not self.options.opened:
            flat[:, self.axis] = np.clip(along, self.low, self.high)
            return [to_point(x, flat, ~far & ~inside, cutoff)]
        rim[:, self.axis] = np.clip(along, self.low, self.high)
        faces = [rim]
        for face, end in ((1, self.low), (2, self.high)):
            if not self.open_face(face):
                disc = flat.copy()
                disc[:, self.axis] = end
                faces.append(disc)
        return [to_point(x, closest(x, faces), ~far & ~inside, cutoff)]

    def _away(self, x: Floats) -> tuple[Floats, Floats]:
        """(n, 3) from the axis, and its length."""
        d = np.zeros((len(x), 3))
        for k, c in zip(self.across, self.center, strict=True):
            d[:, k] = x[:, k] - c
        a, b = (d[:, k] for k in self.across)
        return d, np.sqrt(a * a + b * b)
