"""region ID cone AXIS c1 c2 radlo radhi lo hi: all but AXIS may be equal-style variables; lo and hi may be INF or EDGE.

Radius at a coordinate t between lo and hi: radlo + (t - lo) (radhi - radlo)/(hi - lo).
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.quantity import Quantity
from pylmp.model.region import Inside, Options, Region, Scale, around_axis
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.model.surface import Contact, along_axis, closest, on_segment, to_point, within
from pylmp.text.words import Args


@REGIONS.register("cone")
class Cone(Region):
    style = "cone"
    words = 7
    faces = 3

    def __init__(self, sim: Simulation, args: Args, options: Options, scale: Scale) -> None:
        super().__init__(sim, options)
        self.axis, self.across = self.read_axis(args)
        self._center = [self.quantity(args, scale[d]) for d in self.across]
        self._radii = [self.quantity(args, scale[1 if self.axis == 0 else 0]) for _ in range(2)]
        self._ends = self._read_ends(args, scale[self.axis])
        self.shaped()
        self._take()
        for radius, which, at in ((self.radii[0], "lower", 5), (self.radii[1], "upper", 6)):
            if radius < 0.0:
                args.fail(f"Illegal {which} radius in region cone command", args.words[at])
        if self.radii == [0.0, 0.0]:
            args.fail("Illegal radius in region cone command", args.words[5])
        if self.low >= self.high:
            args.fail("Illegal cone length in region cone command", args.words[8], hint="the lower end comes first")
        self.extent = around_axis(self.axis, self.center, max(self.radii), self.low, self.high)

    def _read_ends(self, args: Args, scale: float) -> tuple[Quantity, Quantity]:
        """Measured: with a lower bound EDGE the upper bound is the box's face unless it is INF; without, EDGE is no upper
        bound; along y an upper INF means the box's face."""
        at_edge = args.words[args.at].text == "EDGE"
        low = self.bound(args, self.axis, False, scale)
        upper = args.words[args.at].text
        if (at_edge and upper != "INF") or (self.axis == 1 and upper == "INF"):
            args.word()
            return low, self.edge(args, self.axis, True)
        return low, self.bound(args, self.axis, True, scale, edge=False)

    def _take(self) -> None:
        self.center = [q.number(self.sim) for q in self._center]
        self.radii = [q.number(self.sim) for q in self._radii]
        self.low, self.high = (q.number(self.sim) for q in self._ends)

    def reshape(self) -> None:
        self._take()
        if min(self.radii) < 0.0 or self.radii == [0.0, 0.0]:
            self.bad_value()

    def contains(self, x: Floats) -> Inside:
        a, b = (x[:, d] - c for d, c in zip(self.across, self.center, strict=True))
        along = x[:, self.axis]
        lower, upper = self.radii
        radius = lower + (along - self.low) * (upper - lower) / (self.high - self.low)
        return np.asarray((np.sqrt(a * a + b * b) <= radius) & (along >= self.low) & (along <= self.high))

    def from_inside(self, x: Floats, cutoff: float) -> list[Contact]:
        r, rims = self._rims(x)
        along = x[:, self.axis]
        lower, upper = self.radii
        radius = lower + (along - self.low) * (upper - lower) / (self.high - self.low)
        inside = (r <= radius) & within(x, self.axis, self.low, self.high)
        contacts = []
        if not self.open_face(3):
            curved = to_point(x, on_segment(x, *rims), inside & (r > 0.0), cutoff)
            curved.near &= curved.distance > 0.0
            contacts.append(curved)
        for face, gap in ((1, along - self.low), (2, self.high - along)):
            if not self.open_face(face):
                contacts.append(along_axis(gap, inside & (gap < cutoff), self.axis, face == 2))
        return contacts

    def from_outside(self, x: Floats, cutoff: float) -> list[Contact]:
        r, rims = self._rims(x)
        along = x[:, self.axis]
        lower, upper = self.radii
        radius = lower + (along - self.low) * (upper - lower) / (self.high - self.low)
        far = (r >= max(self.radii) + cutoff) | (along <= self.low - cutoff) | (along >= self.high + cutoff)
        inside = (r < radius) & (along > self.low) & (along < self.high)
        faces = [] if self.open_face(3) else [on_segment(x, *rims)]
        for face, (rim, end) in enumerate(zip(rims, (self.low, self.high), strict=True), 1):
            if not self.open_face(face):
                middle = np.empty_like(x)
                middle[:, self.across] = self.center
                middle[:, self.axis] = end
                faces.append(on_segment(x, rim, middle))
        return [to_point(x, closest(x, faces), ~far & ~inside, cutoff)] if faces else []

    def _rims(self, x: Floats) -> tuple[Floats, list[Floats]]:
        """Distance from the axis, and the points of both rims in the direction of each x."""
        u, v = (x[:, k] - c for k, c in zip(self.across, self.center, strict=True))
        r = np.sqrt(u * u + v * v)
        rims = []
        for radius, end in zip(self.radii, (self.low, self.high), strict=True):
            rim = np.empty_like(x)
            with np.errstate(divide="ignore", invalid="ignore"):
                for k, d, c in zip(self.across, (u, v), self.center, strict=True):
                    rim[:, k] = c + d * radius / r
            rim[:, self.axis] = end
            rims.append(rim)
        return r, rims
