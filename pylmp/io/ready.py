"""What LAMMPS does before a command that needs a complete system: check everything, wrap the atoms."""

from __future__ import annotations

from pylmp.io.neighbor_info import Request, announce
from pylmp.kernels.store import prepare
from pylmp.model.ghosts import Ghosts, ghost_cutoff
from pylmp.model.lost import remove_lost
from pylmp.model.simulation import Simulation


def initialise(sim: Simulation, *requests: Request) -> None:
    """System init: every part checks itself; the log describes the neighbor lists, those of requests first."""
    sim.init()
    if sim.pair is not None:
        announce(sim, (*requests, Request(f"pair {sim.pair.name}")))


def wrap_atoms(sim: Simulation, ghosts: Ghosts | None = None) -> float:
    """Atoms back into the box, shrink-wrapped faces to the atoms; atoms farther out are lost. Then ghosts are made, if given.

    Returns the ghost cutoff, with LAMMPS's warnings about it.
    """
    atoms, box = sim.atoms, sim.box
    if ghosts is not None:
        prepare(ghosts.functions(), sim.console.screen)
    cutoff = ghost_cutoff(sim, warn=True)
    atoms.clear_ghosts()
    box.enter(atoms.x[: atoms.n])
    box.wrap(atoms)
    box.shrink(atoms)
    x, (lo, hi) = atoms.x[: atoms.n], box.frame
    if ((x < lo) | (x >= hi)).any():
        for listed in sim.bond_lists:
            listed.copy_back(sim)
        sim.bond_lists = []  # they hold rows that become others'
        remove_lost(sim)
    if ghosts is not None:
        ghosts.build(sim, cutoff)
    box.leave(atoms.x[: atoms.total])
    return cutoff
