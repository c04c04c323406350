"""region ID intersect N REGION1 REGION2 ...: points that lie in each of N regions."""

from __future__ import annotations

import numpy as np

from pylmp.model.compound import Compound
from pylmp.model.region import Extent, Inside
from pylmp.model.registry import REGIONS


@REGIONS.register("intersect")
class Intersect(Compound):
    style = "intersect"

    def combine(self, insides: list[Inside]) -> Inside:
        return np.asarray(np.logical_and.reduce(insides))

    def join(self, extents: list[Extent | None]) -> Extent | None:
        """What the bounded parts have in common."""
        known = [extent for extent in extents if extent is not None]
        if not known:
            return None
        low, high = (tuple(f(e[k][d] for e in known) for d in range(3)) for k, f in ((0, max), (1, min)))
        return (low[0], low[1], low[2]), (high[0], high[1], high[2])
