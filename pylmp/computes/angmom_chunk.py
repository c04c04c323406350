"""compute ID GROUP angmom/chunk CHUNK-ID: angular momentum of each chunk about its center of mass.

Source: LAMMPS manual, compute_angmom_chunk.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.chunks import WordlessOfChunks, sums
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation


@COMPUTES.register("angmom/chunk")
class AngularMomentumOfChunks(WordlessOfChunks):
    style = "angmom/chunk"
    columns = 3

    def array(self, sim: Simulation) -> Floats:
        """(chunks, 3)"""
        d, rows, ids, count = self.arms(sim)
        x, y, z = d.T
        m = sim.masses()[rows]
        a, b, c = sim.atoms.v[: sim.atoms.n][rows].T
        terms = np.stack([m * (y * c - z * b), m * (z * a - x * c), m * (x * b - y * a)], axis=1)
        return sums(ids, terms, count)
