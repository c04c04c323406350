"""Spatial sorting of the owned atoms: neighbors in space become neighbors in memory."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_MOST = 2**31 - 1  # LAMMPS counts bins in 32 bits


class Sorter:
    """Bins of half the neighbor cutoff, laid out at set-up and, if the box changes, at each sort."""

    def __init__(self) -> None:
        self.next = 0
        self._counts: Ints = np.ones(3, np.int64)
        self._inverse: Floats = np.ones(3)
        self._low: Floats = np.zeros(3)

    def set_up(self, sim: Simulation) -> None:
        """Before a run, in the box as it is then. Raises ScriptError."""
        self._lay_out(sim)
        if math.prod(self._counts.tolist()) >= _MOST:
            raise ScriptError("Too many atom sorting bins", hint="a smaller box, or atom_modify sort 0 0")

    def _lay_out(self, sim: Simulation) -> None:
        size = sim.sort.bin_size or 0.5 * sim.neighbor_cutoff
        per_bin = 1.0 / size
        self._low, high = sim.box.brick(*sim.box.frame)
        for d in range(3):
            length = float(high[d] - self._low[d])
            many = length * per_bin
            flat = d == 2 and sim.dimension == 2
            self._counts[d] = max(1, int(many)) if many < _MOST and not flat else 1  # LAMMPS's count overflows beyond
            self._inverse[d] = self._counts[d] / length

    def sort(self, sim: Simulation) -> None:
        """Stable sort of the owned atoms by bin, x fastest. They are in frame coordinates."""
        every = sim.sort.every
        self.next = (sim.step // every) * every + every
        if sim.box.changing:
            self._lay_out(sim)
        if int(np.prod(self._counts)) == 1:
            return
        atoms = sim.atoms
        x = atoms.x[: atoms.n]
        sim.box.leave(x)
        with np.errstate(invalid="ignore"):  # that an atom is nowhere is said later
            cell = ((x - self._low) * self._inverse).astype(np.int64)
        sim.box.enter(x)
        cell = np.minimum(np.maximum(cell, 0), self._counts - 1)
        key = (cell[:, 2] * self._counts[1] + cell[:, 1]) * self._counts[0] + cell[:, 0]
        atoms.permute(np.argsort(key, kind="stable"))
