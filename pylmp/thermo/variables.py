"""Variables as thermo columns and dumps read them."""

from __future__ import annotations

from typing import Any

from pylmp.model.atoms import Floats
from pylmp.model.simulation import Simulation


class Variables:
    """The interpreter's variables, by name."""

    def __init__(self, sim: Simulation) -> None:
        self._sim = sim

    def _all(self) -> Any:
        return getattr(self._sim.script, "variables", None)

    def style(self, name: str) -> str | None:
        """equal, vector, atom, ...; None if there is no such variable."""
        variables = self._all()
        return None if variables is None else variables.style(name)

    def number(self, name: str) -> float:
        """What an equal-style variable is worth now."""
        return float(self._all().number(name))

    def element(self, name: str, at: int) -> float:
        """Element at (from 0) of a vector-style variable."""
        return float(self._all().vector(name)[at])

    def per_atom(self, name: str) -> Floats:
        """(n,) values of an atom-style variable."""
        values: Floats = self._all().per_atom(name)
        return values
