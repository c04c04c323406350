"""A script carried out without a step, command by command, noting what each one does."""

from __future__ import annotations

import io
import re
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from pylmp.engines.dry import Dry
from pylmp.interpreter import Interpreter
from pylmp.model.console import Console
from pylmp.model.scene import Scene
from pylmp.model.simulation import Simulation
from pylmp.script import Ready, read_script
from pylmp.text.diagnostic import Diagnostic, ScriptError
from pylmp.text.leave import Quit
from pylmp.text.lines import Text
from pylmp.text.span import Span
from pylmp.tools.explain.facts import changes, coefficients, facts
from pylmp.tools.explain.forms import Given, read
from pylmp.tools.explain.scene import RunTold, tell_run

MOST = 20_000  # commands that are looked at
_NOISE = re.compile(
    r"CPU = |^Neighbor list info|^  (update: |max neighbors/atom|master list|ghost atom cutoff|binsize =|\d+ neighbor lists|\(\d+\) )"
    r"|^      (attributes|pair build|stencil|bin): |^Generated 0 of|^System init"
)
_SHOWN = 12  # lines of what LAMMPS would say


@dataclass
class Told:
    """One command at its place. words: variables replaced, the command's name first. visits: how often the script came by; the rest is of the first time."""

    span: Span
    words: list[str]
    units: str
    arguments: list[Given] = field(default_factory=list)
    changes: list[str] = field(default_factory=list)
    says: list[str] = field(default_factory=list)
    run: RunTold | None = None
    problem: Diagnostic | None = None
    visits: int = 1


@dataclass
class Story:
    """commands in the order in which they were first met; end: why it ends before the script's end, "" if it does not."""

    script: str
    commands: list[Told]
    facts: dict[str, str]
    end: str = ""


class Watcher(Interpreter):
    """Errors are noted and the script goes on."""

    def __init__(self, sim: Simulation) -> None:
        super().__init__(sim, (), MOST, None)
        self.dry = True
        self.told: dict[tuple[str, int, int], Told] = {}
        self.screen = io.StringIO()
        self._runs: list[tuple[int, RunTold]] = []
        self._at = 0
        self.run_told: RunTold | None = None
        sim.console.screen_file = self.screen
        sim.engine = Dry(self._look)

    def _look(self, sim: Simulation, scene: Scene, steps: int) -> None:
        told = tell_run(sim, scene, steps)
        scenes = ((line, one) for line, one in self._runs if (one.engine, one.computed, one.left_out) == (told.engine, told.computed, told.left_out))
        line = next((line for line, _ in scenes), 0)
        self.run_told = replace(told, same_as=line)
        if not line:
            self._runs.append((self._at, told))

    def execute_line(self, line: Text) -> None:
        try:
            super().execute_line(line)
        except ScriptError as error:
            if error.diagnostic.code == "S104":  # MOST commands
                raise
            whole = line.text.strip()
            start = max(0, line.text.find(whole))
            span = line.span(start, start + max(1, len(whole)))
            one = self.told.setdefault((span.file, span.line, span.column), Told(span, whole.split(), self.sim.units.name))
            one.problem = one.problem or error.diagnostic

    def _survey(self, owner: object) -> None:
        """What only LAMMPS has is told where it stands."""
        self._surveyed = True

    def _carry_out(self, ready: Ready, typed: str) -> None:
        owner = ready.words[0]
        span = owner.span or Span("", 0, 0, 0)
        key = (span.file, span.line, span.column)
        if key in self.told:
            self.told[key].visits += 1
            super()._carry_out(ready, typed)
            return
        words = [word.text for word in ready.words]
        one = self.told[key] = Told(span, words, self.sim.units.name, read(words[0], words[1:]) if words[1:] else read(words[0], []))
        before, self.run_told, self._at = facts(self.sim), None, span.line
        self.screen.seek(0)
        self.screen.truncate()
        try:
            super()._carry_out(ready, typed)
        finally:
            one.changes = changes(before, facts(self.sim))
            one.arguments += coefficients(self.sim, words)
            if self.run_told is None:  # of a run LAMMPS says what only a run knows
                one.says = [line.strip() for line in self.screen.getvalue().splitlines() if line.strip() and not _NOISE.search(line)][:_SHOWN]
            one.run = self.run_told


def watch(path: Path, variables: list[list[str]]) -> Story:
    """Look at a script. variables: (name, values...), as -var gives them. Raises ScriptError if it cannot be read."""
    sim = Simulation(Console(None, None))
    watcher = Watcher(sim)
    for name, *values in variables:
        watcher.variables.set_index(name, values)
    read_script(path)
    end = ""
    with np.errstate(all="ignore"):
        try:
            watcher.run_main(path)
        except Quit:
            end = "the script quits here"
        except ScriptError as error:
            end = f"no more than {MOST} commands are looked at" if error.diagnostic.code == "S104" else error.diagnostic.message
    return Story(str(path), list(watcher.told.values()), facts(sim), end)
