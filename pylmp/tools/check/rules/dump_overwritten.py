"""P103."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look


class DumpOverwritten(Rule):
    """Two dumps write to one file.

    Both open it and write over each other: frames are lost, and what is left may be half of one and half of the other.

    Okay:
        region cell block 0 1 0 1 0 1
        create_box 1 cell
        dump 1 all atom 10 one.dump
        dump 2 all atom 10 two.dump

    Bad:
        region cell block 0 1 0 1 0 1
        create_box 1 cell
        dump 1 all atom 10 one.dump
        dump 2 all atom 10 one.dump
    """

    code = "P103"
    name = "dump-overwritten"
    manual = "dump.html"

    def __init__(self) -> None:
        self._files: dict[str, str] = {}

    def after(self, look: Look, words: list[Word]) -> None:
        texts = [word.text for word in words]
        self._files = {dump: file for dump, file in self._files.items() if dump in look.sim.output.dumps}
        if texts[0] != "dump" or len(texts) < 6:
            return
        other = next((dump for dump, file in self._files.items() if file == texts[5]), None)
        if other is not None:
            look.warn(self, words[5].span, f"Dump {other} already writes to {texts[5]}", "a name of its own")
        self._files[texts[1]] = texts[5]
