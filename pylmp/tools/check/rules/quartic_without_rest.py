"""P108."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look

_POINTS = 4000  # of the bond length at which the force is looked at


class QuarticWithoutRest(Rule):
    """A quartic bond has no equilibrium below Rc.

    Its two atoms push each other apart at every length up to Rc, where the bond ends: it breaks, or holds nothing, at once.
    With K > 0 the quartic has its minimum below Rc where B1 and B2 have opposite signs, or are both negative.

    Okay:
        atom_style bond
        region cell block 0 5 0 5 0 5
        create_box 1 cell bond/types 1
        bond_style quartic
        bond_coeff 1 1200 -0.55 0.25 1.3 34.6878

    Bad:
        atom_style bond
        region cell block 0 5 0 5 0 5
        create_box 1 cell bond/types 1
        bond_style quartic
        bond_coeff 1 1200 0.55 0.25 1.3 34.6878

    Bad:
        atom_style bond
        region cell block 0 5 0 5 0 5
        create_box 1 cell bond/types 1
        bond_style quartic
        bond_coeff 1 1200 -0.55 0.25 0.8 34.6878
    """

    code = "P108"
    name = "quartic-without-rest"
    manual = "bond_quartic.html"

    def after(self, look: Look, words: list[Word]) -> None:
        bond = look.sim.bond
        if words[0].text != "bond_coeff" or bond is None:
            return
        for part in bond.parts:
            if not part.style.name.startswith("quartic") or (
                bond.name == "hybrid" and words[2].text != part.style.name
            ):
                continue
            k, _, _, rc, _ = (float(word.text) for word in words[-5:])
            if not (k > 0.0 and rc > 0.0):
                continue
            kind = next(kind for kind in range(1, bond.types + 1) if part.mine[kind] and part.table[kind, 3] == rc)
            r = rc * np.arange(1, _POINTS) / _POINTS
            force, _ = part.evaluate(np.full(len(r), kind), r * r, 0.0 * r, np.zeros((len(r), 0)))
            if not (force < 0.0).any():
                look.warn(
                    self, words[-2].span, f"This bond pushes at every length up to Rc = {rc:g}", "Rc, B1 and B2 with an equilibrium below Rc"
                )  # fmt: skip
