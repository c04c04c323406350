"""compute ID GROUP reduce/chunk CHUNK-ID sum|min|max inputs...: per-atom values of computes, fixes and variables, reduced over each
chunk. A chunk without atoms has 0.0, 1e20 or -1e20. Source: LAMMPS manual, compute_reduce_chunk.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atom_inputs import AtomInput, read_atom_input
from pylmp.model.atoms import Floats
from pylmp.model.chunks import OfChunks, sums
from pylmp.model.reference import expand
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args

_BIG = 1.0e20


@COMPUTES.register("reduce/chunk")
class ReduceChunk(OfChunks):
    style = "reduce/chunk"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        args.need(3)
        super().__init__(sim, identity, group, bit, args)
        mode = args.word()
        if mode.text not in ("sum", "min", "max"):
            args.fail(f"Unknown compute reduce/chunk mode: {mode.text}", mode, hint="sum min max")
        self.mode = mode.text
        self.inputs: list[AtomInput] = [read_atom_input(sim, args, word) for word in expand(sim, args, args.rest(), "per_atom")]
        self.columns = len(self.inputs) if len(self.inputs) > 1 else 0
        setattr(self, "array" if len(self.inputs) == 1 else "vector", None)

    def init(self, sim: Simulation) -> None:
        super().init(sim)
        for item in self.inputs:
            item.check(sim, f"compute {self.style}")

    def _table(self, sim: Simulation) -> Floats:
        rows, ids, count = self.chunked(sim)
        columns = []
        for item in self.inputs:
            values = item.values(sim, rows, f"compute {self.style}")
            if self.mode == "sum":
                columns.append(sums(ids, values, count))
                continue
            column = np.full(count, _BIG if self.mode == "min" else -_BIG)
            (np.minimum if self.mode == "min" else np.maximum).at(column, ids, values)
            columns.append(column)
        return np.stack(columns, axis=1)

    def vector(self, sim: Simulation) -> Floats:
        return self._table(sim)[:, 0]

    def array(self, sim: Simulation) -> Floats:
        return self._table(sim)
