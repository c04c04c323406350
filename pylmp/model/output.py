"""When thermo lines and dump frames are due. What they contain is theirs to know."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any

from pylmp.model.clock import Clock
from pylmp.model.registry import COMPUTES, THERMOS
from pylmp.model.variables import EQUAL_STYLES, Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.compute import Compute
    from pylmp.model.simulation import Simulation

# The computes LAMMPS makes for its own table: ID, style, arguments.
DEFAULT_COMPUTES = (
    ("thermo_temp", "temp", ()),
    ("thermo_press", "pressure", ("thermo_temp",)),
    ("thermo_pe", "pe", ()),
)


def add_default_computes(sim: Simulation, computes: dict[str, Compute]) -> None:
    """Fill computes with those that LAMMPS always has."""
    for identity, style, arguments in DEFAULT_COMPUTES:
        kind = COMPUTES.find(style)
        if kind is not None:
            args = Args(f"compute {style}", [Word(text) for text in arguments])
            computes[identity] = kind(sim, identity, "all", 1, args)


class Output:
    """Schedules a run's output.

    dumps       by ID in order of definition (pylmp/dumps)
    every       thermo's interval; 0: first and last step of a run only
    variable    name of the variable that gives the step of the next thermo line instead, "" for none
    first last  steps between which the run in progress goes
    running     a run is in progress
    due_step    the next step at which something is to be written
    started     wall clock and processor seconds when its loop began
    """

    def __init__(self, sim: Simulation) -> None:
        self.dumps: dict[str, Any] = {}
        self.every = 0
        self.variable = ""
        self.first = self.last = 0
        self.running = False
        self.started = (0.0, 0.0)
        self.clock = Clock()
        self._sim = sim
        self._thermo: Any = None
        self._with_setup = True
        self._timeless = False
        self.restarts: Any = None  # the schedule of the restart command
        self.due_step = -1
        self._thermo_due = self._thermo_written = self._thermo_first = -1

    @property
    def thermo(self) -> Any:
        """The thermo table (pylmp/thermo); style one until thermo_style says otherwise."""
        if self._thermo is None:
            make = THERMOS.find("one")
            assert make is not None
            self._thermo = make(self._sim, Args("thermo_style", []))
        return self._thermo

    @thermo.setter
    def thermo(self, thermo: Any) -> None:
        self._thermo = thermo

    def begin(self, first: int, last: int, setup: bool, timeless: bool = False) -> None:
        """A run from step first to step last begins; its set-up, if there is one, comes next. timeless: its steps take no time (minimize, rerun)."""
        self.first, self.last, self.running = first, last, True
        self._with_setup = setup
        self._timeless = timeless
        if not timeless:
            self.clock.begin(first)

    def end(self) -> None:
        """The run is over."""
        self.running = False
        if not self._timeless:
            self.clock.book(self._sim.step, self._sim.dt)

    def time(self) -> float:
        """Simulated time at the current step."""
        return self.clock.now(self._sim.step, self._sim.dt)

    def init(self, sim: Simulation) -> None:
        """Check everything that will be written, open files."""
        if self.variable:
            style = Variables(sim).style(self.variable)
            if style is None:
                raise ScriptError("Variable name for thermo every does not exist", hint=f"variable {self.variable} equal ...")
            if style not in EQUAL_STYLES:
                raise ScriptError("Variable for thermo every is invalid style", hint="an equal-style variable")
        self.thermo.init()
        for dump in self.dumps.values():
            dump.init(sim)

    def setup(self, sim: Simulation) -> None:
        """Write what is due before the first step of a run: header, first thermo line, dump frames."""
        sim.asking.block()
        self.thermo.begin(memory=self._with_setup)
        self._thermo_written, self._thermo_first = -1, sim.step
        self._schedule_thermo(sim)
        for dump in self.dumps.values():
            dump.setup(sim)
        if self.restarts is not None:
            self.restarts.setup(sim)
        self._find_due()
        sim.console.flush()
        self.started = (time.perf_counter(), time.process_time())

    def jump(self, sim: Simulation) -> None:
        """The step number was set (rerun): what is due next, this step included."""
        following = -(-sim.step // self.every) * self.every if self.every else self.last
        self._thermo_due = min(following, self.last)
        for dump in self.dumps.values():
            dump.jump(sim)
        if self.restarts is not None:
            self.restarts.jump(sim)
        self._find_due()

    def write(self, sim: Simulation) -> None:
        """Write what is due at sim.step: the thermo line, then dump frames."""
        if sim.step == self._thermo_due:
            sim.asking.block()
            self.thermo.line()
            self._thermo_written = sim.step
            self._schedule_thermo(sim)
        for dump in self.dumps.values():
            if dump.due == sim.step:
                dump.write_due(sim)
        if self.restarts is not None and self.restarts.due == sim.step:
            self.restarts.write(sim)
        self._find_due()

    def close(self, sim: Simulation) -> None:
        """The last snapshot of a rerun is always in the thermo table."""
        if sim.step not in (self._thermo_written, self._thermo_first):
            sim.asking.block()
            self.thermo.line()

    def write_all(self, sim: Simulation) -> None:
        """Write everything at sim.step, the last one of a minimization, unless it was just written."""
        for dump in self.dumps.values():
            dump.write_due(sim)
        if self.restarts is not None:
            self.restarts.write_all(sim)
        if self._thermo_written != sim.step:
            sim.asking.block()
            self.thermo.line()

    def _schedule_thermo(self, sim: Simulation) -> None:
        """When the next line is due; what this one evaluated is wanted again then."""
        if self.variable:
            given = Variables(sim).number(self.variable)
            following = int(given) if abs(given) < 2.0**63 else -1
            if following <= sim.step:
                told = "" if sim.step == self.first else f": {following} vs {sim.step}"
                raise ScriptError(f"Thermo every variable returned a bad timestep{told}", hint="a step to come")
        else:
            following = (sim.step // self.every + 1) * self.every if self.every else self.last
        self._thermo_due = min(following, self.last)
        sim.asking.again(self._thermo_due)

    def _find_due(self) -> None:
        restarts = [self.restarts.due] if self.restarts is not None else []
        self.due_step = min([self._thermo_due, *restarts, *(dump.due for dump in self.dumps.values())])

    def due(self, sim: Simulation) -> bool:
        """Something is to be written at sim.step."""
        return sim.step == self.due_step
