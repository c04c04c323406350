"""The full neighbor list of the fast engine."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.fast import blocks, nobody
from pylmp.kernels.fast import neighbor as loops
from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES, WIDE
from pylmp.kernels.store import kernel
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.engines.fast_bonds import LeftOut
    from pylmp.model.atoms import Floats
    from pylmp.model.simulation import Simulation

_SINGLE = 2.0**-20  # of the box length: more than single precision and the shift of images lose


class FullList:
    """neighbors int32, at first[b] + 8 k + lane: entry k of a row of block b, times 3. depth, edges (blocks,) (kernels/fast/neighbor.py)."""

    def __init__(self, sim: Simulation) -> None:
        self.cutoff = float(sim.pair.cut.max()) + sim.neighbor.skin
        self._flat = sim.dimension == 2
        self._excluding = sim.has_bonds and 0.0 in sim.special.lj
        self._sort = loops.sorting()
        self._list = loops.listing(sim.box.periodic, self._flat, self._excluding)
        self._weave = loops.weaving()
        self._width, self._room = 3 * WIDE, 1024
        self.first, self.depth, self.edges = np.zeros(0, np.int64), np.zeros(0, np.int32), np.zeros(0, np.uint8)
        self.neighbors = np.zeros(1024, np.int32)
        self._found, self._edge = np.zeros(0, np.int32), np.zeros(0, np.uint8)
        self._listed = self._start = self._stamp = self._cell = self._order = np.zeros(0, np.int32)
        self._near = [np.zeros(0, np.float32)] * 3
        self._candidates = [np.zeros(self._room, np.float32) for _ in range(3)]
        self._candidate_rows = np.zeros(self._room, np.int32)
        self._corner, self._inverse, self._length, self._counts = np.zeros(3), np.zeros(3), np.zeros(3), np.ones(3, np.int64)
        self._margin = 0.0
        self._nothing = np.zeros(1, np.int64), np.zeros(1, np.int32)
        self._rows = 0

    def functions(self) -> list[Function]:
        return [self._sort, self._list, self._weave]

    @property
    def count(self) -> int:
        """Entries: each pair twice."""
        return int(self._found[: self._rows].sum())

    @property
    def half(self) -> int:
        """Entries that the log reports: each pair once."""
        return self.count // 2

    full = whole = None  # a list that computes could look at: none

    def build(self, sim: Simulation, left_out: LeftOut | None, least: Floats, most: Floats) -> None:
        """List the neighbors of all atoms, which are between least and most (3,). Raises ScriptError where a position is not a number, or too many are too close."""
        atoms, n = sim.atoms, sim.atoms.n
        self._grid(sim, least, most)
        self._fit(n, int(self._counts.prod()))
        cells = kernel(self._sort).bind(
            atoms.x, self._corner, self._inverse, self._counts, self._cell, self._start, self._order, *self._near, n,
        )()  # fmt: skip
        if cells < 0.0:
            raise ScriptError("Non-numeric atom coords - simulation unstable", hint="a smaller timestep, or forces that do not diverge")
        excluded = (left_out.first, left_out.rows) if self._excluding and left_out else self._nothing
        self._stamp.fill(-1)
        while True:
            deepest = kernel(self._list).bind(
                self._start, self._order, *self._near, self._counts, self._length, self._margin * self._margin, *self._candidates, self._candidate_rows,
                self._room, *excluded, self._stamp, self._found, self._edge, self._listed, self._width,
            )()  # fmt: skip
            if deepest >= 0.0 or self._width > sim.neighbor.one + WIDE:
                break
            self._more(n, deepest == loops.WIDTH)
        if not 0.0 <= deepest <= sim.neighbor.one:
            raise ScriptError("Neighbor list overflow, boost neigh_modify one", manual="neigh_modify.html")
        while True:
            entries = kernel(self._weave).bind(
                self._listed, self._width, self._found, self._edge, self.first, self.depth, self.edges, self.neighbors,
                len(self.neighbors), nobody(n), blocks(n),
            )()  # fmt: skip
            if entries != loops.ROOM:
                break
            self.neighbors = np.zeros(2 * len(self.neighbors), np.int32)
        self._rows = n

    def _grid(self, sim: Simulation, least: Floats, most: Floats) -> None:
        """Corner, counts and inverse sizes of cells no smaller than the cutoff and not many more than atoms."""
        box, counts = sim.box, [1, 1, 1]
        widest_box = 0.0
        lows, highs, lowest, highest = box.lo.tolist(), box.hi.tolist(), least.tolist(), most.tolist()
        for d, periodic in enumerate(box.periodic):
            low, high = (lows[d], highs[d]) if periodic else (lowest[d], highest[d])
            length = max(high - low, 1.0e-6 * self.cutoff)
            widest_box = max(widest_box, length)
            counts[d] = 1 if d == 2 and self._flat else max(1, int(length / self.cutoff))
            self._corner[d], self._inverse[d], self._length[d] = low, 1.0 / length, highs[d] - lows[d]
        self._margin = self.cutoff + _SINGLE * widest_box
        most_cells = 4 * sim.atoms.n + 64
        while counts[0] * counts[1] * counts[2] > most_cells:
            widest = counts.index(max(counts))
            counts[widest] = max(1, counts[widest] // 2)
        self._counts[:] = counts
        self._inverse *= self._counts

    def _fit(self, n: int, cells: int) -> None:
        rows = LANES * blocks(n)
        if len(self._found) < rows or len(self.first) < blocks(n):
            self._found, self._edge = np.zeros(rows, np.int32), np.zeros(rows, np.uint8)
            self.first, self.depth, self.edges = np.zeros(blocks(n), np.int64), np.zeros(blocks(n), np.int32), np.zeros(blocks(n), np.uint8)
            self._cell, self._order = np.zeros(n + WIDE, np.int32), np.zeros(n + WIDE, np.int32)
            self._near = [np.zeros(n + WIDE, np.float32) for _ in range(3)]
            self._stamp = np.full(n + WIDE, -1, np.int32)
            self._listed = np.zeros(self._width * rows, np.int32)
            self._start = np.zeros(0, np.int32)
        self._found[n:] = 0
        self._edge[n:] = 0
        if len(self._start) < cells + 2:
            self._start = np.zeros(cells + 2, np.int32)

    def _more(self, n: int, wider: bool) -> None:
        """Room for more neighbors of a row, or for more candidates of a cell."""
        self._stamp.fill(-1)
        if wider:
            self._width += self._width // 2
            self._listed = np.zeros(self._width * LANES * blocks(n), np.int32)
            return
        self._room *= 2
        self._candidates = [np.zeros(self._room, np.float32) for _ in range(3)]
        self._candidate_rows = np.zeros(self._room, np.int32)
