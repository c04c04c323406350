"""What formulas may refer to in a simulation: variables, computes, fixes, thermo keywords."""

from __future__ import annotations

from typing import Any

from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.variables import Variables


class Scope:
    """Implements pylmp.text.formula.Scope for a simulation."""

    def __init__(self, sim: Simulation, variables: Variables) -> None:
        self._sim = sim
        self._variables = variables

    def variable(self, name: str, index: tuple[int, ...]) -> float:
        if name not in self._variables.known:
            raise ScriptError(f"Invalid variable reference v_{name} in variable formula", hint="define it first")
        return float(f"{self._variables.number(name, self):.15g}")  # LAMMPS passes variables on as text

    def compute(self, name: str, index: tuple[int, ...]) -> float:
        if not self._sim.has_box:
            raise ScriptError("Variable evaluation before simulation box is defined")
        found = self._sim.computes.get(name)
        if found is None:
            raise ScriptError(f"Invalid compute ID '{name}' in variable formula", hint="define it first")
        return self._entry(found, "compute", name, index)

    def fix(self, name: str, index: tuple[int, ...]) -> float:
        if not self._sim.has_box:
            raise ScriptError("Variable evaluation before simulation box is defined")
        found = next((fix for fix in self._sim.fixes if fix.id == name), None)
        if found is None:
            raise ScriptError(f"Invalid fix ID '{name}' in variable formula", hint="define it first")
        return self._entry(found, "fix", name, index)

    def _entry(self, source: Any, what: str, name: str, index: tuple[int, ...]) -> float:
        kind = ("scalar", "vector")[len(index)] if len(index) < 2 else "array"
        method = getattr(source, kind, None)
        if method is None:
            raise ScriptError(f"Mismatched {what} in variable formula", hint=f"{what} {name} has no {kind}")
        value = method(self._sim)
        if not index:
            return float(value)
        if not 1 <= index[0] <= len(value):
            raise ScriptError(f"Variable formula {what} vector is accessed out-of-range")
        return float(value[index[0] - 1])

    def keyword(self, name: str) -> float:
        if not self._sim.has_box:
            raise ScriptError("Variable evaluation before simulation box is defined", hint=f"{name} needs the box")
        return float(self._sim.output.thermo.value(name))
