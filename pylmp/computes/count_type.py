"""compute ID GROUP count/type atom|bond|angle|dihedral|improper: how many of each type; for bonds the scalar counts broken ones.

Source: LAMMPS manual, compute_count_type.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.computes.property_local import counted
from pylmp.model.atoms import Floats, Ints
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.topology import ANGLE, BOND, KIND
from pylmp.text.words import Args


@COMPUTES.register("count/type")
class CountType(Compute):
    style = "count/type"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        hint = " ".join(("atom", *KIND))
        if len(args) != 1:
            args.fail("Incorrect number of args for compute count/type command", args.owner, hint=hint)
        mode = args.word()
        if mode.text != "atom" and mode.text not in KIND:
            args.fail(f"Invalid compute count/type keyword {mode.text}", mode, hint=hint)
        self.kind = KIND.get(mode.text)
        if self.kind is not None and self.kind.types(sim) == 0:
            said = "bond" if self.kind is ANGLE else self.kind.name  # LAMMPS's own wording
            args.fail(f"Compute count/type {said} command with no {self.kind.plural} defined", mode)
        if self.kind is not BOND:
            self.scalar = None  # type: ignore[method-assign,assignment]
        self.length = self.kind.types(sim) if self.kind else sim.atom_types

    def _types(self, sim: Simulation) -> Ints:
        """Types of the atoms of the group, or of the bonds, angles, ... whose atoms all are in it, each once."""
        if self.kind is None:
            return np.asarray(sim.atoms.type[: sim.atoms.n][self.members(sim)])
        return counted(sim, self.kind, self.members(sim), None).types

    def scalar(self, sim: Simulation) -> float:
        """Broken bonds (type 0)."""
        return float((self._types(sim) == 0).sum())

    def vector(self, sim: Simulation) -> Floats:
        return np.bincount(np.abs(self._types(sim)), minlength=self.length + 1)[1:].astype(float)
