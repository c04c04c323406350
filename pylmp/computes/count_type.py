"""compute ID GROUP count/type atom|bond: how many atoms or bonds of each type; for bonds the scalar counts broken ones.

Source: LAMMPS manual, compute_count_type.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.bond import bond_pairs
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


@COMPUTES.register("count/type")
class CountType(Compute):
    style = "count/type"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) != 1:
            args.fail("Incorrect number of args for compute count/type command", args.owner, hint="atom or bond")
        mode = args.word()
        if mode.text in ("angle", "dihedral", "improper"):
            raise Unsupported(f"LAMMPS has compute count/type {mode.text}, pylmp's native engines do not", mode.span)
        if mode.text not in ("atom", "bond"):
            args.fail(f"Invalid compute count/type keyword {mode.text}", mode, hint="atom or bond")
        if mode.text == "bond" and not sim.has_bonds:
            args.fail("Compute count/type bond command with no bonds defined", mode)
        self.mode = mode.text
        if self.mode == "atom":
            self.scalar = None  # type: ignore[method-assign,assignment]
        self.length = sim.atom_types if self.mode == "atom" else sim.bond_types

    def _bonds(self, sim: Simulation):  # type: ignore[no-untyped-def]
        """Types of the bonds with both atoms in the group, each bond once."""
        rows, slots, partners = bond_pairs(sim, lambda kinds: np.ones(kinds.shape, bool))
        atoms = sim.atoms
        inside = self.members(sim)
        keep = (partners >= 0) & inside[rows] & inside[partners]
        if not sim.newton_bond:
            keep &= atoms.tag[rows] < atoms.bond_atom[rows, slots]
        return atoms.bond_type[rows[keep], slots[keep]]

    def scalar(self, sim: Simulation) -> float:
        """Broken bonds (type 0)."""
        return float((self._bonds(sim) == 0).sum())

    def vector(self, sim: Simulation) -> Floats:
        atoms = sim.atoms
        kinds = atoms.type[: atoms.n][self.members(sim)] if self.mode == "atom" else np.abs(self._bonds(sim))
        return np.bincount(kinds, minlength=self.length + 1)[1:].astype(float)
