"""The script's variables as commands, fixes, computes, thermo columns and dumps read them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pylmp.model.atoms import Floats
from pylmp.text.variable_styles import Variable

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

EQUAL_STYLES = ("equal", "timer", "internal")  # one number, computed when it is asked for


class Variables:
    """The variables of a simulation's script, by name. A simulation without a script has none."""

    def __init__(self, sim: Simulation) -> None:
        self._sim = sim

    def style(self, name: str) -> str | None:
        """equal, atom, vector, index, ...; None if there is no such variable."""
        script = self._sim.script
        known = script.variables.known.get(name) if script is not None else None
        return str(known.style) if known is not None else None

    def number(self, name: str) -> float:
        """What an equal-style variable is worth now, all digits."""
        script = self._sim.script
        return float(script.variables.value(name, script.scope))

    def per_atom(self, name: str, rows: Any = None) -> Floats:
        """(n,) float64: what an atom-style variable is worth now for each owned atom, in local order.

        rows: row numbers, for which alone it is then evaluated: LAMMPS looks only at the atoms of the user's group, which
        matters where a formula is wrong for others or draws random numbers. Raises ScriptError with LAMMPS's sentence.
        """
        script = self._sim.script
        values: Floats = script.variables.per_atom(name, script.scope, rows)
        return values

    def vector(self, name: str) -> Floats:
        """(k,) float64: the elements of a vector-style variable, now. Raises ScriptError."""
        script = self._sim.script
        values: Floats = script.variables.vector(name, script.scope)
        return values

    def set_internal(self, name: str, value: float) -> None:
        """Give an internal-style variable, made if need be, a number. Formulas read it with all digits."""
        script = self._sim.script
        script.variables.known[name] = Variable("internal", number=value)
