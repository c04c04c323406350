"""compute ID GROUP vcm/chunk CHUNK-ID: velocity of each chunk's center of mass. Source: LAMMPS manual, compute_vcm_chunk.html."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.chunks import MeanOfChunks
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation


@COMPUTES.register("vcm/chunk")
class VelocityOfChunks(MeanOfChunks):
    style = "vcm/chunk"

    def values(self, sim: Simulation, rows: NDArray[np.bool_]) -> Floats:
        velocities: Floats = sim.atoms.v[: sim.atoms.n][rows]
        return velocities
