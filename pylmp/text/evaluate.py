"""Evaluation of formulas to one number, as equal-style variables and ``$(...)`` need it."""

from __future__ import annotations

import math
import re
from typing import Any, Protocol

from pylmp.text.diagnostic import ScriptError
from pylmp.text.formula import Step, number, program
from pylmp.text.formula_error import MATH, FormulaError
from pylmp.text.functions import FUNCTIONS, compare, modulo, power
from pylmp.text.timed import Clock

VERSION = 20250722.0
_CONSTANTS = {
    "PI": math.pi, "version": VERSION, "yes": 1.0, "on": 1.0, "true": 1.0, "no": 0.0, "off": 0.0, "false": 0.0,
}  # fmt: skip
_ATOM_VECTORS = frozenset("id mass type mol radius q x y z vx vy vz fx fy fz".split())
_CUSTOM = re.compile(r"[id]2?_\w+")
_WHOLE = re.compile(r"\s*[-+]?\d+")

_MOST_VALUES = 6  # of a function
_STATED = ("vdisplace", "swiggle", "cwiggle")  # LAMMPS says how many values they take

Value = Any  # float, or a numpy array of float64: one for each atom, or the elements of a vector


class Scope(Protocol):
    """What a formula may refer to. mode: the style of the formula, equal, vector or atom. rows: the atoms wanted, None: all.

    Each raises ScriptError or FormulaError with LAMMPS's sentence.
    """

    def need_box(self) -> None: ...
    def need_variable(self, name: str) -> None: ...
    def variable(self, name: str, index: tuple[int, ...], mode: str, rows: Any) -> Value: ...
    def variable_text(self, name: str) -> str: ...
    def measured(self, kind: str, name: str, index: tuple[int, ...], mode: str) -> Value: ...
    def keyword(self, name: str) -> float: ...
    def atom(self, name: str, tag: int) -> float: ...
    def atoms(self, name: str) -> Value: ...
    def named(self, function: str, names: tuple[str, ...], mode: str) -> Value: ...
    def random(self, seed: float, mode: str) -> Any: ...
    def clock(self) -> Clock: ...
    def of_c(self, function: str, *values: Any) -> Any: ...
    def count(self) -> int: ...
    def by_tag(self, table: Any) -> Any: ...
    def formula(self, name: str) -> str | None: ...


