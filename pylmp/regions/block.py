"""region ID block xlo xhi ylo yhi zlo zhi"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.region import Region, bound
from pylmp.model.registry import REGIONS
from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest
from pylmp.text.words import Args


@REGIONS.register("block")
class Block(Region):
    words = 6

    def __init__(self, sim: Simulation, args: Args, scale: tuple[float, float, float]) -> None:
        low, high = [], []
        for d, axis in enumerate("xyz"):
            first = args.peek()
            low.append(bound(sim, args, d, False, scale[d]))
            high.append(bound(sim, args, d, True, scale[d]))
            if low[d] > high[d]:
                args.fail(
                    f"Illegal region block {axis}lo: {shortest(low[d])} >= {axis}hi: {shortest(high[d])}", first,
                    hint="the lower bound comes first",
                )  # fmt: skip
        self.low, self.high = np.array(low), np.array(high)
        self.extent = (low[0], low[1], low[2]), (high[0], high[1], high[2])

    def contains(self, x: Floats) -> NDArray[np.bool_]:
        return np.asarray(((x >= self.low) & (x <= self.high)).all(axis=1))
