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
        announce(sim, (*requests, Request(f"pair {sim.pair.style.name}")))


def wrap_atoms(sim: Simulation) -> float:
    """Atoms back into the box, shrink-wrapped faces to the atoms; atoms farther out are lost.

    Returns the ghost cutoff, with LAMMPS's warnings about it.
    """
    atoms = sim.atoms
    cutoff = ghost_cutoff(sim, warn=True)
    atoms.clear_ghosts()
    sim.box.wrap(atoms.x[: atoms.n], atoms.image[: atoms.n])
    sim.box.shrink(atoms.x[: atoms.n])
    x = atoms.x[: atoms.n]
    if ((x < sim.box.lo) | (x >= sim.box.hi)).any():
        for listed in sim.bond_lists:
            listed.copy_back(sim)
        sim.bond_lists = []  # they hold rows that become others'
        remove_lost(sim)
    return cutoff


def renew_ghosts(sim: Simulation, cutoff: float) -> None:
    """Ghosts of the wrapped atoms. Their IDs stay in the rows beyond the owned atoms, where the bond lists of the last run look
    when the next run takes over what they remember: like LAMMPS, it finds the bonds whose ends still are in the same rows.
    """
    ghosts = Ghosts(sim)
    prepare(ghosts.functions(), sim.console.screen)
    ghosts.build(sim, cutoff)
    sim.atoms.clear_ghosts()
