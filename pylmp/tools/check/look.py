"""A script carried out to its end without a step: every error and warning is kept, and the command that failed is left out."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np

from pylmp.engines.dry import Dry
from pylmp.interpreter import Interpreter
from pylmp.model.console import Console
from pylmp.model.scene import Scene
from pylmp.model.simulation import Simulation
from pylmp.script import Ready, Script, read_script
from pylmp.text.condition import ConditionError, holds
from pylmp.text.diagnostic import Diagnostic, ScriptError, Unsupported
from pylmp.text.leave import Quit
from pylmp.text.lines import Text
from pylmp.text.span import Span
from pylmp.text.words import Word
from pylmp.tools.check.follow import Failures
from pylmp.tools.check.holes import HOLE, HoleScope, is_hole, without_templates
from pylmp.tools.check.rule import Rule, rules
from pylmp.tools.check.setup import check_setup

MOST, ROUNDS = 20_000, 1000  # commands that are looked at; how often one jump is followed
REFUSED, WARNED, ELSEWHERE, BOTH_WAYS, CUT = "E001", "W001", "N001", "N002", "N003"
_NUMBERS = re.compile(r"\*|%|base|[0-9]+")  # what stands in the place of a step or a process in the name of a file


class Listener(Console):
    """LAMMPS's warnings, where they are given. Nothing is printed."""

    def __init__(self) -> None:
        super().__init__(None, None)
        self.heard: list[str] = []

    def warning(self, message: str) -> None:
        self.heard.append(message)


