"""The interpreter: line by line, join, substitute, parse, dispatch."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import NoReturn

from pylmp.kernels import disk
from pylmp.model.limits import JUMPS
from pylmp.model.paths import readable
from pylmp.model.registry import COMMANDS
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import is_elsewhere, unsupported
from pylmp.references.scope import Scope
from pylmp.script import Ready, Script, complain, inside, prepare, read_script, ready_line
from pylmp.survey import Missing, survey
from pylmp.text import grammar
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.lines import Text, as_ascii, logical_lines, plain
from pylmp.text.span import Span
from pylmp.text.substitute import split, substitute, substitute_word
from pylmp.text.variables import Variables, immediate
from pylmp.text.words import Args, Word

grammar.store = disk  # parser tables are kept where machine code is
_DEEPEST = 16  # files that include files
_RUNS = ("run", "minimize")
_STEERING = {"jump", "label", "if", "next", "variable", "print", "log", "echo", "info"}  # what loops are made of


class Interpreter:
    """Feeds commands to a simulation.

    variables   outlive clear
    allow       what an untrusted script may do: PERMISSIONS of model/paths.py
    folders     below which it may read: the working directory, then the script's own
    echo        where commands are repeated: "none", "screen", "log", "both"
    most        commands that may be carried out, None: any number
    jumps       how often it may jump in a row with nothing but _STEERING in between, None: as often as it likes
    """

    def __init__(
        self, sim: Simulation, allow: Iterable[str] = (), most: int | None = None, jumps: int | None = JUMPS
    ) -> None:  # fmt: skip
        self.sim = sim
        sim.script = self
        self.variables = Variables()
        self.allow = frozenset(allow)
        self.folders = [Path.cwd().resolve()]
        self.echo = "log"
        self.most = most
        self.jumps = jumps
        self.dry = False  # nothing is written: the script is only looked at
        self.writes: list[str] = []  # what it would write, where it is dry
        self.count = 0  # commands carried out
        self._idle = 0  # jumps since something else than variables changed
        self.scope = Scope(sim, self.variables)
        self._stack: list[Script] = []
        self._sources: dict[str, list[str]] = {}
        self._line = plain("")  # being carried out
        self._skip_jump = False
        self._warned = self._surveyed = False

    # ---- files and flow -------------------------------------------------------------------------------------

    def run(self, text: str, name: str) -> None:
        """Execute a script to its end."""
        self._enter(self._script(text, name))

    def run_main(self, path: Path) -> None:
        """Execute the file that was asked for; it may read what stands beside it. Raises ScriptError as run_file does."""
        self.folders.append(path.resolve().parent)
        self.run_file(path)

    def run_file(self, path: Path, span: Span | None = None) -> None:
        """Execute a file, also one that includes this one. Raises ScriptError if it cannot be read."""
        self._enter(self._script(read_script(path, span), str(path)))

    def _script(self, text: str, name: str) -> Script:
        self._sources[name] = text.split("\n")
        return Script(name, logical_lines(text, name))

    def _enter(self, script: Script) -> None:
        if len(self._stack) >= _DEEPEST:
            raise ScriptError("Too many nested levels of input scripts", hint="a file that includes itself?")
        depth = len(self._stack)
        self._stack.append(script)
        while self._stack[depth].at < len(self._stack[depth].lines):
            current = self._stack[depth]
            line = current.lines[current.at]
            current.at += 1
            self.execute_line(line)
        self._stack.pop()

    def jump(self, file: str, label: str | None, span: Span | None) -> None:
        """Go on in a file (SELF: this one) from its start or from a label."""
        if self._skip_jump:
            self._skip_jump = False
            return
        self._idle += 1
        if self.jumps is not None and self._idle > self.jumps:
            raise ScriptError(
                f"The script jumped {self.jumps} times and changed nothing but variables", span, code="S108", manual="jump.html",
                hint="a loop without end? --max-jumps N lets it jump more often, --trust as often as it likes",
            )  # fmt: skip
        script = self._stack[-1]
        if file != "SELF" and file != script.name:
            path = readable(self.sim, Word(file, span))
            script = self._stack[-1] = self._script(read_script(path, span), str(path))
        if label is None:
            script.at = 0
        elif label in script.labels:
            script.at = script.labels[label] + 1
        else:
            near = f"labels here: {' '.join(script.labels)}" if script.labels else "this file has no labels"
            raise ScriptError("Label wasn't found in input script", span, hint=near, manual="label.html")

    def skip_next_jump(self) -> None:
        """A loop is over: the next jump command does nothing."""
        self._skip_jump = True

    def source(self, span: Span) -> str:
        """The physical line a span stands on."""
        lines = self._sources.get(span.file, [])
        return lines[span.line - 1] if 0 < span.line <= len(lines) else ""

    # ---- one line -------------------------------------------------------------------------------------------

    def execute(self, text: str, span: Span | None = None) -> None:
        """Execute one command given as text that stands at span."""
        self.execute_line(plain(text, span))

    def execute_word(self, word: Word) -> None:
        """Execute the command that a quoted word holds."""
        self.execute_line(plain(word.text, inside(word)))

    def execute_line(self, line: Text) -> None:
        """Echo, substitute, split, check the shape, carry out."""
        self._echo(line.text)
        self._line = line
        ready = ready_line(line)
        if ready is None:
            text = line if line.text.isascii() else self._as_ascii(line)
            ready = prepare(split(substitute(text, self._lookup, self._echo)))
        if ready.words:
            self._carry_out(ready, line.text)

    def execute_rest(self, word: Word) -> None:
        """Execute the line in progress from where a word's text first stands in it: as LAMMPS does it for partition."""
        start = self._line.text.find(word.text)
        if start < 1:  # LAMMPS dies of these
            raise ScriptError(f"No command starts with {word.text} on this line", word.span, hint="the command as plain words", code="S106")
        self.execute_line(self._line.tail(start))

    def _carry_out(self, ready: Ready, typed: str) -> None:
        owner, command = ready.words[0], ready.command
        self.count += 1
        if self.most is not None and self.count > self.most:
            hint = "a loop without end? --max-commands sets the limit"
            raise ScriptError(f"The script was stopped after {self.most} commands", owner.span, hint=hint, code="S104")
        if command is None:
            self._unknown(typed, owner)
        if command.name not in _STEERING:
            self._idle = 0
        if command.needs_box and not self.sim.has_box:
            raise ScriptError(
                f"{command.name.capitalize()} command before simulation box is defined", owner.span,
                hint="create_box or read_data comes first", manual=command.manual,
            )  # fmt: skip
        if command.name in _RUNS and not self._surveyed:
            self._survey(owner)
        args = Args(command.name, ready.words[1:], owner, command.manual)
        try:
            command.run(self.sim, args)  # of a line with the wrong shape it says what LAMMPS says
        except Unsupported as error:
            raise self._with_others(error.at(owner.span)) from None
        except ScriptError as error:
            raise error.at(owner.span) from None
        except MemoryError:
            raise ScriptError("There is not enough memory for this", owner.span, hint="fewer atoms, or smaller tables", code="S109") from None
        except BrokenPipeError:
            raise
        except OSError as error:
            name = f" {error.filename}" if error.filename else ""
            raise ScriptError(f"Cannot use file{name}: {error.strerror or error}", owner.span, code="S111") from None
        self.sim.interrupts.obey()
        if ready.rejection is not None:
            complain(ready.rejection, args)

    # ---- what only LAMMPS can do ------------------------------------------------------------------------------

    def _missing(self) -> list[Missing]:
        """What only LAMMPS has in the lines to come."""
        ahead = (line for script in reversed(self._stack) for line in script.lines[script.at :])
        return survey(ahead, self._peek)

    def _peek(self, path: Path) -> list[Text] | None:
        try:
            return self._script(read_script(readable(self.sim, Word(str(path)))), str(path)).lines
        except ScriptError:
            return None

    def _survey(self, owner: Word) -> None:
        """Before the first step: a script that cannot be carried out to its end is not begun."""
        self._surveyed = True
        missing = self._missing()
        certain = [one for one in missing if not one.doubtful]
        if certain:
            first, *others = certain
            text = f"LAMMPS has {first.what}, pylmp's native engines do not"
            hint = "no step was made; --engine lammps runs this script on LAMMPS"
            raise Unsupported(text, first.span, hint=hint).along((one.span, one.what) for one in others)
        for one in missing:
            self.sim.console.warning(f"{one.span}: LAMMPS has {one.what}, pylmp's native engines do not: the script ends there")

    def _with_others(self, error: Unsupported) -> Unsupported:
        """An error, with what else only LAMMPS has further on."""
        error.along((one.span, one.what) for one in self._missing() if not one.doubtful)
        return error

    def substitute_text(self, word: Word, echo: bool = False) -> str:
        """The text of a word with its references replaced: what print, if and string variables do with quoted words."""
        if not echo:
            return substitute_word(word.text, self._lookup, lambda: plain(word.text, inside(word)))
        return substitute(plain(word.text, inside(word)), self._lookup, self._echo, "inner").text

    def _lookup(self, key: str, is_formula: bool) -> str:
        if is_formula:
            return immediate(key, self.scope)
        value = self.variables.text(key, self.scope)
        if value is None:
            known = " ".join(self.variables.known)
            raise ScriptError(
                f"Substitution for illegal variable {key}", manual="variable.html",
                hint=f"variables: {known}" if known else "no variable is defined",
            )  # fmt: skip
        return value

    def _as_ascii(self, line: Text) -> Text:
        if not self._warned:
            self._warned = True
            self.sim.console.warning(
                "Detected non-ASCII characters in input. Will try to continue by replacing with ASCII equivalents where known."
            )
        return as_ascii(line)

    def _echo(self, text: str) -> None:
        if self.echo in ("log", "both"):
            self.sim.console.log(text + "\n")
        if self.echo in ("screen", "both"):
            self.sim.console.screen(text + "\n")

    def _unknown(self, typed: str, owner: Word) -> NoReturn:
        if is_elsewhere("command", owner.text):
            raise self._with_others(unsupported("command", owner))
        near = COMMANDS.near(owner.text)
        raise ScriptError(
            f"Unknown command: {typed}", owner.span, manual="Commands_all.html",
            hint=f"did you mean {near}?" if near else "",
        )  # fmt: skip


def run_text(sim: Simulation, text: str, name: str = "<script>", allow: Iterable[str] = ()) -> None:
    """Execute a script given as text: the short way in for programs."""
    Interpreter(sim, allow).run(text, name)
