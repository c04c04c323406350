"""Values that a fix reads of computes, fixes and variables: c_ID[I], f_ID[I], v_NAME[I], each with LAMMPS's sentences."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import current
from pylmp.model.reference import KINDS, expand, parse
from pylmp.model.variables import EQUAL_STYLES, Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


@dataclass
class Input:
    """text: as the script says. kind: c, f or v. index: 0 where there are no brackets. vector: a column, else one number."""

    text: str
    kind: str
    name: str
    index: int
    vector: bool
    extensive: bool = False
    rows: int = 1  # of a vector, as far as it is known beforehand
    varying: bool = False  # the rows of a vector

    def source(self, sim: Simulation) -> Any:
        if self.kind == "c":
            return sim.computes.get(self.name)
        return next((fix for fix in sim.fixes if fix.id == self.name), None)

    @property
    def values(self) -> str:
        """scalar, vector or array: where the value is found."""
        return ("scalar", "vector", "array")[self.vector + (self.index > 0)]

    def find(self, sim: Simulation, owner: str) -> Any:
        """The compute or fix, or the variable's style. Raises ScriptError."""
        found = Variables(sim).style(self.name) if self.kind == "v" else self.source(sim)
        if found is None:
            raise ScriptError(missing(self, owner), hint="it was deleted")
        return found

    def measure(self, sim: Simulation) -> Any:
        """Its value now: a float, or (rows,) of a vector."""
        if self.kind == "v":
            variables = Variables(sim)
            if not self.vector and not self.index:
                return variables.number(self.name)
            whole: Floats = variables.vector(self.name)
            if self.vector:
                return whole
            return float(whole[self.index - 1]) if self.index <= len(whole) else 0.0
        value = current(sim, self.source(sim), self.values)
        if self.values == "scalar":
            return float(value)
        if self.values == "vector":
            if self.vector:
                return np.array(value)
            return float(value[self.index - 1]) if self.index <= len(value) else 0.0
        return np.array(value[:, self.index - 1])


def missing(value: Input, owner: str) -> str:
    if value.kind == "v":
        return f"Variable name {value.name} for {owner} does not exist"
    return f"{KINDS[value.kind].capitalize()} ID {value.name} for {owner} does not exist"


def read_inputs(sim: Simulation, args: Args, *, vector: bool, every: int) -> list[Input]:
    """Take the words that are references, wildcards expanded; vector: each must be a vector, else a number.

    every: how often they are read. Raises ScriptError.
    """
    words = []
    while (word := args.peek()) is not None and word.text[:2] in ("c_", "f_", "v_"):
        words.append(args.word())
    if not words:
        args.fail(f"No values from computes, fixes, or variables used in {args.what} command", args.peek(), hint="c_ID f_ID v_NAME")
    return [_input(sim, args, word, vector, every) for word in expand(sim, args, words, "array" if vector else "vector")]


def _input(sim: Simulation, args: Args, word: Word, vector: bool, every: int) -> Input:
    found = parse(word.text)
    if found is None or len(found.brackets) > 1 or "*" in word.text:
        args.fail(f"Invalid {args.what} argument: {word.text}", word, hint="c_ID, c_ID[I]")
    value = Input(word.text, found.kind, found.name, found.index[0] if found.index else 0, vector)
    if found.kind == "v":
        _check_variable(sim, args, word, value)
    else:
        _check_source(args, word, value, value.source(sim), every)
    return value


def _check_variable(sim: Simulation, args: Args, word: Word, value: Input) -> None:
    what = args.what.capitalize()
    style = Variables(sim).style(value.name)
    if style is None:
        args.fail(missing(value, args.what), word)
    if value.vector and value.index:
        args.fail(f"{what} mode vector variable {value.name} cannot be indexed", word)
    value.varying = value.vector
    if value.vector or value.index:
        if style != "vector":
            args.fail(f"{what} variable {value.name} is not vector-style variable", word)
    elif style not in EQUAL_STYLES:
        args.fail(f"{what} variable {value.name} is not equal-style variable", word)


def _check_source(args: Args, word: Word, value: Input, source: Any, every: int) -> None:
    kind = KINDS[value.kind]
    what = f"{args.what.capitalize()} {kind} {value.name}"
    if source is None:
        args.fail(missing(value, args.what), word)
    if not callable(getattr(source, value.values, None)):
        article = "an" if value.values == "array" else "a"
        args.fail(f"{what} does not calculate {article} {value.values}", word)
    if value.index:
        size = getattr(source, "columns" if value.vector else "length", 0)
        if size and value.index > size:
            args.fail(f"{what} {value.values} is accessed out-of-range", word, hint=f"1 to {size}")
    varying = getattr(source, "varying", False)
    if value.kind == "f" and varying and value.index:
        length = "have variable row length" if value.vector else "be variable length"
        args.fail(f"{what} {value.values} cannot {length}", word, hint="read the compute itself")
    if value.kind == "f" and every % source.compatible_every:
        args.fail(
            f"Fix {value.name} for {args.what} not computed at compatible time", word,
            hint=f"read it every {source.compatible_every} steps, or a multiple",
        )  # fmt: skip
    extensive = getattr(source, f"extensive_{value.values}", False)
    if isinstance(extensive, tuple):
        extensive = all(extensive) if value.vector else extensive[value.index - 1]
    value.extensive = bool(extensive)
    if value.vector:
        value.varying = varying and value.kind == "c"
        value.rows = 1 if varying else int(getattr(source, "length", 0))
