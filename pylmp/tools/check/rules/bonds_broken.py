"""P109."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.model.scene import Scene
from pylmp.tools.check.lengths import first_lengths
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class BondsBroken(Rule):
    """A bond is already longer than it can be when the first run begins.

    A quartic bond beyond Rc breaks in the set-up, before the first step; a bond of bpm/spring or bpm/spring/plastic that is
    strained beyond eps_c breaks in the first step. The log has no word of it.

    Okay:
        atom_style bond
        special_bonds lj/coul 1 1 1
        region cell block 0 9 0 9 0 9
        create_box 1 cell bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
        create_atoms 1 single 1 1 1
        create_atoms 1 single 2 1 1
        mass 1 1.0
        pair_style lj/cut 1.12
        pair_coeff 1 1 1.0 1.0
        bond_style quartic
        bond_coeff 1 1200 -0.55 0.25 1.3 34.6878
        create_bonds single/bond 1 1 2
        run 0

    Bad:
        atom_style bond
        special_bonds lj/coul 1 1 1
        region cell block 0 9 0 9 0 9
        create_box 1 cell bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
        create_atoms 1 single 1 1 1
        create_atoms 1 single 2.5 1 1
        mass 1 1.0
        pair_style lj/cut 1.12
        pair_coeff 1 1 1.0 1.0
        bond_style quartic
        bond_coeff 1 1200 -0.55 0.25 1.3 34.6878
        create_bonds single/bond 1 1 2
        run 0
    """

    code = "P109"
    name = "bonds-broken"
    manual = "bond_quartic.html"

    def run(self, look: Look, scene: Scene, steps: int) -> None:
        sim = look.sim
        if (found := first_lengths(sim)) is None:
            return
        atoms = sim.atoms
        rows, slots, partners, kinds, r = found
        for part in sim.bond.parts:
            if not part.can_break:
                continue
            for kind in np.flatnonzero(part.mine).tolist():
                mine = kinds == kind
                over, why = self._over(part, kind, r[mine], atoms.bond_history[rows[mine], slots[mine]])
                if over.any():
                    first = np.flatnonzero(over)[0]
                    a, b = (int(atoms.tag[end[mine][first]]) for end in (rows, partners))
                    look.warn(
                        self, None,
                        f"{over.sum()} of {mine.sum()} bonds of type {kind} break at once: that of atoms {a} and {b} is {r[mine][first]:.4g} long, {why}",
                        "positions or coefficients that leave the bonds whole",
                    )  # fmt: skip

    @staticmethod
    def _over(part: Any, kind: int, r: Any, history: Any) -> tuple[Any, str]:
        """Which bonds break, and why."""
        if part.style.name.startswith("quartic"):
            rc = float(part.table[kind, 3])
            return r > rc, f"Rc is {rc:g}"
        if not (part.style.reference and part.stored):
            return np.zeros(len(r), bool), ""
        eps_c, r0 = float(part.table[kind, 1]), history[:, 0]
        broken = (r0 > 0.0) & (np.abs(r - r0) > eps_c * r0)
        return broken, f"eps_c is {eps_c:g}, r0 {r0[broken][0]:.4g}" if broken.any() else ""
