"""What of a script's lines to come only LAMMPS can carry out, found before the first step is made.

The lines are looked at, not carried out: a name that comes from a variable, or a line in a branch, is not found. Behind a line
that jumps or ends the script, a finding is doubtful: the script may never get there.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import NamedTuple

from pylmp.model.unknown import STYLED, is_elsewhere, lacking
from pylmp.text.grammar import rules
from pylmp.text.lines import Text
from pylmp.text.span import Span

_WORD = re.compile(r"\S+")
_LEAVES = re.compile(r"\b(jump|quit)\b")
_HYBRID = re.compile(r"hybrid")
_DEEPEST = 16


class Missing(NamedTuple):
    """what: as lacking() says. doubtful: the script may never get there."""

    what: str
    span: Span
    doubtful: bool


Read = Callable[[Path], list[Text] | None]


def survey(lines: Iterable[Text], read: Read) -> list[Missing]:
    """Everything in lines, and in files they include, that LAMMPS has and pylmp lacks; read gives a file's lines, None: it cannot."""
    return _Survey(read).look(lines, 0).found


class _Survey:
    def __init__(self, read: Read) -> None:
        self.found: list[Missing] = []
        self._read = read
        self._doubtful = False

    def look(self, lines: Iterable[Text], depth: int) -> _Survey:
        for line in lines:
            text = line.text.split("#")[0]
            words = list(_WORD.finditer(text))
            if words:
                self._line(line, [word[0] for word in words], words, depth)
            if _LEAVES.search(text):
                self._doubtful = True
        return self

    def _line(self, line: Text, texts: list[str], words: list[re.Match[str]], depth: int) -> None:
        name = texts[0]
        if name == "include" and len(texts) == 2 and "$" not in texts[1] and depth < _DEEPEST:
            included = self._read(Path(texts[1]))
            if included is not None:
                self.look(included, depth + 1)
        elif name not in rules() and is_elsewhere("command", name):
            self._note(line, "command", words[0])
        elif name in STYLED:
            kind, at = STYLED[name]
            last = len(words) if len(words) > at and _HYBRID.match(texts[at]) else at + 1
            for word in words[at:last]:
                if is_elsewhere(kind, word[0]):
                    self._note(line, kind, word)

    def _note(self, line: Text, kind: str, word: re.Match[str]) -> None:
        self.found.append(Missing(lacking(kind, word[0]), line.span(word.start(), word.end()), self._doubtful))
