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
