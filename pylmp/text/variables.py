"""Variables: names with values, and the rules by which they are defined, advanced and read.

Source: LAMMPS manual, variable.html and next.html; rules as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.text.columns import Floats, evaluate_columns
from pylmp.text.diagnostic import ScriptError
from pylmp.text.evaluate import Scope, Value, evaluate
from pylmp.text.formula_error import FormulaError
from pylmp.text.number import shortest
from pylmp.text.printf import Format
from pylmp.text.variable_styles import ADVANCING, READERS, Variable, World
from pylmp.text.words import Args, Word

_NAME = re.compile("[A-Za-z0-9_]+")
_FORM = re.compile(r"[^%]*%[ 0]?\d*\.\d+[eEfFgG][^%]*")
_CONVERSION = re.compile(r"%[- 0]?\d*(\.\d*)?[eEfFgG]")
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
_ROOM = 63  # characters of a format-style variable
_DEEPEST = 100  # variables that refer to variables


class Variables:
    """All variables of a session; they outlive clear."""

    def __init__(self) -> None:
        self.known: dict[str, Variable] = {}
        self._evaluating: list[str] = []  # formulas in progress, each needed by the one before

    # ---- the commands variable and next, the switch -var ------------------------------------------------------

    def define(self, args: Args, substitute: Callable[[Word, bool], str], world: World) -> None:
        """The variable command; substitute(word, echo) replaces the references in a quoted word."""
        if len(args) < 2:
            args.missing()
        name, style = args.word(), args.word()
        if style.text == "delete":
            if len(args):
                text = f"Illegal variable delete command: expected 2 arguments but found {2 + len(args)}"
                args.fail(text, args.peek())
            self.forget(name.text)
            return
        reader = READERS.get(style.text)
        if reader is None:
            args.fail(f"Unknown variable style: {style.text}", style, hint=" ".join([*READERS, "delete"]))
        before = self.known.get(name.text)
        new = reader(args, style, substitute, world, before)
        if new is None:
            return  # the first definition stands
        if before is not None and before.style != new.style:
            text = f"Cannot redefine variable {name.text} with a different style"
            args.fail(text, style, hint=f"variable {name.text} delete first")
        if new.style == "format":
            self._source(name.text, new)
            if not _CONVERSION.fullmatch(new.values[1]):
                args.fail("Incorrect conversion in format string", args.words[-1], hint="one number, as in %.3f")
        elif new.style == "vector" and new.values[0].startswith("["):
            _literal(new.values[0])
        elif ADVANCING.get(new.style) == "universe":
            sizes = {one.size for one in self.known.values() if ADVANCING.get(one.style) == "universe"}
            if sizes - {new.size}:
                args.fail("All universe/uloop variables must have same # of values", name)
        if not _NAME.fullmatch(name.text):
            args.fail(f"Variable name '{name.text}' must have only letters, numbers, or underscores", name)
        self.known[name.text] = new

    def set_index(self, name: str, values: list[str]) -> None:
        """-var on the command line. Raises ScriptError."""
        if not _NAME.fullmatch(name):
            raise ScriptError(
                f"Variable name '{name}' must have only letters, numbers, or underscores", manual="Run_options.html"
            )
        self.known.setdefault(name, Variable("index", values))

    def forget(self, name: str) -> None:
        """Delete a variable, if there is one."""
        self.known.pop(name, None)

    def clear(self) -> None:
        """The clear command: values by atom ID go with the atoms."""
        for name in [name for name, variable in self.known.items() if variable.style == "atomfile"]:
            self.forget(name)

    def advance(self, args: Args, world: World) -> bool:
        """The next command; True when the values are used up: the variables are gone, and a jump is to be skipped."""
        args.need(1)
        words = args.rest()
        for word in words:
            variable = self.known.get(word.text)
            if variable is None:
                args.fail(f"Invalid variable '{word.text}' in next command", word)
            if variable.style not in ADVANCING:
                text = f"Variable {word.text} has invalid style {variable.style} for next command"
                args.fail(text, word, hint=f"these advance: {' '.join(ADVANCING)}")
        styles = {ADVANCING[self.known[word.text].style] for word in words}
        if len(styles) > 1:
            args.fail("All variables in next command must have same style", words[0])
        used_up = False
        if styles == {"universe"}:
            world.say(f"Increment via next: value {self.known[words[0].text].at + 2} on partition 0\n")
        for word in words:
            if word.text in self.known and not self.known[word.text].advance():
                self.forget(word.text)
                used_up = True
        return used_up

    # ---- what they are worth ----------------------------------------------------------------------------------

    def text(self, name: str, scope: Scope) -> str | None:
        """What ``${name}`` becomes; None if there is no such variable, or none that has a text."""
        variable = self.known.get(name)
        if variable is None or variable.style in ("atom", "atomfile"):
            return None
        if variable.style == "equal":
            variable.told = Format("%.15g")(self._number(name, scope))
        elif variable.style == "vector":
            variable.told = f"[{','.join(shortest(value) for value in self.vector(name, scope))}]"
        elif variable.style == "format":
            variable.told = self._formatted(name, variable, scope)
        elif variable.style == "getenv":
            variable.told = variable.text()
        else:
            return variable.text()
        return variable.told

    def _formatted(self, name: str, variable: Variable, scope: Scope) -> str:
        return Format(variable.values[1])(self.value(self._source(name, variable), scope))[:_ROOM]

    def _source(self, name: str, variable: Variable) -> str:
        """The variable that a format-style one shows."""
        other = variable.values[0]
        source = self.known.get(other)
        if source is None:
            raise ScriptError(f"Variable {name}: format variable {other} does not exist")
        if source.style not in ("equal", "timer", "internal"):
            raise ScriptError(f"Variable {name}: format variable {other} has incompatible style")
        return other

    def number(self, name: str, scope: Scope) -> float:
        """What ``v_name`` is worth in a formula: LAMMPS hands variables on as text of 15 digits. Raises ScriptError."""
        variable = self.known.get(name)
        if variable is None:
            known = " ".join(self.known)
            raise ScriptError(
                f"Invalid variable reference v_{name} in variable formula", manual="variable.html",
                hint=f"variables: {known}" if known else "no variable is defined",
            )  # fmt: skip
        if variable.style in ("timer", "internal"):
            return variable.number
        text = self.text(name, scope)
        if text is None or not _NUMBER.fullmatch(text):
            raise ScriptError(f"Variable {name}: Non-numeric variable value in variable formula")
        return float(text)

    def value(self, name: str, scope: Scope) -> float:
        """What an equal-style variable is worth, all digits: what fixes, computes and thermo columns read. Raises ScriptError."""
        variable = self.known[name]
        return self._number(name, scope) if variable.style == "equal" else variable.number

    def _number(self, name: str, scope: Scope) -> float:
        return float(self._evaluate(name, lambda text: evaluate(text, scope)))

    def per_atom(self, name: str, scope: Scope, rows: Any = None) -> Floats:
        """(n,) float64: what an atom-style variable is worth for each owned atom, or for rows only. Raises ScriptError."""
        variable = self.known[name]
        count = scope.count() if rows is None else len(rows)
        if variable.style == "atomfile":
            return scope.by_tag(variable.table) if rows is None else scope.by_tag(variable.table)[rows]
        values = self._evaluate(name, lambda text: evaluate_columns(text, scope, "atom", rows))
        return values if isinstance(values, np.ndarray) else np.full(count, values)

    def vector(self, name: str, scope: Scope) -> Floats:
        """(k,) float64: the elements of a vector-style variable. As in LAMMPS evaluated once a step. Raises ScriptError."""
        variable, step = self.known[name], scope.clock().step
        if variable.elements is not None and variable.step == step and len(variable.elements):
            return variable.elements
        text = variable.values[0]
        if text.startswith("["):
            values = _literal(text)
        else:
            values = self._evaluate(name, lambda text: evaluate_columns(text, scope, "vector"))
        if not isinstance(values, np.ndarray):
            raise ScriptError(f"Variable {name}: Vector-style variable has zero length", hint="it refers to no vector")
        variable.step, variable.elements = step, values
        return values

    def _evaluate(self, name: str, how: Callable[[str], Value]) -> Value:
        if name in self._evaluating:
            raise ScriptError(f"Variable {name}: has a circular dependency", manual="variable.html")
        if len(self._evaluating) >= _DEEPEST:
            raise ScriptError(f"Variable {name}: too many variables refer to each other", manual="variable.html")
        self._evaluating.append(name)
        try:
            return how(self.known[name].values[0])
        except FormulaError as error:
            raise _told(error, "" if error.plain else f"Variable {name}: ") from None
        finally:
            self._evaluating.pop()


def _literal(text: str) -> Floats:
    """``[1,2,3]``."""
    if not text.endswith("]"):
        raise ScriptError(f"Vector variable formula lacks opening or closing brace: {text}")
    words = Args("variable", [Word(part.strip()) for part in text[1:-1].split(",") if part.strip()])
    return np.array([words.number() for _ in range(len(words))])


def _told(error: FormulaError, prefix: str) -> ScriptError:
    told = ScriptError(f"{prefix}{error}", hint=error.hint, manual="variable.html")
    return told.inside(*error.place) if error.place else told


def immediate(text: str, scope: Scope) -> str:
    """``$(formula)`` or ``$(formula:%format)``. Raises ScriptError."""
    formula, form = text, "%.20g"
    colon = text.rfind(":%")
    if colon >= 0:
        formula, form = text[:colon], text[colon + 1 :]
        if (not form.startswith("%%") or form.startswith("%%%")) and not _FORM.fullmatch(form):
            raise ScriptError(
                "Incorrect conversion in format string", hint="a precision, as in %.3f", manual="Commands_parse.html"
            )
    try:
        value = evaluate(formula, scope)
    except FormulaError as error:
        raise _told(error, "") from None
    return Format(form)(value)
