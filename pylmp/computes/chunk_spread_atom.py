"""compute ID GROUP chunk/spread/atom CHUNK-ID inputs...: gives each atom the value of its chunk. inputs: c_ID, c_ID[N], f_ID, f_ID[N].

Source: LAMMPS manual, compute_chunk_spread_atom.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.chunks import OfChunks
from pylmp.model.compute import current
from pylmp.model.reference import Reference, offers, parse
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word


@COMPUTES.register("chunk/spread/atom")
class ChunkSpreadAtom(OfChunks):
    style = "chunk/spread/atom"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        args.need(2)
        super().__init__(sim, identity, group, bit, args)
        self.inputs = [self._input(sim, args, word) for word in args.rest()]
        self.columns = len(self.inputs) if len(self.inputs) > 1 else 0

    @staticmethod
    def _input(sim: Simulation, args: Args, word: Word) -> Reference:
        found = parse(word.text)
        if found is None or found.kind == "v" or "*" in word.text or len(found.index) > 1:
            args.fail(f"Illegal compute chunk/spread/atom argument: {word.text}", word, hint="c_ID c_ID[N] f_ID f_ID[N]")
        source, what = found.source(sim), found.what
        if source is None:
            args.fail(f"{what.capitalize()} ID {found.name} for compute chunk/spread/atom does not exist", word)
        values = "array" if found.index else "vector"
        owner = f"Compute chunk/spread/atom {what} {found.name}"
        if not offers(source, values):
            article = "an" if found.index else "a"
            args.fail(f"{owner} does not calculate {article} global {values}", word)
        if found.index and not 1 <= found.index[0] <= source.columns:
            args.fail(f"{owner} array is accessed out-of-range", word, hint=f"1 to {source.columns}")
        return found

    def init(self, sim: Simulation) -> None:
        super().init(sim)
        for found in self.inputs:
            if found.source(sim) is None:
                text = f"{found.what.capitalize()} ID {found.name} for compute chunk/spread/atom does not exist"
                raise ScriptError(text, hint="it was deleted")

    def per_atom(self, sim: Simulation) -> Floats:
        """(n,) with one input, else (n, inputs)"""
        rows, ids, count = self.chunked(sim)
        table = np.zeros((sim.atoms.n, len(self.inputs)))
        for k, found in enumerate(self.inputs):
            values = current(sim, found.source(sim), "array" if found.index else "vector")
            column = values[:, found.index[0] - 1] if found.index else values
            padded = np.zeros(count)
            padded[: min(count, len(column))] = column[:count]
            table[rows, k] = padded[ids]
        return table if self.columns else table[:, 0]
