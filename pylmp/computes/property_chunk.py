"""compute ID GROUP property/chunk CHUNK-ID values...: count, id, coord1, coord2, coord3 of each chunk.

id is the chunk's ID before compression, coords are the middle of a bin. Source: LAMMPS manual, compute_property_chunk.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.chunks import OfChunks
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args

_COORDS = ("coord1", "coord2", "coord3")


@COMPUTES.register("property/chunk")
class PropertyChunk(OfChunks):
    style = "property/chunk"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        args.need(2)
        super().__init__(sim, identity, group, bit, args)
        found = self.find(sim)
        self.names = []
        for word in args.rest():
            if word.text not in ("count", "id", *_COORDS):
                args.fail(f"Unkown keyword {word.text} in compute property/chunk command", word, hint="count id coord1 coord2 coord3")
            if word.text == "id" and not found.compressed:
                args.fail("Compute chunk/atom stores no IDs for compute property/chunk", word, hint="compress yes")
            if word.text in _COORDS and _COORDS.index(word.text) >= found.coordinates:
                args.fail(f"Compute chunk/atom stores no {word.text} for compute property/chunk", word, hint="a bin style")
            self.names.append(word.text)
        self.columns = len(self.names) if len(self.names) > 1 else 0
        setattr(self, "array" if len(self.names) == 1 else "vector", None)

    def _table(self, sim: Simulation) -> Floats:
        _, ids, count = self.chunked(sim)
        found = self.find(sim)
        columns = []
        for name in self.names:
            if name == "count":
                columns.append(np.bincount(ids, minlength=count)[:count].astype(float))
            elif name == "id":
                columns.append(found.original(sim).astype(float))
            else:
                columns.append(found.centers(sim)[:, _COORDS.index(name)])
        return np.stack(columns, axis=1)

    def vector(self, sim: Simulation) -> Floats:
        return self._table(sim)[:, 0]

    def array(self, sim: Simulation) -> Floats:
        return self._table(sim)
