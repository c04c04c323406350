"""compute ID GROUP torque/chunk CHUNK-ID: torque on each chunk about its center of mass.

Source: LAMMPS manual, compute_torque_chunk.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.chunks import WordlessOfChunks, sums
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation


@COMPUTES.register("torque/chunk")
class TorqueOfChunks(WordlessOfChunks):
    style = "torque/chunk"
    columns = 3

    def array(self, sim: Simulation) -> Floats:
        """(chunks, 3)"""
        d, rows, ids, count = self.arms(sim)
        x, y, z = d.T
        a, b, c = sim.atoms.f[: sim.atoms.n][rows].T
        terms = np.stack([y * c - z * b, z * a - x * c, x * b - y * a], axis=1)
        return sums(ids, terms, count)