class Evaluator:
    """A stack, and what each kind of step does to it."""

    mode = "equal"
    rows: Any = None  # all atoms

    def __init__(self, scope: Scope) -> None:
        self.scope = scope
        self.stack: list[Value] = []

    def run(self, text: str) -> Value:
        """The value of a formula. Raises FormulaError or ScriptError that know their place in it."""
        stack, at = self.stack, 0
        steps, numbers = program(text)
        step = steps[0]
        try:
            while at < len(steps):
                step = steps[at]
                at += 1
                kind = step.kind
                if kind in ("else", "goto", "mark", "lazy"):
                    at = self.direct(step, at)
                    continue
                if kind == "number":
                    stack.append(number(numbers[step.at]))
                    continue
                first = len(stack) - step.takes
                values = stack[first:]
                del stack[first:]
                stack.append(self.value(step, kind, values))
        except (FormulaError, ScriptError) as error:
            raise error.inside(text, step.at, len(step.text)) from None
        return stack.pop()

    def direct(self, step: Step, at: int) -> int:
        """Where to go on."""
        if step.kind == "goto" or (step.kind == "else" and self.stack.pop() == 0.0):
            return step.target
        return at

    def value(self, step: Step, kind: str, values: list[Value]) -> Value:
        text = step.text
        if kind == "binary":
            return self.operate(text, values[0], values[1])
        if kind == "unary":
            return self.negate(text, values[0])
        if kind == "reference":
            (self.scope.need_variable(text[2:]) if text[0] == "v" else self.scope.need_box())
            index = tuple(self._index(name) for name in step.names)
            if text[0] == "v":
                return self.scope.variable(text[2:], index, self.mode, self.rows)
            return self.measured(text[0], text[2:], index)
        if kind == "call":
            return self.call(text, values)
        if kind == "named":
            if len(step.names) > _MOST_VALUES:
                raise FormulaError("Too many args in variable function")
            return self.named(text, step.names)
        return self._word(text, step.names)

    def _word(self, text: str, brackets: tuple[str, ...]) -> Value:
        if text in _CONSTANTS and not brackets:
            return _CONSTANTS[text]
        self.scope.need_box()
        if _CUSTOM.fullmatch(text):
            raise FormulaError(f"Invalid custom atom property reference {text} in variable formula")
        if brackets:
            tag = self._index(brackets[0])
            if len(brackets) > 1 and text in _ATOM_VECTORS:
                raise FormulaError("Invalid syntax in variable formula")
            return self.scope.atom(text, tag)
        return self.atoms(text) if text in _ATOM_VECTORS else self.scope.keyword(text)

    def _index(self, text: str) -> int:
        """The number between brackets, or the value of the variable that stands there."""
        if text == "":
            raise ScriptError("Empty brackets in variable")
        if text.startswith("v_"):
            if not re.fullmatch(r"\w*", text, re.ASCII):
                raise ScriptError("Variable name between brackets must be letters, numbers, or underscores")
            value = self.scope.variable_text(text[2:])
            try:
                found = float(value)
            except ValueError:
                raise ScriptError(f"Illegal value in brackets: stod({text})") from None
            index = int(found) if math.isfinite(found) else 0
        else:
            if not re.fullmatch(r"[-+*/\d]*", text, re.ASCII):
                raise ScriptError("Non digit character between brackets in variable")
            whole = _WHOLE.match(text)
            if whole is None:
                raise ScriptError(f"Illegal value in brackets: stoll({text})")
            index = int(whole[0])
        if index <= 0:
            raise ScriptError("Index between variable brackets must be positive")
        return index

    # ---- what differs for many values at once -----------------------------------------------------------------

    def operate(self, sign: str, a: Value, b: Value) -> Value:
        return power(a, b) if sign == "^" else arithmetic(sign, a, b)

    def negate(self, sign: str, a: Value) -> Value:
        return -a if sign == "-" else float(a == 0.0)

    def call(self, name: str, values: list[Value]) -> Value:
        check_call(name, values)
        if name in ("random", "normal"):
            return self.draw(name, values)
        _, function, timed = FUNCTIONS[name]
        return function(*values, self.scope.clock()) if timed else function(*values)

    def draw(self, name: str, values: list[Value]) -> Value:
        """random(low,high,seed) and normal(mean,deviation,seed): one stream for all formulas, begun by the first seed."""
        a, b, seed = values
        if name == "normal" and b < 0.0:
            raise FormulaError(MATH)
        stream = self.scope.random(seed, self.mode)
        if name == "random":
            return stream.uniform() * (b - a) + a
        return a + b * stream.gaussian()

    def measured(self, kind: str, name: str, index: tuple[int, ...]) -> Value:
        return self.scope.measured(kind, name, index, self.mode)

    def named(self, function: str, names: tuple[str, ...]) -> Value:
        return self.scope.named(function, names, self.mode)

    def atoms(self, name: str) -> Value:
        raise ScriptError("Atom vector in equal-style variable formula", hint=f"{name}[1] is that of the atom with ID 1")


def evaluate(text: str, scope: Scope) -> float:
    """The value of an equal-style formula. Raises FormulaError, or ScriptError from scope."""
    return float(Evaluator(scope).run(text)) + 0.0  # a result of -0 is 0


def arithmetic(sign: str, a: float, b: float) -> float:
    """All operators but ^."""
    if sign == "+":
        return a + b
    if sign == "-":
        return a - b
    if sign == "*":
        return a * b
    if sign == "/":
        if b == 0.0:
            raise FormulaError("Divide by 0 in variable formula")
        return a / b
    return modulo(a, b) if sign == "%" else compare(sign, a, b)


def check_call(name: str, values: list[Value]) -> None:
    """Such a function exists and takes so many values."""
    if name not in FUNCTIONS:
        raise FormulaError(f"Invalid math/group/special/feature function '{name}()' in variable formula")
    if not values:
        raise FormulaError("Invalid syntax in variable formula")
    count = FUNCTIONS[name][0]
    if len(values) > _MOST_VALUES:
        raise FormulaError("Too many args in variable function")
    if len(values) != count:
        raise FormulaError(f"Invalid {name} function in variable formula: must have {count} arguments" if name in _STATED else MATH)
