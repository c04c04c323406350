"""Reads tests/corpus/bad*.cases: wrong scripts with the sentence and the place of their error."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

CORPUS = Path(__file__).parent / "corpus"


@dataclass(frozen=True)
class Case:
    """script: the whole text, marks removed. line, column, length: where the error must point."""

    sentence: str
    script: str
    line: int
    column: int
    length: int


def cases() -> list[Case]:
    """All cases of all files; a file's preludes are its own."""
    return [case for path in sorted(CORPUS.glob("bad*.cases")) for case in _cases(path)]


def _cases(path: Path) -> list[Case]:
    preludes: dict[str, list[str]] = {}
    found: list[tuple[str, list[str]]] = []
    into: list[str] | None = None
    for line in path.read_text().splitlines():
        if header := re.match(r"-- (\w+)(?: = (\w+) \+)?$", line):
            into = preludes[header[1]] = list(preludes[header[2]]) if header[2] else []
        elif header := re.match(r"== (\w+): (.*)", line):
            into = list(preludes[header[1]])
            found.append((header[2], into))
        elif line and into is not None:
            into.append(line)
    return [_case(sentence, lines) for sentence, lines in found]


def _case(sentence: str, lines: list[str]) -> Case:
    (number,) = (k for k, text in enumerate(lines) if "«" in text)
    start, stop = lines[number].index("«"), lines[number].index("»")
    script = "\n".join(lines).replace("«", "").replace("»", "") + "\n"
    return Case(sentence, script, number + 1, start + 1, stop - start - 1)
