"""P202."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from pylmp.text.span import Span
from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look

_NAMES = {"group", "compute", "region", "fix"}
_PARTS = re.compile(r"[A-Za-z0-9_]+")
_SILENT = {"vector", "ave/atom", "store/state"}  # fixes that only keep values for others to read
_FILED = {"ave/time", "ave/chunk", "ave/histo", "ave/histo/weight", "ave/correlate"}  # unless they write a file


class IdUnused(Rule):
    """A group, compute or region, or a fix that only keeps values, is defined and its ID stands nowhere else.

    Often the ID is misspelt, or another one stands, where this one was meant.

    Okay:
        region cell block 0 1 0 1 0 1
        create_box 1 cell
        group mobile type 1
        fix move mobile nve

    Bad:
        region cell block 0 1 0 1 0 1
        create_box 1 cell
        group mobile type 1
        fix move all nve

    Bad:
        region cell block 0 1 0 1 0 1
        create_box 1 cell
        compute hot all temp
        thermo_style custom step temp
    """

    code = "P202"
    name = "id-unused"
    manual = "group.html"

    def __init__(self) -> None:
        self._defined: dict[tuple[str, str], Span] = {}
        self._mentioned: set[str] = set()
        self._handed_on = False  # a restart file takes groups along

    def before(self, look: Look, words: list[Word]) -> None:
        name = words[0].text
        self._handed_on |= name in ("restart", "write_restart")
        new = name in _NAMES and len(words) > 2 and (name, words[1].text) not in self._defined
        for word in words[1 + new :]:
            for part in _PARTS.findall(word.text):
                self._mentioned |= {part, re.sub(r"^[cCfF]_", "", part)}

    def after(self, look: Look, words: list[Word]) -> None:
        name = words[0].text
        if name not in _NAMES or len(words) < 3 or words[1].span is None or words[1].text == "all":
            return
        if name == "fix":
            style = words[3].text
            if style not in _SILENT and (style not in _FILED or any(word.text == "file" for word in words)):
                return
        self._defined.setdefault((name, words[1].text), words[1].span)

    def end(self, look: Look, whole: bool) -> None:
        if not whole:
            return
        text = "\n".join(line.split("#")[0] for lines in look.sources() for line in lines)
        for (what, name), span in self._defined.items():
            written = re.findall(rf"(?<![A-Za-z0-9_]){re.escape(name)}(?![A-Za-z0-9_])|[cCfF]_{re.escape(name)}(?![A-Za-z0-9_])", text)  # fmt: skip
            if len(written) < 2 and name not in self._mentioned and not (what == "group" and self._handed_on):
                look.warn(self, span, f"{what.capitalize()} {name} is defined and never used")
