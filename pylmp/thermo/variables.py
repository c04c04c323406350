"""Variables as thermo columns and dumps read them."""

from __future__ import annotations

from pylmp.model.simulation import Simulation


class Variables:
    """The script's variables, by name. A simulation without a script has none."""

    def __init__(self, sim: Simulation) -> None:
        self._sim = sim

    def style(self, name: str) -> str | None:
        """equal, index, ...; None if there is no such variable."""
        script = self._sim.script
        known = script.variables.known.get(name) if script is not None else None
        return str(known.style) if known is not None else None

    def number(self, name: str) -> float:
        """What an equal-style variable is worth now."""
        script = self._sim.script
        return float(script.variables.number(name, script.scope))