class Look(Interpreter):
    """found: what is wrong, in the order of the lines. words, span: the command being carried out."""

    def __init__(self) -> None:
        self.listener = Listener()
        sim = Simulation(self.listener)
        super().__init__(sim, (), MOST, None)
        self.dry = True
        self.echo = "none"
        self.holes = self.scope = HoleScope(sim, self.variables)
        self.found: dict[tuple[str, int, int, str], Diagnostic] = {}
        self.failures = Failures()
        self.words: list[str] = []
        self.span: Span | None = None
        self.places: set[tuple[str, int]] = set()  # lines that were carried out
        self.branching = 0  # inside a branch that a hole decides
        self.rules: list[Rule] = [rule() for rule in rules()]
        self._restarts: list[str] = []  # what a restart command names
        self._jumps: dict[Span | None, int] = {}
        sim.engine = Dry(self._run)

    # ---- what is found ----------------------------------------------------------------------------------------

    def add(self, diagnostic: Diagnostic) -> None:
        """Keep it, once for its place."""
        span = diagnostic.span or Span("", 0, 0)
        self.found.setdefault((span.file, span.line, span.column, diagnostic.message), diagnostic)

    def sources(self) -> list[list[str]]:
        """The lines of every file that was read."""
        return list(self._sources.values())

    def files(self) -> dict[str, str]:
        """The text of every file that was read."""
        return {name: "\n".join(lines) for name, lines in self._sources.items()}

    def warn(self, rule: Rule, span: Span | None, message: str, hint: str = "") -> None:
        """What a rule found."""
        self.add(Diagnostic(message, span or self.span, hint, rule.code, rule.manual, rule.severity))

    def note(self, code: str, span: Span | None, message: str, hint: str = "") -> None:
        self.add(Diagnostic(message, span, hint, code, severity="note"))

    # ---- files and flow ---------------------------------------------------------------------------------------

    def _script(self, text: str, name: str) -> Script:
        script = super()._script(without_templates(text), name)
        self._sources[name] = text.split("\n")
        return script

    def jump(self, file: str, label: str | None, span: Span | None) -> None:
        if self._skip_jump:
            super().jump(file, label, span)
            return
        self._jumps[span] = count = self._jumps.get(span, 0) + 1
        if self.branching or count > ROUNDS:
            if label is not None and file in ("SELF", self._stack[-1].name) and label not in self._stack[-1].labels:
                super().jump(file, label, span)
            if count > ROUNDS:
                self.note(CUT, span, f"This loop is followed {ROUNDS} times, no further")
            return
        super().jump(file, label, span)

    def execute_line(self, line: Text) -> None:
        outer, self.words = self.words, line.text.split()
        if self.words and self.words[0].startswith("#"):
            self.words = []
        try:
            super().execute_line(line)
        except ScriptError as error:
            if error.diagnostic.code == "S104":
                raise
            self._failed(error, line)
        except (Quit, KeyboardInterrupt, BrokenPipeError):
            if not self.branching:
                raise
        except Exception as error:  # arithmetic on holes
            if not self._on_hole:
                whole = line.text.rstrip()
                self.note(
                    "N009",
                    line.span(0, len(whole)),
                    f"This line could not be checked ({type(error).__name__}: {error})",
                )
            self.failures.note(self.words)
        finally:
            self.words = outer

    _on_hole = _early_end = _blind = False  # blind: the state is that of a file which is not there

    def _failed(self, error: ScriptError, line: Text) -> None:
        """An error, unless it only follows from another or from a hole."""
        diagnostic, words = error.diagnostic, self.words
        if diagnostic.span is None:
            whole = line.text.strip()
            start = max(0, line.text.find(whole))
            diagnostic = replace(diagnostic, span=line.span(start, start + max(1, len(whole))))
        follows = self.failures.explain(words, diagnostic.message, self.sim.has_box)
        self.failures.note(words)
        if isinstance(error, Unsupported):
            said = diagnostic.message.split(",")[0]
            self.note(ELSEWHERE, diagnostic.span, f"{said}, pylmp does not: only its name is checked")
        elif self._late(words):
            pass
        elif self._own_file(words, diagnostic.message):
            self.note("N004", diagnostic.span, "The script itself writes this file: only a run knows what is in it")
            self._blind |= words[0] in ("include", "read_data", "read_restart", "jump")
        elif not (follows or self._on_hole or self._blind):
            self.add(replace(diagnostic, code=diagnostic.code or REFUSED))

    def _late(self, words: list[str]) -> bool:
        """Does it depend on the step at which a run ended that may end early?"""
        return self._early_end and words[0] in ("run", "reset_timestep") and len(words) > 2

    def _own_file(self, words: list[str], message: str) -> bool:
        """Is a file missing that the script writes in a run?"""
        if "annot open" not in message and "no restart file matching" not in message:
            return False
        names = {_NUMBERS.sub("*", name) for name in (*self.writes, *self._restarts)}
        return any(_NUMBERS.sub("*", word) in names for word in words)

    def _survey(self, owner: Word) -> None:
        """What only LAMMPS has is noted where it stands."""
        self._surveyed = True

    # ---- one command ------------------------------------------------------------------------------------------

    def _lookup(self, key: str, is_formula: bool) -> str:
        before, self.holes.met = self.holes.met, False
        try:
            text = super()._lookup(key, is_formula)
            return HOLE if self.holes.met else text
        except ScriptError:
            if self.holes.met:
                return HOLE
            raise
        finally:
            self.holes.met = before

    def _carry_out(self, ready: Ready, typed: str) -> None:
        owner = ready.words[0]
        self.words = [word.text for word in ready.words]
        outer, self.span = self.span, owner.span
        if owner.span is not None:
            self.places.add((owner.span.file, owner.span.line))
        self._on_hole = any(is_hole(word) for word in self.words)
        for rule in self.rules:
            rule.before(self, ready.words)
        try:
            if owner.text == "if" and self._both_ways(ready.words):
                return
            super()._carry_out(ready, typed)
            if owner.text == "restart":
                self._restarts += [part for word in self.words[2:] for part in (word, f"{word}.*")]
            if owner.text == "clear":
                self._blind = False
                self.failures.clear()
            for rule in self.rules:
                rule.after(self, ready.words)
        finally:
            for message in self.listener.heard:
                self.add(Diagnostic(message.split("\n")[0], owner.span, code=WARNED, severity="note"))
            self.listener.heard.clear()
            self.span = outer

    def _both_ways(self, words: list[Word]) -> bool:
        """Follow all branches of an if whose condition is a hole. False: it is none."""
        conditions = [
            words[k + 1]
            for k, word in enumerate(words[:-1])
            if word.text in ("if", "elif") and (k == 0 or not word.quoted)
        ]
        if not conditions or not self._unknown_condition(conditions):
            return False
        self.note(BOTH_WAYS, conditions[0].span, "Only a run knows whether this holds: all branches are checked")
        self.branching += 1
        try:
            skip = True
            for word in words[1:]:
                if word.text in ("then", "else", "elif") and not word.quoted:
                    skip = word.text == "elif"
                elif skip:
                    skip = word.text != "then" and word not in conditions
                else:
                    self.execute_word(word)
        finally:
            self.branching -= 1
        return True

    def _unknown_condition(self, conditions: list[Word]) -> bool:
        """Is the first condition that may decide a hole?"""
        for condition in conditions:
            text = self.substitute_text(condition)
            if is_hole(text):
                return True
            try:
                if holds(text):
                    return False
            except ConditionError:
                return False
        return False

    def _run(self, sim: Simulation, scene: Scene, steps: int) -> None:
        self._early_end |= sim.relaxing or any(fix.style == "halt" for fix in sim.fixes) or sim.timer.limit is not None
        for rule in self.rules:
            rule.run(self, scene, steps)
        check_setup(sim, scene, steps)


def look(path: Path, variables: list[list[str]]) -> tuple[Look, list[Diagnostic]]:
    """All that is found in a script and in what it includes, by place. Raises ScriptError if it cannot be read."""
    one = Look()
    for name, *values in variables:
        one.variables.set_index(name, values)
    read_script(path)
    whole = True
    with np.errstate(all="ignore"):
        try:
            one.run_main(path)
        except Quit:
            pass
        except ScriptError as error:
            whole = False
            if error.diagnostic.code == "S104":
                one.note(CUT, error.diagnostic.span, f"No more than {MOST} commands are looked at")
            else:
                one.add(error.diagnostic)
    for rule in one.rules:
        rule.end(one, whole)
    found = [kept for kept in one.found.values() if not one_is_ignored(one, kept)]
    return one, sorted(found, key=lambda d: (d.span.file, d.span.line, d.span.column) if d.span else ("", 0, 0))


def one_is_ignored(one: Look, diagnostic: Diagnostic) -> bool:
    """Does its line say `# pylmp: ignore[CODE]`, or `# pylmp: ignore` for all codes?"""
    source = one.source(diagnostic.span) if diagnostic.span else ""
    _, mark, codes = source.partition("# pylmp: ignore")
    if not mark:
        return False
    inside = codes[1:].partition("]")[0] if codes.startswith("[") else ""
    return not inside or diagnostic.code in [code.strip() for code in inside.split(",")]
