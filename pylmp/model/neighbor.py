"""Neighbor lists of a simulation: the grid of bins, the stencil, the list."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact import INDEX_MASK
from pylmp.kernels.exact import neighbor as loops
from pylmp.kernels.kinds import Function
from pylmp.kernels.store import kernel
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.atoms import Floats
    from pylmp.model.box import Box
    from pylmp.model.simulation import Simulation

_SMALL = 1.0e-6  # of the box length: how far beyond the ghosts the grid reaches
_MANY = 2**31 - 1  # LAMMPS counts bins in 32 bits
_ROOM = 2**28  # bins for which there is room: their table takes 2 GB
_FLEW = "an atom flew off and took a shrink-wrapped face along: a smaller timestep, or boundary f"
_ENDLESS = np.full(3, -1.0e300), np.full(3, 1.0e300)  # a box for everybody
_FLAT = 100.0  # bins, as large as they should be, that would fit into the neighbor cutoff of a box that flat
EXCLUDE, ORDINARY, FLAGGED = 0, 1, 2


def policy(sim: Simulation) -> tuple[int, int, int, int]:
    """What becomes of 1-2, 1-3, 1-4 pairs (entries 1 to 3): left out, ordinary, or flagged with their kind."""
    kinds = [ORDINARY]
    for lj, coul in zip(sim.special.lj, sim.special.coul, strict=True):
        if lj == 0.0 and coul == 0.0:
            kinds.append(EXCLUDE)
        else:
            kinds.append(ORDINARY if lj == 1.0 and coul == 1.0 else FLAGGED)
    a, b, c, d = kinds
    return a, b, c, d


class Grid:
    """Bins of half the neighbor cutoff, padded beyond the ghosts; numbers as LAMMPS rounds them."""

    def __init__(self, sim: Simulation, cutoff: float, ghost_cutoff: float) -> None:
        box = sim.box
        lows, highs = box.bounds
        from_, to = self._reached(box, ghost_cutoff)
        count, low, size, reach = [1, 1, 1], [-1, -1, -1], [3, 3, 3], [0, 0, 0]
        self.width = [1.0, 1.0, 1.0]
        inverse = [1.0, 1.0, 1.0]
        bin_size = sim.neighbor.bin_size or 0.5 * cutoff
        per_bin = 1.0 / bin_size
        lengths = highs - lows
        if not (lengths[: sim.dimension] * per_bin <= _MANY).all():
            raise ScriptError("Domain too large for neighbor bins", manual="Errors_details.html#err0017", hint=_FLEW)
        if (bin_size > _FLAT * lengths).any():
            page = "Errors_details.html#err0015"
            raise ScriptError("Cannot use neighbor bins - box size << cutoff", hint="a thicker box", manual=page)
        for d in range(sim.dimension):
            lo, hi = float(lows[d]), float(highs[d])
            length = hi - lo
            count[d] = max(1, int(length * per_bin))
            self.width[d] = length / count[d]
            inverse[d] = 1.0 / self.width[d]
            edge = float(from_[d]) - _SMALL * length
            first = int((edge - lo) * inverse[d])
            if edge < lo:
                first -= 1
            last = int((float(to[d]) + _SMALL * length - lo) * inverse[d])
            low[d], size[d] = first - 1, last + 1 - (first - 1) + 1
            reach[d] = int(cutoff * inverse[d])
            if reach[d] * self.width[d] < cutoff:
                reach[d] += 1
        self.reach = reach
        self.size = size
        self.cutoff = cutoff
        self.numbers = np.array(count + low + size, np.int64)
        self.inverse = np.array(inverse)
        self.bins = size[0] * size[1] * size[2]
        if self.bins > _MANY:
            raise ScriptError("Too many neighbor bins", hint=_FLEW)
        if self.bins > _ROOM:  # LAMMPS says so where memory ends
            raise ScriptError(f"Failed to allocate {4 * self.bins} bytes for array neigh:binhead", hint=_FLEW)

    @staticmethod
    def _reached(box: Box, ghost_cutoff: float) -> tuple[Floats, Floats]:
        """Lowest and highest corner of the space where ghosts may be."""
        (lo, hi), reach = box.frame, box.frame_reach(ghost_cutoff)
        return box.brick(lo - reach, hi + reach)

    def stencil(self, half: bool) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
        """[rows, first, last, first, last, ...]: runs of bins near a bin, relative to it, in LAMMPS's order.

        half: the bins after it in z, then y, then x only.
        """
        sx, sy, sz = self.reach
        rows: list[int] = []
        for k in range(0 if half else -sz, sz + 1):
            for j in range(-sy, sy + 1):
                if half and k == 0 and j < 0:
                    continue
                start = 1 if half and k == 0 and j == 0 else -sx
                near = [i for i in range(start, sx + 1) if self._distance2(i, j, k) < self.cutoff * self.cutoff]
                if near:
                    base = (k * self.size[1] + j) * self.size[0]
                    rows += [base + near[0], base + near[-1]]
        return np.array([len(rows) // 2, *rows], np.int64)

    def _distance2(self, i: int, j: int, k: int) -> float:
        """Squared distance between the nearest corners of two bins."""
        gaps = [(abs(n) - 1) * w if n else 0.0 for n, w in zip((i, j, k), self.width, strict=True)]
        return gaps[0] * gaps[0] + gaps[1] * gaps[1] + gaps[2] * gaps[2]


class OneBin(Grid):
    """A grid of a single bin."""

    def __init__(self, sim: Simulation, cutoff: float, ghost_cutoff: float) -> None:
        self.numbers = np.array([1, 1, 1, 0, 0, 0, 1, 1, 2], np.int64)  # two layers: in two dimensions atoms are in the second
        self.inverse = np.zeros(3)
        self.bins = 2

    def stencil(self, half: bool) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
        return np.array([1, 0, 0], np.int64)


class NeighborList:
    """first (n + 1,) int64, neighbors int32: row i's entries are neighbors[first[i]:first[i+1]].

    cutoff: how far neighbors are listed, whatever their types; 0.0: as the pair style says, and the skin
    """

    def __init__(self, sim: Simulation, mode: str, cutoff: float = 0.0) -> None:
        self.mode = mode
        self.cutoff = cutoff
        kinds = policy(sim)
        weighted = sim.has_bonds and any(kind != ORDINARY for kind in kinds)
        self.policy = np.array(kinds, np.int64)
        one_cutoff = cutoff > 0.0 or bool((sim.pair.cut[1:, 1:] == sim.pair.cut[1, 1]).all())
        self._bins = loops.bins(sim.dimension)
        self._all_pairs = sim.neighbor.style == "nsq"  # as one bin for everybody, in which ghosts are told apart as in tilted boxes
        if mode == loops.HALF and (sim.box.triclinic or self._all_pairs):
            self.mode = loops.HALF_TRICLINIC
        near = 0.01 * sim.units.angstrom if sim.box.triclinic else 0.0
        self._list = loops.listing(self.mode, one_cutoff, weighted, sim.box.periodic, near)
        self.first = np.zeros(1, np.int64)
        self.neighbors = np.zeros(1024, np.int32)
        self._grid: tuple[tuple[float, ...], Grid, np.ndarray[tuple[int], np.dtype[np.int64]]] | None = None
        self._scratch = (np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros(0))
        self._start = np.zeros(0, np.int64)

    def functions(self) -> list[Function]:
        return [self._bins, self._list]

    @property
    def count(self) -> int:
        return int(self.first[-1])

    def build(self, sim: Simulation, ghost_cutoff: float) -> None:
        """List the neighbors of all owned atoms; ghosts are there. Raises ScriptError on lost or crowded atoms."""
        atoms, box = sim.atoms, sim.box
        grid, rows = self._geometry(sim, ghost_cutoff)
        bin_of, member, at, place = self._fit(atoms.capacity, grid.bins)
        lost = kernel(self._bins).bind(
            atoms.x, *(_ENDLESS if self._all_pairs else box.bounds), grid.inverse, grid.numbers, bin_of, self._start, member, at, atoms.total
        )()
        if lost < 0.0:
            row = int(-1.0 - lost)
            raise ScriptError(
                "Non-numeric atom coords - simulation unstable"
                if not np.isfinite(atoms.x[row]).all()
                else f"Atom {int(atoms.tag[row])} has left the neighbor grid at step {sim.step}",
                hint="a smaller timestep, or forces that do not diverge",
            )
        skin = sim.neighbor.skin
        cut2 = np.where(sim.pair.cut > 0.0, (sim.pair.cut + skin) * (sim.pair.cut + skin), -1.0)
        if self.cutoff > 0.0:
            cut2[:] = self.cutoff * self.cutoff
        halves = 0.5 * box.length
        if len(self.first) != atoms.n + 1:
            self.first = np.zeros(atoms.n + 1, np.int64)
        while True:
            entries = kernel(self._list).bind(
                atoms.x, atoms.type, atoms.tag, bin_of, self._start, member, at, place, rows, cut2, len(cut2),
                atoms.num_special, atoms.special, atoms.max_special, self.policy, halves, self.first, self.neighbors,
                atoms.n, atoms.total, len(self.neighbors),
            )()  # fmt: skip
            if entries >= 0.0:
                break
            self.neighbors = np.zeros(2 * len(self.neighbors), np.int32)
        if sim.neighbor.exclude:
            self._exclude(sim)
        if atoms.n and int(np.diff(self.first).max()) > sim.neighbor.one:
            raise ScriptError("Neighbor list overflow, boost neigh_modify one", manual="neigh_modify.html")

    def _exclude(self, sim: Simulation) -> None:
        n = sim.atoms.n
        rows = np.repeat(np.arange(n), np.diff(self.first))
        entries = self.neighbors[: self.count]
        keep = ~sim.neighbor.exclude.drop(sim, rows, (entries & INDEX_MASK).astype(np.int64))
        self.neighbors[: int(keep.sum())] = entries[keep]
        self.first[1:] = np.cumsum(np.bincount(rows[keep], minlength=n))

    def _geometry(self, sim: Simulation, ghost_cutoff: float) -> tuple[Grid, np.ndarray[tuple[int], np.dtype[np.int64]]]:
        box = sim.box
        reach = self.cutoff or sim.neighbor_cutoff
        key = (*map(float, (*box.lo, *box.hi, *box.tilt)), reach, ghost_cutoff)
        if self._grid is None or self._grid[0] != key:
            grid: Grid = (OneBin if self._all_pairs else Grid)(sim, reach, ghost_cutoff)
            self._grid = key, grid, grid.stencil(self.mode == loops.HALF)
        return self._grid[1], self._grid[2]

    def _fit(self, rows: int, bins: int):  # type: ignore[no-untyped-def]
        if len(self._scratch[0]) < rows:
            self._scratch = (*(np.zeros(rows, np.int64) for _ in range(3)), np.zeros(3 * rows))  # type: ignore[assignment]
        if len(self._start) < bins + 2:
            self._start = np.zeros(bins + 2, np.int64)
        self._start[: bins + 2] = 0
        return self._scratch
