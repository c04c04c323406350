"""region ID union N REGION1 REGION2 ...: points that lie in at least one of N regions."""

from __future__ import annotations

import numpy as np

from pylmp.model.compound import Compound
from pylmp.model.region import Extent, Inside
from pylmp.model.registry import REGIONS


@REGIONS.register("union")
class Union(Compound):
    style = "union"

    def combine(self, insides: list[Inside]) -> Inside:
        return np.asarray(np.logical_or.reduce(insides))

    def join(self, extents: list[Extent | None]) -> Extent | None:
        """Bounded only if all parts are."""
        known = [extent for extent in extents if extent is not None]
        if len(known) < len(extents):
            return None
        low, high = (tuple(f(e[k][d] for e in known) for d in range(3)) for k, f in ((0, min), (1, max)))
        return (low[0], low[1], low[2]), (high[0], high[1], high[2])
