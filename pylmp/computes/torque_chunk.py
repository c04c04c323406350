"""compute ID GROUP torque/chunk CHUNK-ID: torque on each chunk about its center of mass.

Source: LAMMPS manual, compute_torque_chunk.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.chunks import OfChunks, sums
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@COMPUTES.register("torque/chunk")
class TorqueOfChunks(OfChunks):
    style = "torque/chunk"
    columns = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())

    def array(self, sim: Simulation) -> Floats:
        """(chunks, 3)"""
        d, rows, ids, count = self.arms(sim)
        x, y, z = d.T
        a, b, c = sim.atoms.f[: sim.atoms.n][rows].T
        terms = np.stack([y * c - z * b, z * a - x * c, x * b - y * a], axis=1)
        return sums(ids, terms, count)
