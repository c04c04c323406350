"""What LAMMPS does before a command that needs a complete system: check everything, wrap the atoms."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pylmp.io.neighbor_info import Request, announce
from pylmp.kernels.exact import INDEX_MASK
from pylmp.kernels.exact.neighbor import FULL
from pylmp.kernels.store import prepare
from pylmp.model.atoms import Floats, Ints
from pylmp.model.ghosts import Ghosts, ghost_cutoff
from pylmp.model.lost import remove_lost
from pylmp.model.neighbor import NeighborList
from pylmp.model.simulation import Simulation

_ROWS = 2**14  # of a list that are looked at together: a bound on memory


def initialise(sim: Simulation, *requests: Request) -> None:
    """System init before runs and before commands that need a complete system: every part checks itself; the log describes the
    neighbor lists, those of requests first; output checks itself and opens its files.
    """
    sim.init()
    announce(sim, *requests)
    sim.output.init(sim)


def full_list(sim: Simulation) -> Iterator[tuple[Ints, Ints, Floats]]:
    """Rows of each owned atom and of its neighbors, and their squared distances, in the order of LAMMPS's full neighbor list, in
    stretches of rows.

    Atoms are wrapped, ghosts are there from the first stretch on.
    """
    atoms = sim.atoms
    ghosts, neighbors = Ghosts(sim), NeighborList(sim, FULL)
    prepare([*sim.box.functions(), *ghosts.functions(), *neighbors.functions()], sim.console.screen)
    cutoff = wrap_atoms(sim, ghosts)
    neighbors.build(sim, cutoff)
    for begin in range(0, atoms.n, _ROWS):
        first = neighbors.first[begin : begin + _ROWS + 1]
        rows = np.repeat(np.arange(begin, begin + len(first) - 1), np.diff(first))
        others = (neighbors.neighbors[first[0] : first[-1]] & INDEX_MASK).astype(np.int64)
        d = atoms.x[rows] - atoms.x[others]
        d *= d
        yield rows, others, d[:, 0] + d[:, 1] + d[:, 2]


def wrap_atoms(sim: Simulation, ghosts: Ghosts | None = None) -> float:
    """Atoms back into the box, shrink-wrapped faces to the atoms; atoms farther out are lost. Then ghosts are made, if given.

    Returns the ghost cutoff, with LAMMPS's warnings about it.
    """
    atoms, box = sim.atoms, sim.box
    prepare(box.functions() + (ghosts.functions() if ghosts is not None else []), sim.console.screen)
    cutoff = ghost_cutoff(sim, warn=True)
    atoms.clear_ghosts()
    box.enter(atoms.x[: atoms.n])
    box.wrap(atoms)
    box.shrink(atoms, sim.natoms)
    if box.lost(atoms):
        for listed in sim.bond_lists:
            listed.copy_back(sim)
        sim.bond_lists = []  # they hold rows that become others'
        remove_lost(sim)
    if ghosts is not None:
        ghosts.build(sim, cutoff)
    box.leave(atoms.x[: atoms.total])
    return cutoff
