"""region ID cylinder axis c1 c2 radius lo hi"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.region import Region, bound, number
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("cylinder")
class Cylinder(Region):
    words = 6

    def __init__(self, sim: Simulation, args: Args, scale: tuple[float, float, float]) -> None:
        axis = args.word()
        if axis.text not in ("x", "y", "z"):
            args.fail(f"Illegal region cylinder axis: {axis.text}", axis, hint="x, y or z")
        self.axis = "xyz".index(axis.text)
        self.across = [d for d in range(3) if d != self.axis]
        a, b = (scale[d] * number(args, args.word()) for d in self.across)
        radius = scale[1 if self.axis == 0 else 0] * number(args, args.word())
        if radius <= 0.0:
            args.fail(f"Illegal radius {shortest(radius)} in region cylinder command")
        self.center, self.radius = (a, b), radius
        self.low = bound(sim, args, self.axis, False, scale[self.axis])
        self.high = bound(sim, args, self.axis, True, scale[self.axis])
        if self.low > self.high:
            args.fail("Illegal cylinder length in region cylinder command", hint="the lower end comes first")
        corners = []
        for sign, end in ((-1.0, self.low), (1.0, self.high)):
            corner = [0.0, 0.0, 0.0]
            corner[self.axis] = end
            for d, c in zip(self.across, self.center, strict=True):
                corner[d] = c + sign * radius
            corners.append((corner[0], corner[1], corner[2]))
        self.extent = corners[0], corners[1]

    def contains(self, x: Floats) -> NDArray[np.bool_]:
        a, b = (x[:, d] - c for d, c in zip(self.across, self.center, strict=True))
        along = x[:, self.axis]
        return np.asarray((np.sqrt(a * a + b * b) <= self.radius) & (along >= self.low) & (along <= self.high))
