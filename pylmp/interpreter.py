"""The interpreter: line by line, join, substitute, parse, dispatch."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from lark import Token, UnexpectedInput

from pylmp.model.registry import COMMANDS
from pylmp.model.simulation import Simulation
from pylmp.references import Scope
from pylmp.text.diagnostic import Diagnostic, ScriptError, Unsupported
from pylmp.text.grammar import command_names, command_parser
from pylmp.text.lines import Line, logical_lines
from pylmp.text.span import Span
from pylmp.text.substitute import substituted, without_comment
from pylmp.text.variables import Variables, immediate
from pylmp.text.words import Args, Word

_FIRST = re.compile(r"\s*(\S+)")
_DEEPEST = 16  # files that include files


@dataclass
class Script:
    """A file being executed: its logical lines, the next one, where its labels are."""

    name: str
    lines: list[Line]
    at: int = 0
    labels: dict[str, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for number, line in enumerate(self.lines):
            words = line.text.split("#")[0].split()
            if words[:1] == ["label"] and len(words) == 2:
                self.labels.setdefault(words[1], number)


class Interpreter:
    """Feeds commands to a simulation.

    variables   outlive clear
    allow       what an untrusted script may do: "write" outside the working directory, "read" too
    echo        where commands are repeated: "none", "screen", "log", "both"
    """

    def __init__(self, sim: Simulation, allow: Iterable[str] = ()) -> None:
        self.sim = sim
        sim.script = self
        self.variables = Variables()
        self.allow = frozenset(allow)
        self.echo = "log"
        self.scope = Scope(sim, self.variables)
        self._stack: list[Script] = []
        self._sources: dict[str, list[str]] = {}
        self._skip_jump = False

    # ---- files and flow -------------------------------------------------------------------------------------

    def run(self, text: str, name: str) -> None:
        """Execute a script to its end."""
        self._enter(self._script(text, name))

    def run_file(self, path: Path, span: Span | None = None) -> None:
        """Execute a file, also one that includes this one. Raises ScriptError if it cannot be read."""
        self._enter(self._script(read_script(path, span), str(path)))

    def _script(self, text: str, name: str) -> Script:
        self._sources[name] = text.split("\n")
        return Script(name, list(logical_lines(text, name)))

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
        script = self._stack[-1]
        if file != "SELF" and file != script.name:
            path = Path(file)
            script = self._stack[-1] = self._script(read_script(path, span), str(path))
        if label is None:
            script.at = 0
        elif label in script.labels:
            script.at = script.labels[label]
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
        """Execute one command given as text; its words stand where span is."""
        origin = (span.line, span.column, span.length) if span else (1, 1, None)
        name = span.file if span else "<command>"
        self.execute_line(Line(name, text, [0], [origin]))

    def execute_line(self, line: Line) -> None:
        """Echo, substitute, parse, carry out."""
        self._echo(line.text)
        line = self.substitute(without_comment(line), echo=True)
        first = _FIRST.match(line.text)
        if first is None:
            return
        owner = Word(first[1], line.span(first.start(1), len(first[1])))
        command = COMMANDS.find(owner.text) if owner.text in command_names() else None
        if command is None:
            self._unknown(line, owner)
        elif command.needs_box and not self.sim.has_box:
            raise ScriptError(
                f"{command.name.capitalize()} command before simulation box is defined", owner.span,
                hint="create_box or read_data comes first", manual=command.manual,
            )  # fmt: skip
        else:
            args = Args(command.name, words(line, owner.text), owner, command.manual)
            try:
                command.run(self.sim, args)
            except ScriptError as error:
                raise placed(error, owner) from None

    def substitute(self, line: Line, echo: bool = False) -> Line:
        """All references replaced; the log shows each step, as LAMMPS's does."""
        for line in substituted(line, self._lookup):
            if echo:
                self._echo(line.text)
        return line

    def substitute_text(self, word: Word) -> str:
        """The text of a word with its references replaced: what print and if do with quoted words."""
        span = word.span or Span("<command>", 1, 1)
        return self.substitute(Line(span.file, word.text, [0], [(span.line, span.column, span.length)])).text

    def _lookup(self, kind: str, inner: str, span: Span) -> str:
        try:
            if kind == "immediate":
                return immediate(inner, self.scope)
            value = self.variables.text(inner, self.scope)
        except ScriptError as error:
            raise placed(error, Word(inner, span)) from None
        if value is None:
            known = " ".join(self.variables.known)
            raise ScriptError(
                f"Substitution for illegal variable {inner}", span,
                hint=f"variables: {known}" if known else "no variable is defined", manual="variable.html",
            )  # fmt: skip
        return value

    def _echo(self, text: str) -> None:
        if self.echo in ("log", "both"):
            self.sim.console.log(text + "\n")
        if self.echo in ("screen", "both"):
            self.sim.console.screen(text + "\n")

    def _unknown(self, line: Line, owner: Word) -> None:
        if owner.text in ELSEWHERE:
            raise Unsupported(
                f"LAMMPS has the command {owner.text}, pylmp's native engines do not", owner.span,
                hint="--engine lammps runs this script on LAMMPS", manual=f"{owner.text}.html",
            )  # fmt: skip
        near = COMMANDS.near(owner.text)
        raise ScriptError(
            f"Unknown command: {line.text.strip()}", owner.span, manual="Commands_all.html",
            hint=f"did you mean {near}?" if near else "",
        )  # fmt: skip


