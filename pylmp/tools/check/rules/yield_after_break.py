"""P104."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class YieldAfterBreak(Rule):
    """A plastic bond breaks before it can yield.

    bpm/spring/plastic yields at the strain eps_p and breaks at eps_c: with eps_p at or above eps_c it is bpm/spring.

    Okay:
        atom_style bond
        newton on off
        comm_modify vel yes
        special_bonds lj 0 1 1 coul 1 1 1
        region cell block 0 1 0 1 0 1
        create_box 1 cell bond/types 1
        bond_style bpm/spring/plastic
        bond_coeff 1 10.0 0.3 0.1 0.02

    Bad:
        atom_style bond
        newton on off
        comm_modify vel yes
        special_bonds lj 0 1 1 coul 1 1 1
        region cell block 0 1 0 1 0 1
        create_box 1 cell bond/types 1
        bond_style bpm/spring/plastic
        bond_coeff 1 10.0 0.3 0.1 0.4
    """

    code = "P104"
    name = "yield-after-break"
    manual = "bond_bpm_spring_plastic.html"

    def after(self, look: Look, words: list[Word]) -> None:
        bond = look.sim.bond
        if words[0].text != "bond_coeff" or bond is None or len(words) < 6:
            return
        style = words[2].text if bond.name == "hybrid" else bond.name
        if style.removesuffix("/omp") != "bpm/spring/plastic":
            return
        limit, word = float(words[-3].text), words[-1]
        if float(word.text) >= limit:
            look.warn(
                self,
                word.span,
                f"The bond breaks at strain {limit:g}, before it yields at {word.text}",
                f"eps_p below {limit:g}",
            )
