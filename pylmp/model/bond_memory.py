"""What bonds remember, under the names by which LAMMPS keeps it in restart files.

LAMMPS keeps it with the atoms, in the order of the bond slots, and a flag that says whether r0 of every bond is known.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model import bond_volumes

if TYPE_CHECKING:
    from pylmp.model.atoms import Floats
    from pylmp.model.bond import BondPart
    from pylmp.model.simulation import Simulation

FLAG, PER_ATOM, BREAKS = "BOND_HISTORY", "property/atom", "UPDATE_SPECIAL_BONDS"
BREAKS_ID = "BPM_UPDATE_SPECIAL_BONDS"
PLACES_ID = "BPM_property_atom"  # where atoms were when store/local asked for x/ref, y/ref, z/ref
VOLUMES_ID = "BOND_BPM_SPRING_FIX_PROPERTY_ATOM"
KNOWN = struct.pack("<d", 1.0)  # r0 of every bond is known
PLACES = "bpm reference"  # the same in Atoms.extra


def flag_id(style: str) -> str:
    return "HISTORY_" + style.upper().replace("/", "_")


def per_atom_id(style: str) -> str:
    return f"{flag_id(style)}_FIX_PROP_ATOM"


def flag(part: BondPart) -> bytes:
    return struct.pack("<d", float(part.stored))


def values(sim: Simulation, part: BondPart) -> Floats:
    """(n, slots * memory): slot by slot."""
    atoms = sim.atoms
    n, slots = atoms.n, atoms.bond_per_atom
    return np.asarray(atoms.bond_history[:n, :, : part.memory].reshape(n, slots * part.memory))


def take(sim: Simulation, part: BondPart) -> None:
    """Take over what a restart file holds for bonds of this style."""
    if sim.waiting is None or not part.memory:
        return
    atoms = sim.atoms
    width = atoms.bond_per_atom * part.memory
    found = sim.waiting.take_atoms(sim, per_atom_id(part.style.name), PER_ATOM, width)
    if found is not None:
        mine = found.reshape(atoms.n, atoms.bond_per_atom, part.memory)
        atoms.bond_history[: atoms.n, :, : part.memory] = np.where(
            mine != 0.0, mine, atoms.bond_history[: atoms.n, :, : part.memory]
        )
    state = sim.waiting.take(sim, flag_id(part.style.name), FLAG)
    if state is not None and len(state) == 8:
        part.stored = struct.unpack("<d", state)[0] != 0.0


def take_breaks(sim: Simulation, part: BondPart) -> None:
    """The fix that turns broken pairs into ordinary neighbors keeps nothing, but LAMMPS says that it is there again."""
    if sim.waiting is not None and part.updates_special:
        sim.waiting.take(sim, BREAKS_ID, BREAKS)


def take_volumes(sim: Simulation) -> None:
    """The same of the volumes of atoms."""
    found = sim.waiting.take_atoms(sim, VOLUMES_ID, PER_ATOM, 2) if sim.waiting is not None else None
    if found is not None:
        bond_volumes.restore(sim, found)
    bond_volumes.start(sim)


def longest_reference(sim: Simulation) -> float:
    """The largest r0 that bonds remember."""
    atoms = sim.atoms
    used = np.arange(atoms.bond_per_atom) < atoms.num_bond[: atoms.n, None]
    return float(atoms.bond_history[: atoms.n, :, 0][used].max(initial=0.0))
