"""compute ID GROUP gyration/chunk CHUNK-ID [tensor]: radius of gyration of each chunk, or the tensor xx yy zz xy xz yz.

Source: LAMMPS manual, compute_gyration_chunk.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.chunks import OfChunks, per_mass, sums
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@COMPUTES.register("gyration/chunk")
class GyrationOfChunks(OfChunks):
    style = "gyration/chunk"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        tensor = args.take("tensor")
        if len(args):
            args.illegal(args.peek())
        self.columns = 6 if tensor else 0
        setattr(self, "vector" if tensor else "array", None)

    def _weighed(self, sim: Simulation) -> tuple[Floats, Floats, Ints, Floats, int]:
        """(k, 3) positions relative to the centers, (k,) masses, (k,) chunks, (chunks,) masses."""
        d, rows, ids, count = self.arms(sim)
        m = sim.masses()[rows]
        return d, m, ids, sums(ids, m, count), count

    def vector(self, sim: Simulation) -> Floats:
        """(chunks,)"""
        d, m, ids, masses, count = self._weighed(sim)
        x, y, z = d.T
        return np.sqrt(per_mass(sums(ids, (x * x + y * y + z * z) * m, count), masses))

    def array(self, sim: Simulation) -> Floats:
        """(chunks, 6)"""
        d, m, ids, masses, count = self._weighed(sim)
        x, y, z = d.T
        terms = np.stack([x * x * m, y * y * m, z * z * m, x * y * m, x * z * m, y * z * m], axis=1)
        return per_mass(sums(ids, terms, count), masses)
