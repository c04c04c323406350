"""The columns of thermo_style custom that name computes, fixes and variables."""

from __future__ import annotations

import difflib
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pylmp.model.reference import Reference, offers, parse
from pylmp.model.variables import EQUAL_STYLES
from pylmp.text.words import Args, Word
from pylmp.thermo.keywords import KEYWORDS

if TYPE_CHECKING:
    from pylmp.thermo.table import Thermo


@dataclass(frozen=True)
class Column:
    """name: as the script says. header: above it. value: evaluates it at the current step. needs: as Keyword.needs."""

    name: str
    header: str
    whole: bool
    value: Callable[[Thermo], float]
    needs: str = ""
    reference: Reference | None = None


def column(thermo: Thermo, args: Args, word: Word) -> Column:
    """The column a word of thermo_style custom stands for."""
    keyword = KEYWORDS.get(word.text)
    if keyword is not None:
        return Column(word.text, keyword.header, keyword.whole, keyword.value, keyword.needs)
    found = parse(word.text)
    if found is None or "*" in word.text:
        args.fail(f"Unknown keyword '{word.text}' in thermo_style custom command", word, hint=_hint(word.text))
    if found.kind == "v":
        value = _variable(thermo, args, word, found)
    else:
        value = _measured(thermo, args, word, found)
    return Column(word.text, word.text, False, value, reference=found)


def _hint(text: str) -> str:
    near = difflib.get_close_matches(text.lower(), KEYWORDS, 1)
    return f"did you mean {near[0]}?" if near else ""


def _measured(thermo: Thermo, args: Args, word: Word, found: Reference) -> Callable[[Thermo], float]:
    """A scalar, a component of a vector or an element of an array of a compute or fix."""
    sim, what, name = thermo.sim, found.what, found.name
    source = found.source(sim)
    if source is None:
        args.fail(f"Could not find thermo custom {what} ID: {name}", word)
    values = ("scalar", "vector", "array")[len(found.index)]
    if not offers(source, values):
        hint = f"{word.text}[1]" if values == "scalar" and offers(source, "vector") else ""
        article = "an" if values == "array" else "a"
        args.fail(f"Thermo custom {what} {name} does not compute {article} {values}", word, hint=hint)
    at = tuple(k - 1 for k in found.index)
    if at:
        sizes = [source.length] if values == "vector" else [source.length, source.columns]
        varying = getattr(source, "varying", False) or sizes[0] == 0  # rows are known once there are some
        if any(k < 0 or (k >= size and not (varying and n == 0)) for n, (k, size) in enumerate(zip(at, sizes, strict=True))):
            args.fail(f"Thermo custom {what} {name} {values} is accessed out-of-range", word, hint=f"1 to {sizes}")
    return lambda t: t.measure(found, values, at)


def _variable(thermo: Thermo, args: Args, word: Word, found: Reference) -> Callable[[Thermo], float]:
    """An equal-style variable, or an element of a vector-style one: 0 beyond its length, which may change."""
    name, at = found.name, found.index
    style = thermo.variables.style(name)
    if style is None:
        args.fail(f"Could not find thermo custom variable name: {name}", word)
    if len(at) > 1:
        args.fail(f"Thermo custom variable {name} cannot have two indices", word)
    if not at and style not in EQUAL_STYLES:
        args.fail(f"Thermo custom variable {name} is not an equal-style variable", word)
    if not at:
        return lambda t: t.variables.number(name)
    if style != "vector":
        args.fail(f"Thermo custom variable {name} is not a vector-style variable", word)

    def element(t: Thermo) -> float:
        values = t.variables.vector(name)
        return float(values[at[0] - 1]) if 0 < at[0] <= len(values) else 0.0

    return element
