"""Variables: names with values, and the rules by which they are defined, advanced and read.

Source: LAMMPS manual, variable.html and next.html; rules as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field

from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.formula import Scope, evaluate
from pylmp.text.functions import FormulaError
from pylmp.text.printf import Format
from pylmp.text.words import Args, Word

_ELSEWHERE = (
    "world", "universe", "uloop", "getenv", "file", "atomfile", "format", "python", "timer", "internal", "atom", "vector",
)  # fmt: skip
_ADVANCING = ("index", "loop")
_NAME = re.compile("[A-Za-z0-9_]+")
_FORM = re.compile(r"[^%]*%[-+ #0]*\d*\.\d+[eEfFgG][^%]*")
_DEEPEST = 100  # variables that refer to variables


@dataclass
class Variable:
    """values: index: its strings; loop: nothing, first..last are numbers; string and equal: one text."""

    style: str
    values: list[str] = field(default_factory=list)
    at: int = 0
    first: int = 1
    last: int = 1
    width: int = 0

    @property
    def size(self) -> int:
        """How many values an index or loop variable has."""
        return len(self.values) if self.style == "index" else self.last - self.first + 1

    def text(self) -> str:
        """The current value of index, loop and string variables."""
        if self.style == "loop":
            return str(self.first + self.at).zfill(self.width)
        return self.values[self.at]


class Variables:
    """All variables of a session; they outlive clear."""

    def __init__(self) -> None:
        self.known: dict[str, Variable] = {}
        self._evaluating: list[str] = []  # equal-style variables, each needed by the one before

    def define(self, args: Args, substitute: Callable[[Word, bool], str]) -> None:
        """The variable command; substitute(word, echo) replaces the references in a quoted word."""
        if len(args) < 2:
            args.missing()
        name, style = args.word(), args.word()
        if style.text == "delete":
            if len(args):
                args.fail(
                    f"Illegal variable delete command: expected 2 arguments but found {2 + len(args)}", args.peek()
                )
            self.known.pop(name.text, None)
            return
        if not _NAME.fullmatch(name.text):
            args.fail(f"Variable name '{name.text}' must have only letters, numbers, or underscores", name)
        if style.text in _ELSEWHERE:
            raise Unsupported(
                f"LAMMPS has variable style {style.text}, pylmp's native engines do not",
                style.span,
                manual="variable.html",
            )
        if style.text not in (*_ADVANCING, "string", "equal"):
            args.fail(f"Unknown variable style: {style.text}", style, hint="index loop string equal delete")
        if style.text == "string" and len(args) != 1:
            culprit = args.words[args.at + 1] if len(args) else style
            args.fail(
                f"Illegal variable command: expected 3 arguments but found {2 + len(args)}",
                culprit,
                hint="quote the text",
            )
        if not len(args):
            args.fail(f"Illegal variable {style.text} command: missing argument(s)", style)
        before = self.known.get(name.text)
        if style.text in _ADVANCING:
            if before is None:
                self.known[name.text] = self._loop(args) if style.text == "loop" else self._index(args)
            return
        if before is not None and before.style != style.text:
            args.fail(
                f"Cannot redefine variable {name.text} with a different style",
                style,
                hint=f"variable {name.text} delete first",
            )
        text = substitute(args.word(), True) if style.text == "string" else " ".join(word.text for word in args.rest())
        self.known[name.text] = Variable(style.text, [text])

    def set_index(self, name: str, values: list[str]) -> None:
        """-var on the command line. Raises ScriptError."""
        if not _NAME.fullmatch(name):
            raise ScriptError(
                f"Variable name '{name}' must have only letters, numbers, or underscores", manual="Run_options.html"
            )
        self.known.setdefault(name, Variable("index", values))

    @staticmethod
    def _index(args: Args) -> Variable:
        return Variable("index", [word.text for word in args.rest()])

    @staticmethod
    def _loop(args: Args) -> Variable:
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

    def advance(self, args: Args) -> bool:
        """The next command; True when the values are used up: the variables are gone, and a jump is to be skipped."""
        args.need(1)
        words = args.rest()
        for word in words:
            variable = self.known.get(word.text)
            if variable is None:
                args.fail(f"Invalid variable '{word.text}' in next command", word)
            if variable.style not in _ADVANCING:
                args.fail(
                    f"Variable {word.text} has invalid style {variable.style} for next command", word,
                    hint="index and loop variables advance",
                )  # fmt: skip
        if len({self.known[word.text].style for word in words}) > 1:
            args.fail("All variables in next command must have same style", words[0])
        used_up = False
        for name in dict.fromkeys(word.text for word in words):
            variable = self.known[name]
            variable.at += 1
            if variable.at >= variable.size:
                del self.known[name]
                used_up = True
        return used_up

    def text(self, name: str, scope: Scope) -> str | None:
        """What ``${name}`` becomes; None if there is no such variable."""
        variable = self.known.get(name)
        if variable is None:
            return None
        if variable.style == "equal":
            return Format("%.15g")(self._evaluate(name, scope))
        return variable.text()

    def number(self, name: str, scope: Scope) -> float:
        """What ``v_name`` is worth in a formula: LAMMPS hands variables on as text of 15 digits. Raises ScriptError."""
        variable = self.known.get(name)
        if variable is None:
            known = " ".join(self.known)
            raise ScriptError(
                f"Invalid variable reference v_{name} in variable formula", manual="variable.html",
                hint=f"variables: {known}" if known else "no variable is defined",
            )  # fmt: skip
        if variable.style == "equal":
            return float(f"{self._evaluate(name, scope):.15g}")
        try:
            return float(variable.text())
        except ValueError:
            raise ScriptError(f"Variable {name}: Non-numeric variable value in variable formula") from None

    def value(self, name: str, scope: Scope) -> float:
        """What an equal-style variable is worth, all digits: what fixes, computes and thermo columns read. Raises ScriptError."""
        return self._evaluate(name, scope)

    def _evaluate(self, name: str, scope: Scope) -> float:
        if name in self._evaluating:
            raise ScriptError(f"Variable {name}: has a circular dependency", manual="variable.html")
        if len(self._evaluating) >= _DEEPEST:
            raise ScriptError(f"Variable {name}: too many variables refer to each other", manual="variable.html")
        self._evaluating.append(name)
        try:
            return evaluate(self.known[name].values[0], scope)
        except FormulaError as error:
            raise ScriptError(f"Variable {name}: {error}", manual="variable.html") from None
        finally:
            self._evaluating.pop()


def immediate(text: str, scope: Scope) -> str:
    """``$(formula)`` or ``$(formula:%format)``. Raises ScriptError."""
    formula, form = text, "%.20g"
    colon = text.rfind(":%")
    if colon >= 0:
        formula, form = text[:colon], text[colon + 1 :]
        if not form.startswith("%%") and not _FORM.fullmatch(form):
            raise ScriptError(
                "Incorrect conversion in format string", hint="a precision, as in %.3f", manual="Commands_parse.html"
            )
    try:
        value = evaluate(formula, scope)
    except FormulaError as error:
        raise ScriptError(str(error), manual="variable.html") from None
    return Format(form)(value)
