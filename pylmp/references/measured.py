"""``c_ID``, ``f_ID[2]``, ``C_ID[5]``, ``F_ID[5][1]`` in formulas: what computes and fixes measured.

Source: LAMMPS manual, variable.html, which says what the formulas of each style of variable may refer to.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.model.compute import current
from pylmp.model.reference import Reference, length, offers, parse
from pylmp.model.simulation import Simulation
from pylmp.references.atom_values import row_of
from pylmp.text.diagnostic import ScriptError
from pylmp.text.formula_error import FormulaError

# What the number of indices means, by the style of the formula; capitals mean atoms by ID.
_MEANING = {
    "equal": ("scalar", "vector", "array"), "vector": ("vector", "array"), "atom": ("per_atom", "per_atom"),
    "capital": ("", "per_atom", "per_atom"),
}  # fmt: skip


def value(sim: Simulation, kind: str, name: str, index: tuple[int, ...], mode: str) -> Any:
    """A number (equal style), the elements of a vector (vector style), or a value for each owned atom (atom style)."""
    found = Reference(kind.lower(), name, ())
    source, what = found.source(sim), found.what
    if source is None:
        known = " ".join(sim.computes if found.kind == "c" else (fix.id for fix in sim.fixes))
        raise FormulaError(f"Invalid {what} ID '{name}' in variable formula", hint=f"{what}s: {known}")
    if kind.isupper() and mode != "equal":
        raise FormulaError(f"Mismatched {what} in variable formula")
    meanings = _MEANING["capital" if kind.isupper() else mode]
    values = meanings[len(index)] if len(index) < len(meanings) else ""
    if not values or not offers(source, values):
        raise FormulaError(f"Mismatched {what} in variable formula")
    columns = 0
    if values == "per_atom":
        columns = length(sim, source, values)
        if (columns > 0) != (len(index) == (2 if kind.isupper() else 1)):
            _ready(source, found)
            raise FormulaError(f"Mismatched {what} in variable formula")
        if columns and index[-1] > columns:
            raise FormulaError(f"Variable formula {what} array is accessed out-of-range")
    _ready(source, found)
    if found.kind == "f" and sim.step % source.compatible_every:
        raise FormulaError("Fix in variable not computed at a compatible time")
    measured = current(sim, source, values)
    if kind.isupper():
        row = row_of(sim, index[0])
        return 0.0 if row is None else float(measured[row, index[1] - 1] if columns else measured[row])
    if mode == "atom":
        return np.asarray(measured[:, index[0] - 1] if columns else measured, float)
    if mode == "vector":
        return np.asarray(_column(measured, index[0], what) if index else measured, float)
    for at in index:
        if at > len(measured) and found.kind == "f" and getattr(source, "varying", False):
            return 0.0
        if not 1 <= at <= len(measured):
            raise FormulaError(f"Variable formula {what} {values} is accessed out-of-range")
        measured = measured[at - 1]
    return float(measured)


def _ready(source: Any, found: Reference) -> None:
    if found.kind == "c" and not source.ready:
        raise FormulaError("Variable formula compute cannot be invoked before initialization by a run")


def _column(table: Any, at: int, what: str) -> Any:
    if at > table.shape[1]:
        raise FormulaError(f"Variable formula {what} array is accessed out-of-range")
    return table[:, at - 1]


def global_vector(sim: Simulation, text: str) -> Any:
    """(k,) what ``c_ID``, ``c_ID[2]`` stand for as the argument of sum() and its like.

    None if text is no such reference. Raises ScriptError.
    """
    found = parse(text)
    if found is None or found.kind == "v" or "*" in text or len(found.brackets) > 1:
        return None
    source, what = found.source(sim), found.what
    if source is None:
        raise ScriptError(f"Invalid {what} ID '{found.name}' in variable formula")
    values = "array" if found.brackets else "vector"
    if not offers(source, values):
        raise ScriptError(f"Mismatched {what} in variable formula", hint="it has no vector" if values == "vector" else "")
    if found.kind == "c" and not source.ready:
        raise ScriptError("Variable formula compute cannot be invoked before initialization by a run")
    measured = current(sim, source, values)
    return np.asarray(_column(measured, found.index[0], what) if found.brackets else measured, float)
