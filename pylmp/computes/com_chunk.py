"""compute ID GROUP com/chunk CHUNK-ID: center of mass of each chunk, unwrapped. Source: LAMMPS manual, compute_com_chunk.html."""

from __future__ import annotations

from pylmp.model.atoms import Floats
from pylmp.model.chunks import OfChunks, per_mass, sums
from pylmp.model.motion import unwrapped
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@COMPUTES.register("com/chunk")
class CenterOfMassOfChunks(OfChunks):
    style = "com/chunk"
    columns = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())

    def array(self, sim: Simulation) -> Floats:
        """(chunks, 3), 0.0 of a chunk without atoms"""
        rows, ids, count = self.chunked(sim)
        m = sim.masses()[rows]
        return per_mass(sums(ids, unwrapped(sim, rows) * m[:, None], count), sums(ids, m, count))
