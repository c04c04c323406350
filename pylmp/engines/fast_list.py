"""The full neighbor list of the fast engine."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.fast import blocks, nobody
from pylmp.kernels.fast import neighbor as loops
from pylmp.kernels.fast.renewal import gridding, unmark
from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES, WIDE
from pylmp.kernels.store import kernel
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.engines.fast_bonds import LeftOut
    from pylmp.model.atoms import Floats
    from pylmp.model.simulation import Simulation

_FEW = 64  # cells there may be, besides four an atom
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
        self._grid = gridding(sim.box.periodic, self._flat)
        self._unmark: Function = unmark
        self._width, self._room = 3 * WIDE, 1024
        self.first, self.depth, self.edges = np.zeros(0, np.int64), np.zeros(0, np.int32), np.zeros(0, np.uint8)
        self.neighbors = np.zeros(1024, np.int32)
        self._found, self._edge = np.zeros(0, np.int32), np.zeros(0, np.uint8)
        self._listed = self._start = self._stamp = self._cell = self._order = np.zeros(0, np.int32)
        self._near = [np.zeros(0, np.float32)] * 3
        self._candidates = [np.zeros(self._room, np.float32) for _ in range(3)]
        self._candidate_rows = np.zeros(self._room, np.int32)
        self._corner, self._inverse, self._length, self._counts = np.zeros(3), np.zeros(3), np.zeros(3), np.ones(3, np.int64)
        self._limit2 = np.zeros(1)
        self.steps: list[tuple[Callable[[], float], float, float]] = []  # what build called, and between what each result lies if all is well
        self._nothing = np.zeros(1, np.int64), np.zeros(1, np.int32)
        self._rows = 0

    def functions(self) -> list[Function]:
        return [self._sort, self._list, self._weave, self._grid, self._unmark]

    @property
    def count(self) -> int:
        """Entries: each pair twice."""
        return int(self._found[: self._rows].sum())

    @property
    def half(self) -> int:
        """Entries that the log reports: each pair once."""
        return self.count // 2

    weighted, weights = False, np.zeros((1, 1))
    full = whole = None  # a list that computes could look at: none

    def build(self, sim: Simulation, left_out: LeftOut | None, least: Floats, most: Floats) -> None:
        """List the neighbors of all atoms, which are between least and most (3,). Raises ScriptError where a position is not a number, or too many are too close."""
        atoms, n = sim.atoms, sim.atoms.n
        self._fit(n)
        layout = self._corner, self._inverse, self._length, self._counts, self._limit2
        grid = kernel(self._grid).bind(
            sim.box.lo, sim.box.hi, least, most, self.cutoff, _SINGLE, 4 * n + _FEW, len(self._start) - 2, *layout,
        )  # fmt: skip
        sort = kernel(self._sort).bind(
            atoms.x, self._corner, self._inverse, self._counts, self._cell, self._start, self._order, *self._near, n,
        )  # fmt: skip
        grid()
        if sort() < 0.0:
            raise ScriptError("Non-numeric atom coords - simulation unstable", hint="a smaller timestep, or forces that do not diverge")
        excluded = (left_out.first, left_out.rows) if self._excluding and left_out else self._nothing
        while True:
            blank = kernel(self._unmark).bind(self._stamp, len(self._stamp))
            listing = kernel(self._list).bind(
                self._start, self._order, *self._near, self._counts, self._length, self._limit2, *self._candidates, self._candidate_rows,
                self._room, *excluded, self._stamp, self._found, self._edge, self._listed, self._width,
            )  # fmt: skip
            blank()
            deepest = listing()
            if deepest >= 0.0 or self._width > sim.neighbor.one + WIDE:
                break
            self._more(n, deepest == loops.WIDTH)
        if not 0.0 <= deepest <= sim.neighbor.one:
            raise ScriptError("Neighbor list overflow, boost neigh_modify one", manual="neigh_modify.html")
        while True:
            weave = kernel(self._weave).bind(
                self._listed, self._width, self._found, self._edge, self.first, self.depth, self.edges, self.neighbors,
                len(self.neighbors), nobody(n), blocks(n),
            )  # fmt: skip
            if weave() != loops.ROOM:
                break
            self.neighbors = np.zeros(2 * len(self.neighbors), np.int32)
        self._rows = n
        self.steps = [(grid, 0.0, 0.0), (sort, 0.0, 0.0), (blank, 0.0, 0.0), (listing, 0.0, sim.neighbor.one), (weave, 0.0, np.inf)]
        if not self._excluding:
            del self.steps[2]

    def _fit(self, n: int) -> None:
        rows = LANES * blocks(n)
        if len(self._found) < rows or len(self.first) < blocks(n):
            self._found, self._edge = np.zeros(rows, np.int32), np.zeros(rows, np.uint8)
            self.first, self.depth, self.edges = np.zeros(blocks(n), np.int64), np.zeros(blocks(n), np.int32), np.zeros(blocks(n), np.uint8)
            self._cell, self._order = np.zeros(n + WIDE, np.int32), np.zeros(n + WIDE, np.int32)
            self._near = [np.zeros(n + WIDE, np.float32) for _ in range(3)]
            self._stamp = np.full(n + WIDE, -1, np.int32)
            self._listed = np.zeros(self._width * rows, np.int32)
        if len(self._start) < 4 * rows + _FEW + 2:
            self._start = np.zeros(4 * rows + _FEW + 2, np.int32)
        self._found[n:] = 0
        self._edge[n:] = 0

    def _more(self, n: int, wider: bool) -> None:
        """Room for more neighbors of a row, or for more candidates of a cell."""
        if wider:
            self._width += self._width // 2
            self._listed = np.zeros(self._width * LANES * blocks(n), np.int32)
            return
        self._room *= 2
        self._candidates = [np.zeros(self._room, np.float32) for _ in range(3)]
        self._candidate_rows = np.zeros(self._room, np.int32)
