"""region ID cylinder AXIS c1 c2 radius lo hi: c1, c2 and radius may be equal-style variables, lo and hi INF or EDGE."""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.region import Inside, Options, Region, Scale, around_axis
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
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
