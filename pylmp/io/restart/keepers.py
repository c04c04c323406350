"""What fixes, computes and bond styles keep in restart files, in LAMMPS's order: that of their definition."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pylmp.model import bond_memory, bond_volumes
from pylmp.model.atoms import Floats
from pylmp.model.bond import BondPart
from pylmp.model.simulation import Simulation


@dataclass
class Keeper:
    """state: global, None: nothing; values (n, k): with each atom, None: nothing."""

    born: int
    identity: str
    style: str
    state: bytes | None = None
    values: Floats | None = None


def keepers(sim: Simulation) -> list[Keeper]:
    """All that keep something."""
    found = [Keeper(fix.born, fix.id, fix.style, fix.state(sim), fix.atom_state(sim)) for fix in sim.fixes]
    for compute in sim.computes.values():
        found.append(Keeper(compute.born, compute.store, "STORE/GLOBAL", compute.state(sim)))
        found.append(Keeper(compute.born, compute.store, "STORE/ATOM", None, compute.atom_state(sim)))
    found += _of_bonds(sim)
    found = [keeper for keeper in found if keeper.state is not None or keeper.values is not None]
    return sorted(found, key=lambda keeper: keeper.born)


def _of_bonds(sim: Simulation) -> list[Keeper]:
    found = []
    parts: list[BondPart] = sim.bond.parts if sim.bond else []
    breaks = next((part for part in parts if part.updates_special), None)
    for part in parts:
        if part is breaks:
            found.append(Keeper(part.born, bond_memory.BREAKS_ID, bond_memory.BREAKS, b""))
        if part.memory:
            found.append(Keeper(part.born, bond_memory.flag_id(part.style.name), bond_memory.FLAG, bond_memory.flag(part)))
            if part.recorder is not None and bond_memory.PLACES in sim.atoms.extra:
                places = np.asarray(sim.atoms.extra[bond_memory.PLACES][: sim.atoms.n], np.float64)
                found.append(Keeper(part.born, bond_memory.PLACES_ID, bond_memory.PER_ATOM, None, places))
            values = bond_memory.values(sim, part)
            name = bond_memory.per_atom_id(part.style.name)
            found.append(Keeper(part.memory_born, name, bond_memory.PER_ATOM, None, values))
        if part.style.volumes(part.options):
            found.append(Keeper(part.memory_born, bond_memory.VOLUMES_ID, bond_memory.PER_ATOM, None, bond_volumes.kept(sim)))
    return found
