"""Files of atomfile-style variables: sets of per-atom values. Source: LAMMPS manual, variable.html."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NoReturn

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word


def atom_sets(sim: Simulation, path: Word, lines: list[str]) -> Iterator[tuple[Ints, Floats]]:
    """(IDs, values) of one set after the other. Raises ScriptError."""
    rows = [line.split("#")[0].split() for line in lines]
    numbered = [(number, words) for number, words in enumerate(rows, 1) if words]
    at = 0
    while at < len(numbered):
        number, words = numbered[at]
        count = _args(words).integer()
        entries = numbered[at + 1 : at + 1 + count]
        at += 1 + count
        if len(entries) < count or count < 0:
            _wrong(path, f"{count} lines were promised, {len(entries)} follow", number)
        tags, values = np.zeros(count, np.int64), np.zeros(count)
        for k, (number, words) in enumerate(entries):
            if len(words) != 2:
                _wrong(path, "an atom's line holds its ID and a value", number)
            read = _args(words)
            tags[k], values[k] = read.integer(), read.number()
            if tags[k] < 1:
                _wrong(path, f"atom ID {tags[k]}", number)
        yield tags, values


def _args(words: list[str]) -> Args:
    return Args("variable atomfile", [Word(word) for word in words])


def _wrong(path: Word, what: str, number: int) -> NoReturn:
    raise ScriptError("Invalid atom ID in variable file", path.span, hint=f"{path.text}:{number}: {what}")