# Commands of LAMMPS that pylmp lacks: known, not misspelled.
ELSEWHERE = frozenset(
    """angle_coeff angle_style angle_write balance bond_write change_box comm_style compute_modify create_box2 delete_atoms dielectric
    dihedral_coeff dihedral_style dihedral_write dump2vtk dynamical_matrix fix_modify geturl group2ndx improper_coeff improper_style
    info kim kspace_modify kspace_style labelmap mdi min_modify min_style minimize minimize/kk molecule neb ndx2group package
    pair_write partition plugin prd processors python read_dump read_restart replicate rerun reset_atoms restart run_style shell
    suffix tad temper thermo_log third_order timer write_coeff write_restart""".split()
)


def read_script(path: Path, span: Span | None = None) -> str:
    """The text of a script. Raises ScriptError if there is no such file or it is not text."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ScriptError(f"Cannot open input script {path}: {error.strerror}", span, hint="the path is relative to the working directory") from None
    if b"\0" in data or data.startswith((b"{\\rtf", b"%PDF", b"\xff\xfe", b"PK")):
        raise ScriptError(f"Input script {path} is not a text file", span, hint="save it as plain text (UTF-8)")
    try:
        return data.decode()
    except UnicodeDecodeError:
        return data.decode("latin-1")


def words(line: Line, name: str) -> list[Word]:
    """The words after the command's name, quotes removed, by the command's own rule. Raises ScriptError."""
    try:
        tree = command_parser(name).parse(line.text)
    except UnexpectedInput as error:
        at = error.pos_in_stream if error.pos_in_stream is not None else 0
        raise ScriptError(
            f"Illegal {name} command", line.span(max(at, 0), 1), hint="a quoted word ends at its closing quote", manual=f"{name}.html"
        ) from None
    found = []
    for token in tree.scan_values(lambda value: isinstance(value, Token)):
        start, text = token.start_pos or 0, str(token)
        quotes = 3 if text.startswith('"""') else 1 if token.type == "QUOTED" else 0
        inner = text[quotes : len(text) - quotes]
        found.append(Word(inner, line.span(start + quotes, max(1, len(inner))), quotes > 0))
    return found


def placed(error: ScriptError, owner: Word) -> ScriptError:
    """The same error, standing where its command stands unless it knows better."""
    d = error.diagnostic
    if d.span is None:
        error.diagnostic = Diagnostic(d.message, owner.span, d.hint, d.code, d.manual, d.severity)
    return error


def run_text(sim: Simulation, text: str, name: str = "<script>") -> None:
    """Execute a script given as text: the short way in for programs."""
    Interpreter(sim).run(text, name)


