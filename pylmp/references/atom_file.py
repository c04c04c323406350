"""Files of atomfile-style variables: sets of per-atom values. Source: LAMMPS manual, variable.html."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NoReturn

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_MAPPED = ("yes", "array", "hash")


def atom_sets(sim: Simulation, name: str, path: Word, lines: list[str]) -> Iterator[tuple[Ints, Floats]]:
    """(IDs, values) of one set after the other; there is at least one. Raises ScriptError."""
    if not sim.has_bonds and sim.map_style not in _MAPPED:
        text = "Cannot use atomfile-style variable unless an atom map exists"
        raise ScriptError(text, path.span, hint="atom_modify map yes", manual="atom_modify.html")
    rows = [(number, words) for number, line in enumerate(lines, 1) if (words := line.split("#")[0].split())]
    at = 0
    while at < len(rows) or at == 0:
        if not rows:
            _fail(path, f"Atomfile variable {name} could not read values from {path.text}", 1, "it holds no set")
        number, words = rows[at]
        if len(words) != 1:
            _fail(path, f"Expected 1 token but found {len(words)} when parsing {' '.join(words)}", number, "the count of a set")
        count = _count(path, words[0], number)
        entries = rows[at + 1 : at + 1 + max(count, 0)]
        if len(entries) != count:
            text = f"Atomfile variable {name} could not read values from {path.text}"
            _fail(path, text, number, f"{count} lines were promised, {len(entries)} follow")
        yield _set(sim, path, entries)
        at += 1 + count


def _count(path: Word, text: str, number: int) -> int:
    try:
        return Args("variable atomfile", [Word(text)]).integer()
    except ScriptError as error:
        _fail(path, error.diagnostic.message, number, "the count of a set")


def _set(sim: Simulation, path: Word, entries: list[tuple[int, list[str]]]) -> tuple[Ints, Floats]:
    tags, values = np.zeros(len(entries), np.int64), np.zeros(len(entries))
    largest = int(sim.atoms.tag[: sim.atoms.n].max(initial=0))
    for k, (number, words) in enumerate(entries):
        wrong = f"Invalid atomfile line '{' '.join(words)}'"
        if len(words) != 2:
            _fail(path, f"{wrong}: expected 2 tokens but found {len(words)}", number, "an atom's ID and its value")
        tags[k] = _read(int, words[0], path, f"{wrong}: Not a valid integer number: '{words[0]}'", number)
        values[k] = _read(float, words[1], path, f"{wrong}: Not a valid floating-point number: '{words[1]}'", number)
        if not 1 <= tags[k] <= largest:
            _fail(path, f"Invalid atom ID {tags[k]} in variable file", number, f"IDs are 1 to {largest}")
    return tags, values


def _read(kind: Callable[[str], Any], text: str, path: Word, wrong: str, number: int) -> Any:
    args = Args("variable atomfile", [Word(text)])
    try:
        return args.integer() if kind is int else args.number()
    except ScriptError:
        _fail(path, wrong, number, "")


def _fail(path: Word, text: str, number: int, why: str) -> NoReturn:
    raise ScriptError(text, path.span, hint=f"{path.text}:{number}" + (f": {why}" if why else ""))
