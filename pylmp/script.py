"""A script as the interpreter reads it: the lines of a file, the words of a line, its command."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple, NoReturn

from pylmp.model.registry import COMMANDS, Command
from pylmp.text.diagnostic import ScriptError
from pylmp.text.grammar import Rejection, check, rules
from pylmp.text.lines import Text, decode
from pylmp.text.span import Span
from pylmp.text.substitute import split, substitute, varies
from pylmp.text.words import Args, Word


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


def prepare(words: list[Word]) -> Ready:
    if not words:
        return Ready(words, None, None)
    name = words[0].text
    command = COMMANDS.find(name) if name in rules() else None
    return Ready(words, command, check(words) if command is not None else None)


@lru_cache(4096)
def ready_line(line: Text) -> Ready | None:
    """A line in which nothing is to be replaced, read once; None for others."""
    if not line.text.isascii() or varies(line):
        return None
    return prepare(split(substitute(line, _no_lookup)))


def _no_lookup(key: str, is_formula: bool) -> str:
    raise AssertionError(key)


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
