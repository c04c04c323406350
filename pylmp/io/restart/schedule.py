"""When a run writes restart files: what the restart command asked for."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from pylmp.io.restart.files import write_restart
from pylmp.model.variables import EQUAL_STYLES, Variables
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Word

_NEVER = 2**63 - 1


class Series:
    """names: one, which gets the step; or two in turn. every: steps between files, 0 if variable says, below 0: never. due: the next step."""

    def __init__(self, names: list[Word], every: int, variable: str) -> None:
        self.names = names
        self.every = every
        self.variable = variable
        self.due = _NEVER
        self._turn = 0

    def set_due(self, sim: Simulation, first: bool) -> None:
        """The step of the next file after the current one."""
        if not self.variable:
            self.due = (sim.step // self.every + 1) * self.every if self.every > 0 else _NEVER
            return
        style = Variables(sim).style(self.variable)
        if style is None:
            raise ScriptError("Variable name for restart does not exist", hint=f"variable {self.variable} equal ...", manual="restart.html")
        if style not in EQUAL_STYLES:
            raise ScriptError("Variable for restart is invalid style", hint="an equal-style variable", manual="restart.html")
        sim.asking.block()
        self.due = int(Variables(sim).number(self.variable))
        if self.due <= sim.step:
            versus = "<=" if len(self.names) == 2 and not first else "vs"
            raise ScriptError(
                f"Restart variable returned a bad next timestep: {self.due} {versus} {sim.step}",
                hint="a step to come, such as stride(0,1000,100)", manual="restart.html",
            )  # fmt: skip
        sim.asking.again(self.due)

    def write(self, sim: Simulation) -> None:
        name = self.names[self._turn]
        if len(self.names) == 1:
            name = replace(name, text=name.text.replace("*", str(sim.step), 1))
        else:
            self._turn = 1 - self._turn
        write_restart(sim, name)


class Restarts:
    """single: a file a step; double: two files in turn. Either may be there. due: the step at which one writes next."""

    def __init__(self) -> None:
        self.single: Series | None = None
        self.double: Series | None = None

    @property
    def all(self) -> list[Series]:
        return [series for series in (self.single, self.double) if series is not None]

    @property
    def due(self) -> int:
        return min(series.due for series in self.all)

    def setup(self, sim: Simulation) -> None:
        """A run begins."""
        for series in self.all:
            series.set_due(sim, first=True)

    def jump(self, sim: Simulation) -> None:
        """The step number was set: a file may be due now."""
        for series in self.all:
            series.set_due(sim, first=False)
            if series.every > 0 and sim.step % series.every == 0:
                series.due = sim.step

    def write_all(self, sim: Simulation) -> None:
        """The last step of a minimization: write all there is."""
        for series in self.all:
            series.write(sim)

    def write(self, sim: Simulation) -> None:
        """Write what is due at this step."""
        for series in self.all:
            if series.due == sim.step:
                series.write(sim)
                series.set_due(sim, first=False)
