"""compute ID GROUP com/chunk CHUNK-ID: center of mass of each chunk, unwrapped. Source: LAMMPS manual, compute_com_chunk.html."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.chunks import MeanOfChunks
from pylmp.model.motion import unwrapped
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation


@COMPUTES.register("com/chunk")
class CenterOfMassOfChunks(MeanOfChunks):
    style = "com/chunk"

    def values(self, sim: Simulation, rows: NDArray[np.bool_]) -> Floats:
        return unwrapped(sim, rows)
