"""P101."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class SpecialBondsReset(Rule):
    """A second special_bonds sets weights back that an earlier one gave.

    Each special_bonds begins from the default, 0 0 0, for what it does not name. Bonded neighbors then no longer feel the pair
    style, and bonds are shorter or longer than meant, without a word in the log.

    Okay:
        special_bonds lj 0 1 1 coul 1 1 1
        special_bonds lj 1 1 1 coul 1 1 1

    Bad:
        special_bonds lj 0 1 1
        special_bonds coul 1 1 1
    """

    code = "P101"
    name = "special-bonds-reset"
    manual = "special_bonds.html"

    def __init__(self) -> None:
        self._given: dict[str, tuple[float, ...]] = {}

    def after(self, look: Look, words: list[Word]) -> None:
        if words[0].text == "clear":
            self._given = {}
        if words[0].text != "special_bonds":
            return
        special = look.sim.special
        now = {"lj": tuple(map(float, special.lj)), "coul": tuple(map(float, special.coul))}
        texts = {word.text for word in words}
        named = {kind for kind in now if texts & {kind, "lj/coul", "amber", "charmm", "dreiding"}}
        for kind, weights in self._given.items():
            if kind not in named and now[kind] != weights:
                told = " ".join(f"{weight:g}" for weight in weights)
                look.warn(
                    self, words[0].span, f"This sets the {kind} weights back, which were {told}", f"add {kind} {told}"
                )
        self._given = {kind: now[kind] for kind in named}
