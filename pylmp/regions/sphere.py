"""region ID sphere x y z radius: each may be an equal-style variable."""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.region import Inside, Options, Region, Scale
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.model.surface import Contact, radial
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("sphere")
class Sphere(Region):
    style = "sphere"
    words = 4

    def __init__(self, sim: Simulation, args: Args, options: Options, scale: Scale) -> None:
        super().__init__(sim, options)
        self._center = [self.quantity(args, s) for s in scale]
        self._radius = self.quantity(args, scale[0])
        self.shaped()
        self._take()
        if self.radius < 0.0:
            args.fail(f"Illegal region sphere radius: {shortest(self.radius)}")
        (x, y, z), r = self.center, self.radius
        self.extent = (x - r, y - r, z - r), (x + r, y + r, z + r)

    def _take(self) -> None:
        self.center = [q.number(self.sim) for q in self._center]
        self.radius = self._radius.number(self.sim)

    def reshape(self) -> None:
        self._take()
        if self.radius < 0.0:
            self.bad_value()

    def contains(self, x: Floats) -> Inside:
        a, b, c = (x[:, d] - self.center[d] for d in range(3))
        return np.asarray(np.sqrt(a * a + b * b + c * c) <= self.radius)

    def from_inside(self, x: Floats, cutoff: float) -> list[Contact]:
        d, r = self._away(x)
        distance = self.radius - r
        return [radial(d, r, self.radius, (r <= self.radius) & (r != 0.0) & (distance < cutoff), distance)]

    def from_outside(self, x: Floats, cutoff: float) -> list[Contact]:
        d, r = self._away(x)
        distance = r - self.radius
        return [radial(d, r, self.radius, (r >= self.radius) & (distance < cutoff), distance)]

    def _away(self, x: Floats) -> tuple[Floats, Floats]:
        d = x - np.array(self.center)
        return d, np.sqrt(d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2])
