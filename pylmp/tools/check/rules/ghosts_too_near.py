"""P110."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.scene import Scene
from pylmp.tools.check.lengths import first_lengths
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class GhostsTooNear(Rule):
    """Bonds may stretch farther than ghost atoms reach.

    A bond of bpm/spring or bpm/spring/plastic holds until it is (1 + eps_c) r0 long. Where it crosses a periodic boundary, or
    a border between processes, its other atom must be a ghost until then, or the run ends with missing bond atoms.

    Okay:
        atom_style bond
        newton on off
        comm_modify vel yes cutoff 1.7
        special_bonds lj 0 1 1 coul 1 1 1
        region cell block 0 9 0 9 0 9
        create_box 1 cell bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
        create_atoms 1 single 1 1 1
        create_atoms 1 single 2 1 1
        mass 1 1.0
        create_bonds single/bond 1 1 2
        bond_style bpm/spring
        bond_coeff 1 1.0 0.6 0.1
        run 0

    Bad:
        atom_style bond
        newton on off
        comm_modify vel yes cutoff 1.2
        special_bonds lj 0 1 1 coul 1 1 1
        region cell block 0 9 0 9 0 9
        create_box 1 cell bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
        create_atoms 1 single 1 1 1
        create_atoms 1 single 2 1 1
        mass 1 1.0
        create_bonds single/bond 1 1 2
        bond_style bpm/spring
        bond_coeff 1 1.0 0.6 0.1
        run 0
    """

    code = "P110"
    name = "ghosts-too-near"
    manual = "comm_modify.html"

    def run(self, look: Look, scene: Scene, steps: int) -> None:
        sim = look.sim
        if not any(scene.periodic) or (found := first_lengths(sim)) is None:
            return
        atoms = sim.atoms
        rows, slots, _, kinds, r = found
        reach = ghost_cutoff(sim)
        for part in sim.bond.parts:
            if not (part.style.reference and part.can_break):
                continue
            r0 = atoms.bond_history[rows, slots, 0] if part.stored else r  # r0 is the length in the first set-up
            for kind in np.flatnonzero(part.mine).tolist():
                eps_c = float(part.table[kind, 1])
                longest = (1.0 + eps_c) * float(r0[kinds == kind].max(initial=0.0))
                if longest > reach:
                    look.warn(
                        self, None,
                        f"Bonds of type {kind} hold up to a length of {longest:.4g} = (1 + eps_c) r0, ghosts reach {reach:.4g}",
                        f"comm_modify cutoff {longest:.3g} or more",
                    )  # fmt: skip
