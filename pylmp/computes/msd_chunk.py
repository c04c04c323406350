"""compute ID GROUP msd/chunk CHUNK-ID: squared displacement of each chunk's center of mass since the first evaluation's run began.

Columns x, y, z, total. Source: LAMMPS manual, compute_msd_chunk.html.
"""

from __future__ import annotations

import struct

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.chunks import OfChunks, mean
from pylmp.model.motion import unwrapped
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@COMPUTES.register("msd/chunk")
class MeanSquaredDisplacementOfChunks(OfChunks):
    style = "msd/chunk"
    columns = 4

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        if len(args) != 1:
            args.fail("Incorrect number of arguments for compute msd/chunk", args.owner, hint="the ID of a compute chunk/atom")
        super().__init__(sim, identity, group, bit, args)
        self.start: Floats | None = None

    def setup(self, sim: Simulation) -> None:
        """Where the centers are when the first run begins."""
        if self.start is None:
            self.start = self._centers(sim)

    def state(self, sim: Simulation) -> bytes:
        """Rows, columns, and the centers; before the first run one number."""
        start = np.zeros((1, 1)) if self.start is None else self.start
        return struct.pack("<2d", *start.shape) + start.astype("<f8").tobytes()

    def restore(self, sim: Simulation, state: bytes) -> None:
        rows, columns = (int(count) for count in struct.unpack_from("<2d", state))
        values = np.frombuffer(state, "<f8", offset=16)
        if columns == 3:
            self.start = values.reshape(rows, columns).copy()

    def _centers(self, sim: Simulation) -> Floats:
        rows, ids, count = self.chunked(sim)
        return mean(sim, rows, ids, count, unwrapped(sim, rows))

    def array(self, sim: Simulation) -> Floats:
        """(chunks, 4)"""
        now = self._centers(sim)
        if self.start is None:
            self.start = now
        if len(now) != len(self.start):
            raise ScriptError("Compute msd/chunk nchunk is not static", hint="compute chunk/atom ... nchunk once")
        x, y, z = (now - self.start).T
        return np.stack([x * x, y * y, z * z, x * x + y * y + z * z], axis=1)
