"""``x[5]``, ``mass[5]`` and ``x``, ``mass`` in formulas: one atom by its ID, or all owned atoms."""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.simulation import Simulation
from pylmp.text.formula_error import FormulaError

_PLAIN = {"id": "tag", "type": "type", "mol": "molecule", "q": "q", "radius": "radius"}
_AXES = {f"{name}{axis}": (name or "x", d) for name in ("", "v", "f") for d, axis in enumerate("xyz")}


def one(sim: Simulation, name: str, tag: int) -> float:
    """A property of the atom with that ID; 0.0 if it was lost or deleted."""
    if name not in _PLAIN and name not in _AXES and name != "mass":
        raise FormulaError(f"Invalid atom vector {name} in variable formula", plain=True)
    if _absent(sim, name):
        raise FormulaError("Variable uses atom property that isn't allocated", plain=True)
    row = row_of(sim, tag)
    return 0.0 if row is None else float(every(sim, name)[row])


def every(sim: Simulation, name: str) -> Floats:
    """(n,) float64 in local order."""
    atoms = sim.atoms
    if name == "mass":
        return np.asarray(sim.masses(), float)
    if name in _AXES:
        array, d = _AXES[name]
        values: Floats = getattr(atoms, array)[: atoms.n, d]
        return values
    if _absent(sim, name):
        raise FormulaError(f"Variable uses atom property '{name}' that isn't allocated", plain=True)
    return np.asarray(getattr(atoms, _PLAIN[name])[: atoms.n], float)


def _absent(sim: Simulation, name: str) -> bool:
    return {"mol": not sim.has_bonds, "q": not sim.style.charged, "radius": True}.get(name, False)


def row_of(sim: Simulation, tag: int) -> int | None:
    """The row of the owned atom with that ID; None if there is none now."""
    tags = sim.atoms.tag[: sim.atoms.n]
    if tag > tags.max(initial=0):
        raise FormulaError("Variable atom ID is too large", plain=True)
    rows = np.flatnonzero(tags == tag)
    return int(rows[0]) if len(rows) else None


def by_tag(sim: Simulation, tags: Any, values: Floats) -> Floats:
    """(n,) values by ID; 0.0 for owned atoms whose ID is not in tags."""
    table = np.zeros(int(max(sim.atoms.tag[: sim.atoms.n].max(initial=0), tags.max(initial=0))) + 1)
    table[tags] = values
    return table[sim.atoms.tag[: sim.atoms.n]]
