"""region ID prism xlo xhi ylo yhi zlo zhi xy xz yz: a parallelepiped; the box of create_box becomes triclinic.

A point belongs to it if its fractions of the vectors (xhi-xlo 0 0), (xy yhi-ylo 0), (xz yz zhi-zlo) are within 0 and 1.
Source: LAMMPS manual, region.html.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.region import BIG, Region, bound, number
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("prism")
class Prism(Region):
    words = 9

    def __init__(self, sim: Simulation, args: Args, scale: tuple[float, float, float]) -> None:
        words = args.words[args.at :]
        low, high = [], []
        for d in range(3):
            low.append(bound(sim, args, d, False, scale[d]))
            high.append(bound(sim, args, d, True, scale[d]))
        xy, xz, yz = (scale[d] * number(args, args.word()) for d in (0, 0, 1))
        for d, axis in enumerate("xyz"):
            if low[d] >= high[d]:
                args.fail(
                    f"Illegal region prism {axis}lo: {shortest(low[d])} >= {axis}hi: {shortest(high[d])}", words[2 * d],
                    hint="the lower bound comes first",
                )  # fmt: skip
        endless = [abs(low[d]) == BIG or abs(high[d]) == BIG for d in range(3)]
        for name, tilt, place in (("xy", xy, 6), ("xz", xz, 7), ("yz", yz, 8)):
            for axis in name:
                if tilt != 0.0 and endless["xyz".index(axis)]:
                    args.fail(f"Illegal region prism non-zero {name} tilt with infinite {axis} size", words[place])
        self.low = np.array(low)
        a, b, c = (hi - lo for lo, hi in zip(low, high, strict=True))
        self.inverse = 1.0 / a, -xy / (a * b), (xy * yz - xz * b) / (a * b * c), 1.0 / b, -yz / (b * c), 1.0 / c
        self.cell = (low[0], low[1], low[2]), (high[0], high[1], high[2]), (xy, xz, yz)
        least_x, most_x = min(low[0], low[0] + xy), max(high[0], high[0] + xy)
        self.extent = (
            (min(least_x, least_x + xz), min(low[1], low[1] + yz), low[2]),
            (max(most_x, most_x + xz), max(high[1], high[1] + yz), high[2]),
        )

    def contains(self, x: Floats) -> NDArray[np.bool_]:
        xx, xy, xz, yy, yz, zz = self.inverse
        d = x - self.low
        a = xx * d[:, 0] + xy * d[:, 1] + xz * d[:, 2]
        b = yy * d[:, 1] + yz * d[:, 2]
        c = zz * d[:, 2]
        return np.asarray((a >= 0.0) & (a <= 1.0) & (b >= 0.0) & (b <= 1.0) & (c >= 0.0) & (c <= 1.0))
