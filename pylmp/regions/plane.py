"""region ID plane px py pz nx ny nz: the half space that the normal points into; the normal all numbers or all variables."""

from __future__ import annotations

import math

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.region import Inside, Options, Region, Scale
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.model.surface import Contact
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("plane")
class Plane(Region):
    style = "plane"
    words = 6

    def __init__(self, sim: Simulation, args: Args, options: Options, scale: Scale) -> None:
        super().__init__(sim, options)
        self._point = [self.quantity(args, s) for s in scale]
        self._normal = [self.quantity(args, s) for s in scale]
        varies = [q.varies for q in self._normal]
        if any(varies) and not all(varies):
            args.fail(
                "The components of the normal vector should be either all variables or all constants", args.words[5]
            )
        self.shaped()
        self._take()

    def _take(self) -> None:
        self.point = [q.number(self.sim) for q in self._point]
        a, b, c = (q.number(self.sim) for q in self._normal)
        length2 = a * a + b * b + c * c
        if length2 == 0.0:
            says = f"Illegal region plane normal vector: {shortest(a)} {shortest(b)} {shortest(c)}"
            self.bad_value(says)
        self.normal = [q / math.sqrt(length2) for q in (a, b, c)]

    def reshape(self) -> None:
        self._take()

    def contains(self, x: Floats) -> Inside:
        a, b, c = ((x[:, d] - self.point[d]) * self.normal[d] for d in range(3))
        return np.asarray(a + b + c >= 0.0)

    def from_inside(self, x: Floats, cutoff: float) -> list[Contact]:
        return self._touch(x, cutoff, 1.0)

    def from_outside(self, x: Floats, cutoff: float) -> list[Contact]:
        return self._touch(x, cutoff, -1.0)

    def _touch(self, x: Floats, cutoff: float, side: float) -> list[Contact]:
        a, b, c = ((x[:, d] - self.point[d]) * self.normal[d] for d in range(3))
        distance = side * (a + b + c)
        away = (side * distance)[:, None] * np.array(self.normal)
        return [Contact((distance < cutoff) & (distance >= 0.0), distance, away)]
