"""Ghost atoms of a simulation: periodic images within reach of the box, refreshed every step."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact import ghosts as loops
from pylmp.kernels.kinds import Function
from pylmp.kernels.store import kernel
from pylmp.model.atoms import Floats
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_MOST = 2**28  # ghosts
_NO_H = np.zeros(6)


def bond_reach(sim: Simulation) -> float:
    """LAMMPS's estimate of how far bonds reach, also of bonds to come; 0.0 without a bond style."""
    if sim.bond is None:
        return 0.0
    bodies = 4 if sim.dihedral or sim.improper else 3 if sim.angle else 2
    factors = {2: 1.5, 3: 1.5, 4: 2.25} if sim.newton_bond else {2: 1.5, 3: 2.25, 4: 3.125}
    return float(sim.bond.longest() * factors[bodies] + sim.neighbor.skin)


def ghost_cutoff(sim: Simulation, warn: bool = False, setup: bool = False) -> float:
    """How far ghosts reach: the user's cutoff, the neighbor cutoff or, without a pair style, the bond estimate."""
    cutoff = max(sim.comm.cutoff, sim.neighbor_cutoff)
    bonds = bond_reach(sim)
    if warn and cutoff == bonds == 0.0:
        sim.console.warning(
            "Communication cutoff is 0.0. No ghost atoms will be generated. "
            "Energies and forces may be wrong and atoms may get lost."
        )
    if cutoff == 0.0:
        return bonds
    if warn and bonds > cutoff:
        sim.console.warning(
            f"Communication cutoff {shortest(cutoff)} is shorter than a bond length based estimate of "
            f"{shortest(bonds)}. This may lead to errors."
        )
    if setup and 0.0 < sim.comm.cutoff < sim.neighbor_cutoff:
        sim.console.warning(f"Communication cutoff adjusted to {shortest(sim.neighbor_cutoff)}")
    return cutoff


class Ghosts:
    """Which owned or ghost row each ghost copies, and by which shift; IDs to rows."""

    def __init__(self, sim: Simulation) -> None:
        self.velocity = sim.ghost_velocity
        box = sim.box
        self.flow = self.velocity and bool(box.rate_group)
        self._borders = loops.borders(box.periodic, sim.dimension, self.flow)
        self._refresh = loops.refresh(self.velocity, box.triclinic, self.flow)
        self._reverse = loops.reverse()
        self._index = loops.index()
        self.swaps = np.zeros(2, np.int64)
        self.source = self.axis = np.zeros(0, np.int64)
        self.sign, self.place = np.zeros(0), np.zeros(0, np.int64)
        self.first = self.same = np.zeros(0, np.int64)

    def functions(self) -> list[Function]:
        return [self._borders, self._refresh, self._reverse, self._index]

    def build(self, sim: Simulation, cutoff: float) -> None:
        """Make ghosts anew, in frame coordinates; grows arrays until they fit."""
        atoms, box = sim.atoms, sim.box
        atoms.clear_ghosts()
        (lo, hi), reach = box.frame, box.frame_reach(cutoff)
        images = [reach[d] / (hi[d] - lo[d]) for d in range(sim.dimension) if box.periodic[d]]
        if not atoms.n * math.prod(1.0 + 2.0 * many for many in images) < _MOST:
            raise ScriptError("Too many ghost atoms", hint="a wider box: more of its images are within the ghost cutoff than memory holds")
        pairs = sum(2 * (int(many) + 1) for many in images)
        if len(self.swaps) < pairs + 2:
            self.swaps = np.zeros(pairs + 2, np.int64)
        atoms.reserve(atoms.n + 1)
        while True:
            self._fit(atoms.capacity)
            total = kernel(self._borders).bind(
                atoms.x, atoms.v, atoms.tag, atoms.type, atoms.mask, self.source, self.axis, self.sign, self.swaps,
                self.place, lo, hi, reach, box.rate, box.rate_group, atoms.n, atoms.capacity,
            )()  # fmt: skip
            if total >= 0.0:
                break
            atoms.reserve(2 * atoms.capacity)
        atoms.ghosts = int(total) - atoms.n
        tags = atoms.span()
        if len(self.first) != tags:
            self.first = np.zeros(tags, np.int64)
        self.first[:] = -1
        kernel(self._index).bind(atoms.tag, self.first, self.same, atoms.total)()

    def _fit(self, capacity: int) -> None:
        if len(self.source) < capacity:
            self.source = np.zeros(capacity, np.int64)
            self.axis = np.zeros(capacity, np.int64)
            self.same = np.zeros(capacity, np.int64)
            self.sign = np.zeros(capacity)
            if self.flow:
                self.place = np.zeros(capacity, np.int64)

    def bind_refresh(self, sim: Simulation) -> Callable[[], float]:
        atoms, box = sim.atoms, sim.box
        h = box.h if box.triclinic else _NO_H  # nobody looks at it
        return kernel(self._refresh).bind(
            atoms.x, atoms.v, atoms.mask, self.source, self.axis, self.sign, self.place, box.lo, box.hi, h,
            box.rate, box.rate_group, atoms.n, atoms.total,
        )  # fmt: skip

    def fold(self, values: Floats) -> None:
        """Add rows of ghosts to their sources, in place, in the order in which forces come back. values: (rows, k)."""
        count = int(self.swaps[0])
        for k in range(count - 1, -1, -1):
            rows = slice(int(self.swaps[1 + k]), int(self.swaps[2 + k]))
            np.add.at(values, self.source[rows], values[rows])

    def spread(self, values: Floats) -> None:
        """Give ghosts what their sources have, in place. values: (rows, ...)."""
        count = int(self.swaps[0])
        for k in range(count):
            rows = slice(int(self.swaps[1 + k]), int(self.swaps[2 + k]))
            values[rows] = values[self.source[rows]]

    def bind_reverse(self, sim: Simulation) -> Callable[[], float]:
        return kernel(self._reverse).bind(sim.atoms.f, self.source, self.swaps)
