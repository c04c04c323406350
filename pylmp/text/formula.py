"""Formulas of equal-style variables and of ``$(...)``: parsed by Lark, evaluated on a stack. No eval, no recursion.

Source: LAMMPS manual, variable.html; precedence and sentences as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple, Protocol

from lark import Token, Tree, UnexpectedInput

from pylmp.text.diagnostic import Unsupported
from pylmp.text.functions import FUNCTIONS, FormulaError, compare, power
from pylmp.text.grammar import parser

VERSION = 20250722.0
_BY_NAME = frozenset(("is_defined", "count"))  # their arguments are names, not values
_ELSEWHERE = frozenset(
    {
        "logfreq2", "logfreq3", "stride2", "mass", "charge", "xcm", "vcm", "fcm", "bound", "gyration", "ke", "angmom", "torque",
        "inertia", "omega", "sum", "min", "max", "ave", "trap", "slope", "sort", "rsort", "gmask", "rmask", "grmask", "next",
        "is_active", "is_available", "is_os", "is_timeout", "extract_setting", "label2type", "is_typelabel",
    }
)  # fmt: skip


class Clock(NamedTuple):
    """What functions of time refer to: current step, first and last step of the run, timestep size."""

    step: int
    begin: int
    end: int
    dt: float


class Scope(Protocol):
    """What a formula may refer to. Each raises ScriptError with LAMMPS's sentence."""

    def variable(self, name: str, index: Sequence[int]) -> float: ...
    def compute(self, name: str, index: Sequence[int]) -> float: ...
    def fix(self, name: str, index: Sequence[int]) -> float: ...
    def keyword(self, name: str) -> float: ...
    def atom(self, name: str, tag: int) -> float: ...
    def named(self, function: str, names: Sequence[str]) -> float: ...
    def random(self, seed: int) -> Any: ...
    def clock(self) -> Clock: ...


class Step(NamedTuple):
    """One step of a formula's program: takes some values from the stack and puts one there.

    The kinds "else" (goes to another step if the value it takes is 0), "goto" and "mark" put nothing.
    """

    kind: str
    text: str
    takes: int = 0
    names: tuple[str, ...] = ()
    target: int = 0


@lru_cache(2000)
def program(text: str) -> tuple[Step, ...]:
    """A formula as steps in the order in which LAMMPS carries them out. Raises FormulaError."""
    try:
        tree: Any = parser("formula").parse(text)
    except UnexpectedInput:
        raise FormulaError("Invalid syntax in variable formula") from None
    steps: list[Step] = []
    waiting: list[Tree[Token] | Step] = [tree]
    while waiting:
        node = waiting.pop()
        if isinstance(node, Step):
            steps.append(node)
        else:
            waiting.extend(reversed(_parts(node)))
    marks = {step.text: at for at, step in enumerate(steps) if step.kind == "mark"}
    return tuple(step._replace(target=marks[step.text]) if step.kind in ("else", "goto") else step for step in steps)


def _parts(node: Tree[Token]) -> list[Tree[Token] | Step]:
    """What a node of the tree becomes: the steps of its parts, then its own."""
    head, *more = (str(child) for child in node.children if isinstance(child, Token))
    parts = [child for child in node.children if isinstance(child, Tree)]
    if node.data == "file":
        return [Step("names", head, 0, tuple(more))]
    if node.data == "call" and (head in _BY_NAME or head in _ELSEWHERE):
        names = tuple(str(t) for part in parts for t in part.scan_values(lambda v: isinstance(v, Token)))
        return [Step("names", head, 0, names)]
    if node.data == "call" and head == "ternary" and len(parts) == 3:  # only the chosen side is evaluated
        other, end = f"else {id(node)}", f"end {id(node)}"
        return [
            parts[0], Step("else", other, 1), parts[1], Step("goto", end), Step("mark", other), parts[2], Step("mark", end),
        ]  # fmt: skip
    return [*parts, Step(str(node.data), head, len(parts))]


def evaluate(text: str, scope: Scope) -> float:
    """The value of a formula. Raises FormulaError, or ScriptError from scope."""
    steps = program(text)
    stack: list[float] = []
    at = 0
    while at < len(steps):
        step = steps[at]
        at += 1
        if step.kind == "goto" or (step.kind == "else" and stack.pop() == 0.0):
            at = step.target
        elif step.kind not in ("mark", "else"):
            first = len(stack) - step.takes
            values = stack[first:]
            del stack[first:]
            stack.append(_carry_out(step, values, scope))
    return stack[0] + 0.0  # a result of -0 is 0


def _carry_out(step: Step, values: list[float], scope: Scope) -> float:
    kind, text = step.kind, step.text
    if kind == "number":
        return number(text)
    if kind == "binary":
        return _operate(text, values[0], values[1])
    if kind == "unary":
        return -values[0] if text == "-" else float(values[0] == 0.0)
    if kind == "reference":
        look = {"v": scope.variable, "c": scope.compute, "f": scope.fix}[text[0]]
        return look(text[2:], [int(v) if math.isfinite(v) else 0 for v in values])
    if kind == "call":
        return _call(text, values, scope)
    if kind == "names":
        if text in _ELSEWHERE:
            raise Unsupported(f"LAMMPS has {text}() in formulas, pylmp's native engines do not", manual="variable.html")
        return scope.named(text, step.names)
    if values:
        return scope.atom(text, int(values[0]) if math.isfinite(values[0]) else 0)
    return {"PI": math.pi, "version": VERSION}[text] if text in ("PI", "version") else scope.keyword(text)


def number(text: str) -> float:
    """The longest part from the start that is a number, as C reads it."""
    found = re.match(r"\d+\.?\d*([eE][-+]?\d+)?|\.\d+([eE][-+]?\d+)?", text)
    value = float(found[0]) if found else math.nan
    if not math.isfinite(value):
        raise FormulaError(f"Invalid number {text} in variable formula")
    return value


def _operate(sign: str, a: float, b: float) -> float:
    if sign == "+":
        return a + b
    if sign == "-":
        return a - b
    if sign == "*":
        return a * b
    if sign == "^":
        return power(a, b)
    if sign in ("/", "%"):
        if b == 0.0:
            raise FormulaError("Divide by 0 in variable formula" if sign == "/" else "Modulo 0 in variable formula")
        return a / b if sign == "/" else _modulo(a, b)
    return compare(sign, a, b)


def _modulo(a: float, b: float) -> float:
    return math.nan if math.isinf(a) else math.fmod(a, b)


def _call(name: str, values: list[float], scope: Scope) -> float:
    if name in ("random", "normal"):
        return _random(name, values, scope)
    if name not in FUNCTIONS:
        raise FormulaError(f"Invalid math/group/special/feature function '{name}()' in variable formula")
    if not values:
        raise FormulaError("Invalid syntax in variable formula")
    count, function, timed = FUNCTIONS[name]
    if len(values) != count:
        raise FormulaError("Invalid math function in variable formula")
    return function(*values, scope.clock()) if timed else function(*values)


def _random(name: str, values: list[float], scope: Scope) -> float:
    """random(low,high,seed) and normal(mean,deviation,seed): one stream for all formulas, begun by the first seed."""
    if len(values) != 3 or int(values[2]) <= 0 or (name == "normal" and values[1] < 0.0):
        raise FormulaError(
            "Invalid math function in variable formula" if values else "Invalid syntax in variable formula"
        )
    stream = scope.random(int(values[2]))
    if name == "random":
        return float(stream.uniform()) * (values[1] - values[0]) + values[0]
    return values[0] + values[1] * float(stream.gaussian())
