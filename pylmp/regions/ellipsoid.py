"""region ID ellipsoid x y z a b c: center and half axes, each may be an equal-style variable.

(x/a)^2 + (y/b)^2 + (z/c)^2 <= 1, multiplied out; in two dimensions z and c do not count.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.region import Inside, Options, Region, Scale
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("ellipsoid")
class Ellipsoid(Region):
    style = "ellipsoid"
    words = 6

    def __init__(self, sim: Simulation, args: Args, options: Options, scale: Scale) -> None:
        super().__init__(sim, options)
        self._center = [self.quantity(args, s) for s in scale]
        self._axes = [self.quantity(args, s) for s in scale]
        self.shaped()
        self._take()
        for name, value, word in zip("abc", self.axes, args.words[5:8], strict=True):
            if value < 0.0:
                args.fail(f"Illegal region ellipsoid {name}: {shortest(value)}", word)
        (x, y, z), (a, b, c) = self.center, self.axes
        self.extent = (x - a, y - b, z - c), (x + a, y + b, z + c)

    def _take(self) -> None:
        self.center = [q.number(self.sim) for q in self._center]
        self.axes = [q.number(self.sim) for q in self._axes]

    def reshape(self) -> None:
        self._take()
        if min(self.axes) < 0.0:
            self.bad_value()

    def contains(self, x: Floats) -> Inside:
        a, b, c = self.axes
        d = [x[:, k] - self.center[k] for k in range(3)]
        if self.sim.dimension == 2:
            u, v = b * d[0], a * d[1]
            return np.asarray(u * u + v * v <= a * a * b * b)
        u, v, w = b * c * d[0], a * c * d[1], a * b * d[2]
        return np.asarray(u * u + v * v + w * w <= a * a * b * b * c * c)
