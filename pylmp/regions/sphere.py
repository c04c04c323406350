"""region ID sphere x y z radius"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.region import Region, number
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("sphere")
class Sphere(Region):
    words = 4

    def __init__(self, sim: Simulation, args: Args, scale: tuple[float, float, float]) -> None:
        x, y, z = (scale[d] * number(args, args.word()) for d in range(3))
        radius = scale[0] * number(args, args.word())
        if radius < 0.0:
            args.fail(f"Illegal region sphere radius: {shortest(radius)}")
        self.center, self.radius = (x, y, z), radius
        self.extent = (x - radius, y - radius, z - radius), (x + radius, y + radius, z + radius)

    def contains(self, x: Floats) -> NDArray[np.bool_]:
        a, b, c = (x[:, d] - self.center[d] for d in range(3))
        return np.asarray(np.sqrt(a * a + b * b + c * c) <= self.radius)
