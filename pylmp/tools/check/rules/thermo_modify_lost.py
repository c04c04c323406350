"""P102."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class ThermoModifyLost(Rule):
    """A thermo_style takes back what thermo_modify said before it.

    thermo_style begins anew: formats, norm, lost and the other settings of thermo_modify are the default again.

    Okay:
        region cell block 0 1 0 1 0 1
        create_box 1 cell
        thermo_style one
        thermo_modify norm no

    Bad:
        region cell block 0 1 0 1 0 1
        create_box 1 cell
        thermo_modify norm no
        thermo_style one
    """

    code = "P102"
    name = "thermo-modify-lost"
    manual = "thermo_style.html"

    def __init__(self) -> None:
        self._modified = False

    def after(self, look: Look, words: list[Word]) -> None:
        name = words[0].text
        if name == "thermo_style" and self._modified:
            look.warn(
                self,
                words[0].span,
                "thermo_style takes back the thermo_modify before it",
                "thermo_style first, then thermo_modify",
            )
        if name in ("thermo_style", "thermo_modify", "clear", "run", "minimize"):
            self._modified = name == "thermo_modify"
