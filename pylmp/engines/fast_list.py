"""The full neighbor list of the fast engine."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pylmp.kernels.fast import blocks, nobody
from pylmp.kernels.fast import neighbor as loops
from pylmp.kernels.fast.choosing import few_types
from pylmp.kernels.fast.renewal import gridding, unmark
from pylmp.kernels.kinds import Function
from pylmp.kernels.simd import LANES, WIDE
from pylmp.kernels.store import kernel
from pylmp.kernels.team import cuts
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.neighbor import Grid
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.engines.fast_bonds import LeftOut
    from pylmp.model.atoms import Floats, Ints
    from pylmp.model.simulation import Simulation

PARTS_A_THREAD = 2  # of a share: who is late takes fewer
SHARE = LANES * 2**15  # rows that are listed before they are woven: what is listed needs room for these only
_FEW = 64  # cells there may be, besides four an atom
_SPARE = 1.3  # the next list may be longer; memory that nobody touches costs nothing
_SINGLE = 2.0**-20  # of the box length: more than single precision and the shift of images lose

Step = tuple[Callable[[], float], float, float]  # a call, and between what its result lies if all is well
Small = NDArray[np.int32]


class FullList:
    """neighbors int32, at first[b] + 8 k + lane: entry k of a row of block b, times 3. depth, edges (blocks,) (kernels/fast/neighbor.py)."""

    def __init__(self, sim: Simulation, before: FullList | None = None) -> None:
        """before: a list that nobody needs any longer, whose room this one takes."""
        self.cutoff = float(sim.pair.cut.max()) + sim.neighbor.skin
        self._flat = sim.dimension == 2
        self._excluding = sim.has_bonds and 0.0 in sim.special.lj
        self._sort = loops.sorting()
        self._list = loops.listing(sim.box.periodic, self._flat, self._excluding)
        self.types = few_types(sim.atom_types)  # where there are several, entries hold them
        self._place, self._weave = loops.placing(), loops.weaving(self.types)
        self._grid = gridding(sim.box.periodic, self._flat)
        self._unmark: Function = unmark
        self._team = sim.team
        self._parts = PARTS_A_THREAD * sim.team.threads if sim.team.threads > 1 and len(cuts(sim.atoms.n)) > 1 else 1
        self._room, self._most_listed = 1024, 0  # for each part
        self.first, self.depth, self.edges = np.zeros(1, np.int64), np.zeros(0, np.int32), np.zeros(0, np.uint8)
        self.neighbors = np.zeros(1024, np.int32)
        self._found, self._edge = np.zeros(0, np.int32), np.zeros(0, np.uint8)
        self._at_first = self._listed = self._start = self._cell = self._order = np.zeros(0, np.int32)
        self._stamps = [np.zeros(0, np.int32)] * self._parts
        self._near = [np.zeros(0, np.float32)] * 3
        self._candidates: list[tuple[NDArray[Any], ...]] = []
        self._corner, self._inverse, self._length, self._counts = np.zeros(3), np.zeros(3), np.zeros(3), np.ones(3, np.int64)
        self._limit2 = np.zeros(1)
        self.steps: list[Step] = []  # what build called, and between what each result lies if all is well
        self._nothing = np.zeros(1, np.int64), np.zeros(1, np.int32)
        self._rows, self._checked = 0, b""
        if before:
            self.neighbors, self._listed = before.neighbors, before._listed
            self._most_listed = max(0, (len(self._listed) - sim.neighbor.one - WIDE) // self._parts)

    def functions(self) -> list[Function]:
        return [self._sort, self._list, self._place, self._weave, self._grid, self._unmark]

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

    def build(self, sim: Simulation, left_out: LeftOut | None, least: Floats, most: Floats, kinds: Small) -> None:
        """List the neighbors of all atoms, which are between least and most (3,); kinds[3 i]: type of row i.

        Raises ScriptError where a position is not a number, or too many are too close.
        """
        atoms, n = sim.atoms, sim.atoms.n
        self._check(sim)
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
        self.steps = [(grid, 0.0, 0.0), (sort, 0.0, 0.0)]
        for stamp in self._stamps if self._excluding else ():
            blank = kernel(self._unmark).bind(stamp, len(stamp))
            blank()
            self.steps.append((blank, 0.0, 0.0))
        shares = [(begin, min(begin + SHARE, n)) for begin in range(0, n, SHARE)]
        for begin, end in shares:
            self._build_share(sim, excluded, kinds, begin, end)
        for begin, end in shares:  # bound only now: later shares may have moved the arrays
            listing = self._team.job(self._listing(excluded, n, sim.neighbor.one, begin, end))
            self.steps += [(call, 0.0, 0.0) for call in (listing, self._placing(begin, end), self._weaving(n, kinds, begin, end))]
        self._rows = n

    def _check(self, sim: Simulation) -> None:
        """Raises ScriptError where LAMMPS cannot lay its bins out in the box, which this list does without."""
        corners = sim.box.corners().tobytes()
        if corners != self._checked:
            Grid(sim, self.cutoff, ghost_cutoff(sim))
            self._checked = corners

    def _build_share(self, sim: Simulation, excluded: tuple[Ints, Small], kinds: Small, begin: int, end: int) -> None:
        """List rows begin to end and weave them, with more room where it takes more."""
        n, one = sim.atoms.n, sim.neighbor.one
        while said := {call() for call in self._listing(excluded, n, one, begin, end)} - {0.0}:
            if loops.MANY in said:
                raise ScriptError("Neighbor list overflow, boost neigh_modify one", manual="neigh_modify.html")
            self._more(loops.FULL in said, one)
        if self._placing(begin, end)() == loops.SHORT:
            used, room = int(self.first[begin // LANES]), int(self.first[blocks(end)])
            woven, self.neighbors = self.neighbors[:used], np.zeros(int(_SPARE * room * n / end), np.int32)  # more shares follow
            self.neighbors[:used] = woven
        self._weaving(n, kinds, begin, end)()

    def _listing(self, excluded: tuple[Ints, Small], n: int, one: int, begin: int, end: int) -> list[Callable[[], float]]:
        """Calls that list rows begin to end, each those in some of the cells, with room of its own."""
        parts, most = self._parts, self._most_listed
        if len(self._candidates) != parts:
            self._candidates = [(*(np.zeros(self._room, np.float32) for _ in range(3)), np.zeros(self._room, np.int32)) for _ in range(parts)]
        edges = [n * p // parts for p in range(parts + 1)]
        return [
            kernel(self._list).bind(
                self._start, self._order, *self._near, self._counts, self._length, self._limit2, *self._candidates[p], self._room, *excluded,
                self._stamps[p], self._found, self._edge, self._at_first, self._listed, p * most, (p + 1) * most, one, begin, end,
                edges[p], edges[p + 1],
            )
            for p in range(parts)
        ]  # fmt: skip

    def _placing(self, begin: int, end: int) -> Callable[[], float]:
        return kernel(self._place).bind(
            self._found, self._edge, self.first, self.depth, self.edges, len(self.neighbors), begin // LANES, blocks(end)
        )

    def _weaving(self, n: int, kinds: Small, begin: int, end: int) -> Callable[[], float]:
        first, last = begin // LANES, blocks(end)

        def weave(a: int, b: int) -> Callable[[], float]:
            return kernel(self._weave).bind(
                self._listed, self._at_first, self._found, kinds, self.first, self.depth, self.neighbors, nobody(n), first + a, first + b
            )

        return self._team.split(last - first, weave, LANES)

    def _fit(self, n: int) -> None:
        rows = LANES * blocks(n)
        if len(self._found) < rows or len(self.first) <= blocks(n):
            self._found, self._edge = np.zeros(rows, np.int32), np.zeros(rows, np.uint8)
            self.first, self.depth, self.edges = np.zeros(blocks(n) + 1, np.int64), np.zeros(blocks(n), np.int32), np.zeros(blocks(n), np.uint8)
            self._cell, self._order = np.zeros(n + WIDE, np.int32), np.zeros(n + WIDE, np.int32)
            self._near = [np.zeros(n + WIDE, np.float32) for _ in range(3)]
            self._stamps = [np.full(n + WIDE if self._excluding else 0, -1, np.int32) for _ in self._stamps]
            self._at_first = np.zeros(rows, np.int32)
        if len(self._start) < 4 * rows + _FEW + 2:
            self._start = np.zeros(4 * rows + _FEW + 2, np.int32)
        self._found[n:] = 0
        self._edge[n:] = 0

    def _more(self, listed: bool, one: int) -> None:
        """Room for more listed rows, or for more candidates of a cell."""
        if listed:
            self._most_listed = 2 * self._most_listed + 2**16 // self._parts
            self._listed = self._nothing[1]  # not both at once
            self._listed = np.zeros(self._parts * self._most_listed + one + WIDE, np.int32)  # a short row is read as far as the longest one in its block
            return
        self._room *= 2
        self._candidates = []
