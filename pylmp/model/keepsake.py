"""Computes that compare atoms with what they were when the compute was defined."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Atoms, Floats
from pylmp.model.compute import Compute

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args


class Keepsake(Compute):
    """kept(sim): (n, 3) what each owned atom was; it rides along with the atoms. New atoms are compared with what they are made as.

    array   which per-atom array, x or v
    """

    array = "x"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.key = f"compute {identity}"

    def keep(self, sim: Simulation, values: Floats) -> None:
        """Remember values (n, 3)."""
        atoms = sim.atoms
        store = np.zeros((atoms.capacity, 3))
        store[: atoms.n] = values
        atoms.extra[self.key] = store
        atoms.newcomers[self.key] = self._newcomer

    def kept(self, sim: Simulation) -> Floats:
        return np.asarray(sim.atoms.extra[self.key][: sim.atoms.n], float)

    def atom_state(self, sim: Simulation) -> Floats | None:
        return self.kept(sim) if self.key in sim.atoms.extra else None

    def restore_atoms(self, sim: Simulation, values: Floats) -> None:
        sim.atoms.extra[self.key][: sim.atoms.n] = values

    def removed(self, sim: Simulation) -> None:
        sim.atoms.extra.pop(self.key, None)
        sim.atoms.newcomers.pop(self.key, None)

    def _newcomer(self, atoms: Atoms, rows: slice) -> Floats:
        values: Floats = getattr(atoms, self.array)[rows]
        return values
