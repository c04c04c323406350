"""The styles of variables: how each reads its arguments, what it holds and how it advances.

Source: LAMMPS manual, variable.html; rules as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any, Protocol

from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

FORMULAS = ("equal", "vector", "atom")  # their one value is a formula
# Those that advance, and what LAMMPS calls the same style when several advance together.
ADVANCING = {
    "index": "index", "loop": "loop", "file": "file", "atomfile": "atomfile", "universe": "universe", "uloop": "universe",
}  # fmt: skip


class World(Protocol):
    """What variables need from outside. Each raises ScriptError with LAMMPS's sentence."""

    def lines(self, path: Word, what: str) -> list[str]: ...
    def atom_sets(self, name: str, path: Word, lines: list[str]) -> Iterator[Any]: ...
    def environment(self, key: Word) -> Callable[[], str]: ...
    def say(self, text: str) -> None: ...


@dataclass
class Variable:
    """One variable.

    values   index, world, universe: their strings; formulas, string: one text; format: a name and a format; file: its lines
    at       which of the values is the current one; loop, uloop: counted from first to last
    width    digits of a padded loop
    number   timer, internal
    table    atomfile: (IDs, values) of the current set; sets: the further ones
    look     getenv: reads the environment
    told     the last text of equal, vector, format, getenv
    step, elements   vector: the step of its last evaluation, and what came out
    """

    style: str
    values: list[str] = field(default_factory=list)
    at: int = 0
    first: int = 1
    last: int = 0
    width: int = 0
    number: float = 0.0
    table: Any = None
    sets: Iterator[Any] = iter(())
    look: Callable[[], str] | None = None
    told: str | None = None
    step: int = -1
    elements: Any = None

    @property
    def size(self) -> int:
        """How many values a universe or uloop variable has."""
        return len(self.values) or self.last

    def text(self) -> str:
        """The current value of the styles that are no formula."""
        if self.style in ("loop", "uloop"):
            return str(self.first + self.at).zfill(self.width)
        if self.style in ("timer", "internal"):
            return f"{self.number:.15g}"
        return self.look() if self.look is not None else self.values[self.at]

    def advance(self) -> bool:
        """Go to the next value; False if there is none."""
        if self.style == "atomfile":
            self.table = next(self.sets, None)
            return self.table is not None
        self.at += 1
        if self.style in ("loop", "uloop"):
            return self.first + self.at <= self.last
        return self.at < len(self.values)


Substitute = Callable[[Word, bool], str]
Reader = Callable[[Args, Word, Substitute, World, Variable | None], Variable | None]


def _expect(args: Args, style: Word, low: int, high: int, wording: str) -> None:
    """As Args.expect; the name and the style count."""
    if not low <= len(args) <= high:
        culprit = args.words[args.at + high] if len(args) > high else style
        text = f"Illegal variable command: expected {wording} but found {2 + len(args)}"
        args.fail(text, culprit, hint="quote the text" if style.text == "string" else "")


def _some(args: Args, style: Word) -> None:
    if not len(args):
        args.fail(f"Illegal variable {style.text} command: missing argument(s)", style)


def _index(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable | None:
    _some(args, style)
    if before is not None:
        return None
    values = [word.text for word in args.rest()]
    if style.text == "world" and len(values) != 1:
        args.fail(f"World variable count {len(values)} doesn't match # of partitions 1", style, hint="there is one partition")
    return Variable(style.text, values)


def _loop(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable | None:
    _some(args, style)
    if before is not None:
        return None
    words = args.rest()
    pad = len(words) > 1 and words[-1].text == "pad"
    numbers = words[:-1] if pad else words
    if not 1 <= len(numbers) <= 2:
        args.fail("Illegal variable loop command: too many arguments", words[-1])
    values = [args.as_integer(word) for word in numbers]
    first, last = (1, values[0]) if len(values) == 1 else (values[0], values[1])
    if len(values) == 1 and last <= 0:
        args.fail(f"Invalid variable loop argument: {last}", numbers[0], hint="a positive number")
    if first > last:
        args.fail(f"Illegal variable loop command: {first} > {last}", numbers[0])
    return Variable("loop", first=first, last=last, width=len(str(last)) if pad else 0)


def _uloop(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable | None:
    _expect(args, style, 1, 2, "3 or 4 arguments")
    if before is not None:
        return None
    count = args.word()
    last = args.as_integer(count)
    pad = args.peek()
    if pad is not None and pad.text != "pad":
        args.fail(f"Invalid variable uloop argument: {pad.text}", pad, hint="pad")
    if last < 1:
        args.fail(f"Universe/uloop variable count {last} < # of partitions 1", count, hint="a positive number")
    return Variable("uloop", last=last, width=len(str(last)) if pad else 0)


def _string(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable:
    _expect(args, style, 1, 1, "3 arguments")
    return Variable("string", [substitute(args.word(), True)])


def _getenv(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable:
    _expect(args, style, 1, 1, "3 arguments")
    return Variable("getenv", [args.words[args.at].text], look=world.environment(args.word()))


def _file(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable | None:
    _expect(args, style, 1, 1, "3 arguments")
    if before is not None:
        return None
    name, path = args.words[0].text, args.word()
    lines = world.lines(path, f"{style.text} variable {name} file")
    if style.text == "file":
        values = [text for line in lines if (text := line.split("#")[0].strip())]
        if not values:
            args.fail(f"File variable {name} could not read value from {path.text}", path)
        return Variable("file", values)
    sets = world.atom_sets(name, path, lines)
    return Variable("atomfile", table=next(sets), sets=sets)


def _format(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable:
    _expect(args, style, 2, 2, "4 arguments")
    return Variable("format", [word.text for word in args.rest()])


def _timer(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable:
    _expect(args, style, 0, 0, "2 arguments")
    return Variable("timer", number=time.time())


def _internal(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable:
    _expect(args, style, 1, 1, "3 arguments")
    return Variable("internal", number=args.number())


def _formula(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable:
    _some(args, style)
    return Variable(style.text, [" ".join(word.text for word in args.rest())])


def _python(args: Args, style: Word, substitute: Substitute, world: World, before: Variable | None) -> Variable:
    _expect(args, style, 1, 1, "3 arguments")
    raise Unsupported(
        "LAMMPS has variable style python, pylmp's native engines do not", style.span,
        hint="scripts run no Python code", manual="variable.html",
    )  # fmt: skip


READERS: dict[str, Reader] = {
    "index": _index, "world": _index, "universe": _index, "loop": _loop, "uloop": _uloop, "string": _string, "getenv": _getenv,
    "file": _file, "atomfile": _file, "format": _format, "timer": _timer, "internal": _internal, "equal": _formula,
    "vector": _formula, "atom": _formula, "python": _python,
}  # fmt: skip
