"""References to computes, fixes and variables in output commands: ``c_ID``, ``f_ID[2]``, ``v_name``, ``c_ID[*]``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_REFERENCE = re.compile(r"([cfv])_(\w+)((?:\[[\d*]+\]){0,2})")
KINDS = {"c": "compute", "f": "fix", "v": "variable"}


@dataclass(frozen=True)
class Reference:
    """kind: c, f or v. index: the numbers in brackets, () if there are none; ``*`` in text only."""

    kind: str
    name: str
    brackets: tuple[str, ...]

    @property
    def index(self) -> tuple[int, ...]:
        return tuple(int(text) for text in self.brackets)

    @property
    def what(self) -> str:
        """compute, fix or variable."""
        return KINDS[self.kind]

    def source(self, sim: Simulation) -> Any:
        """The compute or fix meant, or None."""
        if self.kind == "c":
            return sim.computes.get(self.name)
        return next((fix for fix in sim.fixes if fix.id == self.name), None)


def parse(text: str) -> Reference | None:
    """The reference text is, or None: a keyword, or malformed."""
    found = _REFERENCE.fullmatch(text)
    return Reference(found[1], found[2], tuple(re.findall(r"\[([\d*]+)\]", found[3]))) if found else None


def offers(source: Any, values: str) -> bool:
    """Does a compute or fix have values: scalar, vector, per_atom, local."""
    return callable(getattr(source, values, None))


def length(sim: Simulation, source: Any, values: str) -> int:
    """How many components the vector of a compute or fix has, or columns its array, per_atom or local table (0: a plain vector)."""
    if values == "vector":
        return int(source.length)
    columns = int(getattr(source, "columns", 0))
    if values == "array":
        return columns
    return 0 if columns == 1 else columns


def expand(sim: Simulation, args: Args, words: Sequence[Word], values: str) -> list[Word]:
    """Words with ``[*]`` (also ``[2*]``, ``[*3]``, ``[2*4]``) replaced by one word for each component."""
    result = []
    for word in words:
        found = parse(word.text)
        if found and found.kind == "v" and "*" in word.text and values == "vector":
            result += _expand_variable(sim, args, word, found)
            continue
        source = found.source(sim) if found and "*" in word.text and found.kind in "cf" else None
        size = length(sim, source, values) if source is not None and offers(source, values) else 0
        if found is None or size == 0:
            result.append(word)
            continue
        for k in args.as_range(Word(found.brackets[-1], word.span), 1, size):
            result.append(Word(f"{word.text[: word.text.index('[')]}[{k}]", word.span))
    return result


def _expand_variable(sim: Simulation, args: Args, word: Word, found: Reference) -> list[Word]:
    """The same for a vector-style variable, whose length nobody knows beforehand."""
    script = sim.script
    known = script.variables.known.get(found.name) if script is not None else None
    if known is None or known.style != "vector":
        return [word]
    bounds = re.fullmatch(r"(\d*)\*(\d*)", found.brackets[-1])
    if bounds is None or not bounds[2]:
        args.fail(f"Upper bound required to expand vector style variable {found.name}", word, hint=f"v_{found.name}[*5]")
    stem = word.text[: word.text.index("[")]
    return [Word(f"{stem}[{k}]", word.span) for k in args.as_range(Word(found.brackets[-1], word.span), 1, int(bounds[2]))]
