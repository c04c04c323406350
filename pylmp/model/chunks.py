"""What computes of chunks share: the compute chunk/atom they name, and sums over each chunk in atom order."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats, Ints
from pylmp.model.compute import Compute
from pylmp.model.motion import unwrapped
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


class Chunks(Protocol):
    """What compute chunk/atom offers."""

    compressed: bool
    coordinates: int

    def assign(self, sim: Simulation) -> tuple[Ints, int]:
        """(n,) chunk of each owned atom from 1, 0 for none, and how many chunks there are, now."""
        ...

    def original(self, sim: Simulation) -> Ints:
        """(chunks,) IDs before compression."""
        ...

    def centers(self, sim: Simulation) -> Floats:
        """(chunks, coordinates) middles of bins."""
        ...


class OfChunks(Compute):
    """A compute with a row a chunk: the first word names the compute chunk/atom."""

    varying = True
    length = 0

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if not len(args):
            args.missing(hint="the ID of a compute chunk/atom")
        word = args.word()
        self.source = word.text
        self.find(sim, word)

    def init(self, sim: Simulation) -> None:
        self.find(sim)

    def find(self, sim: Simulation, word: Word | None = None) -> Chunks:
        """The compute chunk/atom. Raises ScriptError if it is none, or was deleted."""
        found = sim.computes.get(self.source)
        if found is None or found.style != "chunk/atom":
            text = f"Chunk/atom compute {self.source} does not exist or is incorrect style for compute {self.style}"
            raise ScriptError(text, word.span if word else None, hint="compute ID GROUP chunk/atom ...")
        return found  # type: ignore[return-value]

    def chunked(self, sim: Simulation) -> tuple[NDArray[np.bool_], Ints, int]:
        """(n,) which owned atoms of the group are in a chunk; (k,) chunk of each from 0; how many chunks."""
        ids, count = self.find(sim).assign(sim)
        rows = self.members(sim) & (ids > 0)
        return rows, ids[rows] - 1, count

    def arms(self, sim: Simulation) -> tuple[Floats, NDArray[np.bool_], Ints, int]:
        """(k, 3) unwrapped positions relative to the chunks' centers of mass, then what chunked gives."""
        rows, ids, count = self.chunked(sim)
        x = unwrapped(sim, rows)
        return x - mean(sim, rows, ids, count, x)[ids], rows, ids, count


class WordlessOfChunks(OfChunks):
    """One that takes no further words."""

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())


class MeanOfChunks(WordlessOfChunks):
    """The mean, by mass, of a vector of atoms (values) in each chunk."""

    columns = 3

    def values(self, sim: Simulation, rows: NDArray[np.bool_]) -> Floats:
        """(k, 3) of the chosen atoms."""
        raise NotImplementedError

    def array(self, sim: Simulation) -> Floats:
        """(chunks, 3), 0.0 of a chunk without atoms"""
        rows, ids, count = self.chunked(sim)
        return mean(sim, rows, ids, count, self.values(sim, rows))


def mean(sim: Simulation, rows: NDArray[np.bool_], ids: Ints, count: int, values: Floats) -> Floats:
    """(count, m) means by mass of values (k, m) over each chunk, of atoms that OfChunks.chunked gave."""
    m = sim.masses()[rows]
    return per_mass(sums(ids, values * m[:, None], count), sums(ids, m, count))


def sums(ids: Ints, values: Floats, count: int) -> Floats:
    """(count, m) sum of values (k, m) over each chunk, (count,) of values (k,); first to last."""
    if values.ndim == 1:
        return np.asarray(np.bincount(ids, values, count)[:count], np.float64)
    return np.stack([np.bincount(ids, column, count)[:count] for column in values.T], axis=1)


def per_mass(totals: Floats, masses: Floats) -> Floats:
    """totals (count, m) over masses (count,), 0.0 where there is no mass."""
    heavy = masses > 0.0
    result = np.zeros_like(totals)
    result[heavy] = totals[heavy] / (masses[heavy, None] if totals.ndim == 2 else masses[heavy])
    return result
