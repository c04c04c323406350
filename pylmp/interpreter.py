"""The interpreter: line by line, join, substitute, parse, dispatch."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple, NoReturn

from pylmp.kernels import disk
from pylmp.model.registry import COMMANDS, Command
from pylmp.model.simulation import Simulation
from pylmp.references.scope import Scope
from pylmp.text import grammar
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.grammar import Rejection, check, rules
from pylmp.text.lines import Text, as_ascii, decode, logical_lines, plain
from pylmp.text.span import Span
from pylmp.text.substitute import split, substitute, substitute_word, varies
from pylmp.text.variables import Variables, immediate
from pylmp.text.words import Args, Word

grammar.store = disk  # parser tables are kept where machine code is
_DEEPEST = 16  # files that include files


@dataclass
class Script:
    """A file being executed: its logical lines, the next one, where its labels are."""

    name: str
    lines: list[Text]
    at: int = 0
    labels: dict[str, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for number, line in enumerate(self.lines):
            words = line.text.split("#")[0].split()
            if words[:1] == ["label"] and len(words) == 2:
                self.labels.setdefault(words[1], number)


class Ready(NamedTuple):
    """The words of a line whose variables are replaced, its command (None: no such), and what its shape lacks."""

    words: list[Word]
    command: Command | None
    rejection: Rejection | None


def _prepare(words: list[Word]) -> Ready:
    if not words:
        return Ready(words, None, None)
    name = words[0].text
    command = COMMANDS.find(name) if name in rules() else None
    return Ready(words, command, check(words) if command is not None else None)


@lru_cache(4096)
def _ready(line: Text) -> Ready | None:
    """A line in which nothing is to be replaced, read once; None for others."""
    if not line.text.isascii() or varies(line):
        return None
    return _prepare(split(substitute(line, _no_lookup)))


def _no_lookup(key: str, is_formula: bool) -> str:
    raise AssertionError(key)


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
        self._warned = False

    # ---- files and flow -------------------------------------------------------------------------------------

    def run(self, text: str, name: str) -> None:
        """Execute a script to its end."""
        self._enter(self._script(text, name))

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
        script = self._stack[-1]
        if file != "SELF" and file != script.name:
            path = Path(file)
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
        ready = _ready(line)
        if ready is None:
            text = line if line.text.isascii() else self._as_ascii(line)
            ready = _prepare(split(substitute(text, self._lookup, self._echo)))
        if ready.words:
            self._carry_out(ready, line.text)

    def execute_words(self, words: Sequence[Word]) -> None:
        """Execute one command given as words, variables replaced."""
        self._carry_out(_prepare(list(words)), " ".join(word.text for word in words))

    def _carry_out(self, ready: Ready, typed: str) -> None:
        owner, command = ready.words[0], ready.command
        if command is None:
            self._unknown(typed, owner)
        if command.needs_box and not self.sim.has_box:
            raise ScriptError(
                f"{command.name.capitalize()} command before simulation box is defined", owner.span,
                hint="create_box or read_data comes first", manual=command.manual,
            )  # fmt: skip
        args = Args(command.name, ready.words[1:], owner, command.manual)
        try:
            command.run(self.sim, args)  # of a line with the wrong shape it says what LAMMPS says
        except ScriptError as error:
            raise error.at(owner.span) from None
        if ready.rejection is not None:
            complain(ready.rejection, args)

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
        if owner.text in ELSEWHERE:
            raise Unsupported(
                f"LAMMPS has the command {owner.text}, pylmp's native engines do not", owner.span,
                hint="--engine lammps runs this script on LAMMPS", manual=f"{owner.text}.html",
            )  # fmt: skip
        near = COMMANDS.near(owner.text)
        raise ScriptError(
            f"Unknown command: {typed}", owner.span, manual="Commands_all.html",
            hint=f"did you mean {near}?" if near else "",
        )  # fmt: skip


# Commands of LAMMPS that pylmp lacks: known, not misspelled.
ELSEWHERE = frozenset(
    {
        "angle_write", "bond_write",
        "dihedral_write", "dump2vtk",
        "dynamical_matrix", "geturl", "group2ndx", "kim",
        "mdi", "molecule", "neb",
        "ndx2group", "pair_write", "plugin", "prd", "python",
        "rerun", "tad", "temper",
        "thermo_log", "third_order", "write_coeff",
    }
)  # fmt: skip


def read_script(path: Path, span: Span | None = None) -> str:
    """The text of a script. Raises ScriptError if there is no such file or it is not text."""
    try:
        data = path.read_bytes()
    except OSError as error:
        raise ScriptError(
            f"Cannot open input script {path}: {error.strerror}",
            span,
            hint="the path is relative to the working directory",
        ) from None
    return decode(data, str(path))


def complain(rejection: Rejection, args: Args) -> NoReturn:
    """What the grammar alone can say about a line of the wrong shape."""
    if rejection.at is None or rejection.at == 0:
        args.missing(hint=f"here may stand: {' '.join(rejection.expected)}")
    word = args.words[rejection.at - 1]
    if "number" in rejection.expected:
        args.as_number(word)
    if "integer" in rejection.expected:
        args.as_integer(word)
    args.illegal(
        word, hint=f"here may stand: {' '.join(rejection.expected)}" if rejection.expected else "nothing follows here"
    )


def inside(word: Word) -> Span | None:
    """Where the text of a quoted word begins, its quotes left out."""
    span = word.span
    if span is None or not word.quoted:
        return span
    quotes = 3 if span.length - len(word.text) == 6 else 1
    return Span(span.file, span.line, span.column + quotes, span.length)


def run_text(sim: Simulation, text: str, name: str = "<script>") -> None:
    """Execute a script given as text: the short way in for programs."""
    Interpreter(sim).run(text, name)
