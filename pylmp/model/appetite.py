"""How much memory a run will take, from what the script has said: asked before lists are built, told by explain."""

from __future__ import annotations

import gc
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.heap import trim
from pylmp.kernels.store import release
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.limits import room

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

# Bytes of an atom, of a ghost, of an entry of a half list, and of the program itself: measured with 4000 to 256000 atoms, the larger
# of both engines' (335, 300, 10 the exact one; 480, 0, 15 the fast one).
_OWN, _GHOST, _ENTRY, _PROGRAM = 480, 300, 15, 42_000_000
_ARRAYS = 150  # of _OWN: what atoms without bonds have

_LARGE = 50_000  # atoms whose arrays are worth a few milliseconds


@dataclass(frozen=True)
class Appetite:
    """Counts, of atoms spread evenly over the part of the box where there are any. ghosts: images beyond its faces; neighbors: entries of
    a half list; more: bytes of bonds and the like."""

    atoms: int
    ghosts: float
    neighbors: float
    more: float

    @property
    def bytes(self) -> float:
        return _PROGRAM + self.atoms * _OWN + self.more + self.ghosts * _GHOST + self.neighbors * _ENTRY


def appetite(sim: Simulation) -> Appetite:
    """Of the next run."""
    box, n = sim.box, sim.atoms.n
    reach, cut = ghost_cutoff(sim), sim.neighbor_cutoff
    flat = sim.dimension == 2
    grown = math.prod(
        1.0 + 2.0 * reach / length if periodic and length > 0.0 else 1.0
        for periodic, length in list(zip(box.periodic, box.length.tolist(), strict=True))[: sim.dimension]
    )
    ball = math.pi * cut * cut * (1.0 if flat else 4.0 / 3.0 * cut)
    filled = _filled(sim, cut)
    near = 0.5 * n * ball / filled if filled > 0.0 else 0.0
    near = min(near, 0.5 * n * grown)  # there are no more atoms, images included
    arrays = sum(array.nbytes for array in vars(sim.atoms).values() if isinstance(array, np.ndarray))
    return Appetite(n, n * (grown - 1.0), n * near, max(0.0, float(arrays - _ARRAYS * n)))


def _filled(sim: Simulation, cut: float) -> float:
    """Volume (area) of the part of the box where there are atoms, no thinner than the cutoff: of a sheet a ball holds a disk."""
    box, n, d = sim.box, sim.atoms.n, sim.dimension
    if n < 2:
        return box.volume
    x = sim.atoms.x[:n, :d]
    extent = np.minimum(np.maximum((x.max(axis=0) - x.min(axis=0)) * (1.0 + n ** (-1.0 / d)), cut), box.length[:d])
    return min(box.volume, float(np.prod(extent)))


def make_room(sim: Simulation) -> None:
    """Let go of what the last run held: its parts hold each other, and with few objects the collector would not come by for long."""
    if sim.atoms.n > _LARGE:
        release()
        gc.collect()
        trim()


def check_appetite(sim: Simulation) -> None:
    """Raises ScriptError if a run's lists would not find room."""
    wanted = appetite(sim)
    what = f"the lists of {wanted.atoms} atoms with about {wanted.ghosts:.3g} ghosts and {wanted.neighbors:.3g} pairs"
    room(wanted.ghosts * _GHOST + wanted.neighbors * _ENTRY, what, None, "neighbor.html")
