"""P201."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from pylmp.text.span import Span
from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class VariableUnused(Rule):
    """A variable is defined and its name stands nowhere else.

    Often the name is misspelt where it should be used, and a number stands there that was meant to follow the variable.

    Okay:
        variable size equal 3
        print "${size}"

    Bad:
        variable size equal 3
        print "3"
    """

    code = "P201"
    name = "variable-unused"
    manual = "variable.html"

    def __init__(self) -> None:
        self._defined: dict[str, Span] = {}

    def after(self, look: Look, words: list[Word]) -> None:
        if (
            words[0].text == "variable"
            and len(words) > 2
            and words[2].text not in ("delete", "getenv")
            and words[1].span
        ):
            self._defined.setdefault(words[1].text, words[1].span)

    def end(self, look: Look, whole: bool) -> None:
        if not whole:
            return
        text = "\n".join(line.split("#")[0] for lines in look.sources() for line in lines)
        for name, span in self._defined.items():
            if (
                len(
                    re.findall(
                        rf"(?<![A-Za-z0-9]){re.escape(name)}(?![A-Za-z0-9_])|v_{re.escape(name)}(?![A-Za-z0-9_])", text
                    )
                )
                < 2
            ):
                look.warn(self, span, f"Variable {name} is defined and never used")
