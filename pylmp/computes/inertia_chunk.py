"""compute ID GROUP inertia/chunk CHUNK-ID: inertia tensor of each chunk about its center of mass: xx yy zz xy yz xz.

Source: LAMMPS manual, compute_inertia_chunk.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.chunks import WordlessOfChunks, sums
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation


@COMPUTES.register("inertia/chunk")
class InertiaOfChunks(WordlessOfChunks):
    style = "inertia/chunk"
    columns = 6

    def array(self, sim: Simulation) -> Floats:
        """(chunks, 6)"""
        d, rows, ids, count = self.arms(sim)
        x, y, z = d.T
        m = sim.masses()[rows]
        terms = np.stack(
            [m * (y * y + z * z), m * (x * x + z * z), m * (x * x + y * y), -(m * x * y), -(m * y * z), -(m * x * z)], axis=1
        )
        return sums(ids, terms, count)
