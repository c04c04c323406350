"""sum() min() max() ave() trap() slope() sort() rsort() of a global vector: of a compute, a fix or a vector-style variable.

Source: LAMMPS manual, variable.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.sums import total
from pylmp.references.measured import global_vector
from pylmp.text.diagnostic import ScriptError
from pylmp.text.formula_error import FormulaError

if TYPE_CHECKING:
    from pylmp.references.scope import Scope

_BIG = 1.0e20


def _slope(y: Floats) -> float:
    """Of the line through (0, y0), (1, y1), ... by least squares."""
    n = len(y)
    x = np.arange(n, dtype=float)
    sx, sy, sxx, sxy = total(x), total(y), total(x * x), total(x * y)
    numerator, denominator = n * sxy - sx * sy, n * sxx - sx * sx
    return numerator / denominator if denominator != 0.0 else _BIG


def _trap(y: Floats) -> float:
    """Half weight for the ends."""
    return total(y) - 0.5 * (float(y[0]) + float(y[-1])) if len(y) else 0.0


FUNCTIONS: dict[str, Callable[[Floats], Any]] = {
    "sum": total, "ave": lambda y: total(y) / len(y), "min": lambda y: float(min([_BIG, *y.tolist()])),
    "max": lambda y: float(max([-_BIG, *y.tolist()])), "trap": _trap, "slope": _slope, "sort": np.sort,
    "rsort": lambda y: np.sort(y)[::-1].copy(),
}  # fmt: skip


def value(scope: Scope, function: str, names: tuple[str, ...], mode: str) -> Any:
    """A number, or a vector (sort, rsort)."""
    if len(names) != 1:
        raise FormulaError(f"Invalid special function {function}() in variable formula")
    values = _vector(scope, names[0])
    if function == "ave" and not len(values):
        raise ScriptError(f"Variable {names[0][2:]}: Cannot compute average of empty vector")
    if function in ("sort", "rsort") and mode != "vector":
        raise FormulaError("Invalid syntax in variable formula", hint=f"{function}() gives a vector")
    return FUNCTIONS[function](values)


def _vector(scope: Scope, text: str) -> Floats:
    name = text[2:]
    if text.startswith("v_") and "[" not in text and name:
        known = scope.variables.known.get(name)
        if known is not None and known.style != "vector":
            raise ScriptError(f"Variable {name}: Mis-matched special function variable in variable formula", hint="a vector-style variable")
        if known is not None:
            return scope.variables.vector(name, scope)
    elif text[:2] in ("c_", "f_"):
        values: Floats | None = global_vector(scope.sim, text)
        if values is not None:
            return values
    raise FormulaError("Invalid special function in variable formula", plain=True, hint="c_ID c_ID[N] f_ID f_ID[N] v_name")
