"""What bond_style bpm/spring volume/factor yes knows of atoms: a volume now, and the one they had at the first evaluation.

An atom's volume is the sum of r^3 (in 2d r^2) over its bonds. Source: LAMMPS manual, bond_bpm_spring.html; when it is summed, sent
around and corrected as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact import volumes as loops
from pylmp.kernels.kinds import Function
from pylmp.kernels.store import kernel
from pylmp.laws import power
from pylmp.model.atoms import Floats, Ints

if TYPE_CHECKING:
    from pylmp.model.bond import BondPart
    from pylmp.model.bondlist import BondList
    from pylmp.model.ghosts import Ghosts
    from pylmp.model.simulation import Simulation

NOW, FIRST = "bpm volume", "bpm first volume"  # in Atoms.extra


def start(sim: Simulation) -> None:
    for name in (NOW, FIRST):
        sim.atoms.extra.setdefault(name, np.zeros(sim.atoms.capacity))


def forget(sim: Simulation) -> None:
    for name in (NOW, FIRST):
        sim.atoms.extra.pop(name, None)


class Volumes:
    """Of one run."""

    def __init__(self, sim: Simulation, part: BondPart) -> None:
        planar = sim.dimension == 2
        self.part = part
        self.power = 2 if planar else 3
        self._add = loops.swell(planar, sim.bond.memory)
        self._relate = loops.compare()
        self._now = self._first = self._change = np.zeros(0)
        self._calls: list[Callable[[], float]] = []

    def functions(self) -> list[Function]:
        return [self._add, self._relate]

    def bind(self, sim: Simulation, listed: BondList) -> None:
        start(sim)
        atoms = sim.atoms
        now, first = atoms.extra[NOW], atoms.extra[FIRST]
        self._now, self._first = np.asarray(now)[: atoms.total], np.asarray(first)[: atoms.total]
        self._change = np.zeros(atoms.total)
        self._calls = [
            kernel(self._add).bind(atoms.x, listed.bonds, listed.history, now, self._change, listed.count),
            kernel(self._relate).bind(listed.bonds, now, first, listed.own, 1.0 / self.power, listed.count),
        ]

    def measure(self, sim: Simulation, ghosts: Ghosts) -> None:
        """Sum the volumes, and tell each bond of its ends. What new bonds are now is added to what both ends were at first."""
        add, relate = self._calls
        self._now.fill(0.0)
        new = add()
        if sim.newton_bond:
            ghosts.fold(self._now)
        ghosts.spread(self._now)
        if not self.part.options["volume known"]:
            self._first[: sim.atoms.n] = self._now[: sim.atoms.n]
            self.part.options["volume known"] = True
            self._change.fill(0.0)
        elif new:
            self._settle(sim, ghosts)
        ghosts.spread(self._first)
        relate()

    def lose(self, sim: Simulation, ghosts: Ghosts, listed: BondList, count: int) -> None:
        """What the first count of listed.broken were at first is taken from both of their ends."""
        for entry in listed.broken[:count].tolist():
            r0 = float(listed.history[entry, 0])
            size = r0 * r0 if self.power == 2 else r0 * r0 * r0
            for row in listed.bonds[entry, :2].tolist():
                self._change[row] -= size
        self._settle(sim, ghosts)

    def _settle(self, sim: Simulation, ghosts: Ghosts) -> None:
        if sim.newton_bond:
            ghosts.fold(self._change)
        self._first[: sim.atoms.n] += self._change[: sim.atoms.n]
        self._change.fill(0.0)


def growth(sim: Simulation, rows: Ints, partners: Ints) -> Floats:
    """What bonds between these owned atoms were told at the last evaluation."""
    start(sim)
    now, first = np.asarray(sim.atoms.extra[NOW]), np.asarray(sim.atoms.extra[FIRST])
    with np.errstate(all="ignore"):
        ratio = (now[rows] + now[partners]) / (first[rows] + first[partners])
    return np.asarray(power(ratio, 1.0 / sim.dimension))


def kept(sim: Simulation) -> Floats | None:
    """(n, 2) for restart files; None: nothing is known."""
    extra, n = sim.atoms.extra, sim.atoms.n
    return np.column_stack([extra[NOW][:n], extra[FIRST][:n]]) if NOW in extra else None


def restore(sim: Simulation, values: Floats) -> None:
    start(sim)
    for name, column in zip((NOW, FIRST), values.T, strict=True):
        sim.atoms.extra[name][: sim.atoms.n] = column
