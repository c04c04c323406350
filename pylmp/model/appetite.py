"""How much memory a run will take, from what the script has said: asked before lists are built, told by explain."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.limits import room

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_OWN, _GHOST, _ENTRY = 300, 100, 8  # bytes of an atom, of a ghost, of an entry of a neighbor list: measured


@dataclass(frozen=True)
class Appetite:
    """Counts, of atoms spread evenly over the box. ghosts: images beyond its faces; neighbors: entries of a half list."""

    atoms: int
    ghosts: float
    neighbors: float

    @property
    def bytes(self) -> float:
        return self.atoms * _OWN + self.ghosts * _GHOST + self.neighbors * _ENTRY


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
    near = 0.5 * n * ball / box.volume if box.volume > 0.0 else 0.0
    if not all(box.periodic[: sim.dimension]):
        near = min(near, 0.5 * n)
    return Appetite(n, n * (grown - 1.0), n * near)


def check_appetite(sim: Simulation) -> None:
    """Raises ScriptError if a run's lists would not find room."""
    wanted = appetite(sim)
    what = f"the lists of {wanted.atoms} atoms with about {wanted.ghosts:.3g} ghosts and {wanted.neighbors:.3g} pairs"
    room(wanted.ghosts * _GHOST + wanted.neighbors * _ENTRY, what, None, "neighbor.html")
