"""Per-atom and local values that a compute reads from other computes, fixes and variables: c_ID, c_ID[N], f_ID, f_ID[N], v_NAME."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import current
from pylmp.model.reference import Reference, offers, parse
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


@dataclass(frozen=True)
class AtomInput:
    """reference: who gives the values. kind: per_atom or local."""

    reference: Reference
    kind: str = "per_atom"

    def check(self, sim: Simulation, owner: str) -> None:
        """What is referred to is still there. owner: whom LAMMPS's sentence names, e.g. "compute reduce"."""
        found = self.reference
        there: Any = Variables(sim).style(found.name) if found.kind == "v" else found.source(sim)
        if there is None:
            what = "Variable name" if found.kind == "v" else f"{found.what.capitalize()} ID"
            raise ScriptError(f"{what} {found.name} for {owner} does not exist", hint="it was deleted")

    def values(self, sim: Simulation, rows: Any, owner: str) -> Floats:
        """(k,) values of the chosen atoms (rows: bool or numbers), or all local ones, now."""
        found = self.reference
        if found.kind == "v":
            chosen = np.flatnonzero(rows) if np.asarray(rows).dtype == bool else rows
            return Variables(sim).per_atom(found.name, chosen)
        source = found.source(sim)
        if sim.step % getattr(source, "compatible_every", 1):
            raise ScriptError(f"Fix {found.name} used in {owner} not computed at compatible time")
        values = current(sim, source, self.kind)
        if found.index:
            values = values[:, found.index[0] - 1]
        return np.asarray(values[rows] if self.kind == "per_atom" else values)


def read_atom_input(sim: Simulation, args: Args, word: Word, kind: str = "per_atom", owner: str = "") -> AtomInput:
    """The input a word stands for. Raises ScriptError where there is none of that shape.

    owner: whom LAMMPS's sentence about a missing compute names, if not args.what
    """
    found = parse(word.text)
    if found is None or len(found.brackets) > 1 or "*" in word.text:
        args.illegal(word)
    if found.kind == "v":
        return _variable(sim, args, word, found, kind)
    shape = kind.replace("_", "-")
    source, who = found.source(sim), f"{args.what.capitalize()} {found.what} {found.name}"
    if source is None:
        args.fail(f"{found.what.capitalize()} ID {found.name} for {owner or args.what} does not exist", word)
    if not offers(source, kind):
        hint = "inputs local" if kind == "per_atom" and offers(source, "local") else ""
        args.fail(f"{who} does not calculate {shape} values", word, hint=hint)
    columns = int(getattr(source, "columns", 0))
    columns = 0 if columns == 1 else columns
    if found.index and not columns:
        args.fail(f"{who} does not calculate a {shape} array", word, hint=word.text.split("[")[0])
    if columns and not found.index:
        args.fail(f"{who} does not calculate a {shape} vector", word, hint=f"{word.text}[1]")
    if found.index and not 1 <= found.index[0] <= columns:
        args.fail(f"{who} array is accessed out-of-range", word, hint=f"1 to {columns}")
    return AtomInput(found, kind)


def _variable(sim: Simulation, args: Args, word: Word, found: Reference, kind: str) -> AtomInput:
    style = Variables(sim).style(found.name)
    if style is None:
        args.fail(f"Variable name {found.name} for {args.what} does not exist", word, hint=f"variable {found.name} atom ...")
    if kind == "local":
        args.fail("Compute {} inputs must be all local", word, hint="c_ID or f_ID with local values")
    if style not in ("atom", "atomfile"):
        args.fail(f"{args.what.capitalize()} variable {found.name} is not atom-style variable", word)
    return AtomInput(found)
