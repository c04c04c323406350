"""Formulas: parsed by Lark, evaluated by walking the tree. No eval.

Source: LAMMPS manual, variable.html; precedence and sentences as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, Protocol

from lark import Token, Tree, UnexpectedInput

from pylmp.text.diagnostic import ScriptError
from pylmp.text.grammar import parser

_DEEPEST = 200  # nested parentheses and calls
_LONGEST = 20000  # characters
VERSION = 20250722.0


class Scope(Protocol):
    """What a formula may refer to."""

    def variable(self, name: str, index: tuple[int, ...]) -> float: ...
    def compute(self, name: str, index: tuple[int, ...]) -> float: ...
    def fix(self, name: str, index: tuple[int, ...]) -> float: ...
    def keyword(self, name: str) -> float: ...


class FormulaError(Exception):
    """A formula is wrong; the caller adds whose it is and where it stands."""


@lru_cache(maxsize=2000)
def parse(text: str) -> Tree[Token]:
    """The tree of a formula. Raises FormulaError."""
    if len(text) > _LONGEST or text.count("(") > _DEEPEST:
        raise FormulaError("Too long or too deeply nested a variable formula")
    try:
        return parser("formula").parse(text)  # type: ignore[return-value]
    except UnexpectedInput:
        raise FormulaError("Invalid syntax in variable formula") from None


def evaluate(text: str, scope: Scope) -> float:
    """The value of a formula. Raises FormulaError or whatever scope raises (ScriptError)."""
    return _value(parse(text), scope)


def _value(node: Any, scope: Scope) -> float:
    kind = str(node.data)
    parts = node.children
    if kind == "number":
        return float(parts[0])
    if kind == "negative":
        return -_value(parts[1], scope)
    if kind == "negation":
        return 1.0 if _value(parts[1], scope) == 0.0 else 0.0
    if kind == "reference":
        name = str(parts[0])
        index = tuple(int(_value(p.children[0], scope)) for p in parts[1:])
        look = {"v": scope.variable, "c": scope.compute, "f": scope.fix}[name[0]]
        return look(name[2:], index)
    if kind == "word":
        return _word(str(parts[0]), parts[1:], scope)
    if kind == "call":
        return _call(str(parts[0]), [_value(p, scope) for p in parts[1:]])
    return _operate(str(parts[1]), _value(parts[0], scope), _value(parts[2], scope))


def _word(name: str, index: list[Any], scope: Scope) -> float:
    if index:
        raise FormulaError("Variable atom ID references are not supported here")
    if name == "PI":
        return math.pi
    if name == "version":
        return VERSION
    return scope.keyword(name)


def _operate(sign: str, a: float, b: float) -> float:
    if sign in ("/", "%") and b == 0.0:
        raise FormulaError("Divide by 0 in variable formula" if sign == "/" else "Modulo 0 in variable formula")
    if sign == "^":
        if b == 0.0:
            return 1.0
        if a == 0.0 and b < 0.0:
            raise FormulaError("Invalid power expression in variable formula")
        return _safely(math.pow, a, b)
    return _OPERATORS[sign](a, b)


_OPERATORS: dict[str, Callable[[float, float], float]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "%": math.fmod,
    "==": lambda a, b: float(a == b),
    "!=": lambda a, b: float(a != b),
    "<": lambda a, b: float(a < b),
    "<=": lambda a, b: float(a <= b),
    ">": lambda a, b: float(a > b),
    ">=": lambda a, b: float(a >= b),
    "&&": lambda a, b: float(a != 0.0 and b != 0.0),
    "||": lambda a, b: float(a != 0.0 or b != 0.0),
    "|^": lambda a, b: float((a != 0.0) != (b != 0.0)),
}


def _safely(function: Callable[..., float], *values: float) -> float:
    try:
        return function(*values)
    except OverflowError:
        return math.inf
    except ValueError:
        return math.nan


def _round(x: float) -> float:
    """Halves away from zero, as C's round."""
    return math.copysign(math.floor(abs(x) + 0.5), x) if abs(x) < 2.0**52 else x


def _sign(x: float) -> float:
    return 1.0 if x >= 0.0 else -1.0


_FUNCTIONS: dict[str, tuple[int, Callable[..., float]]] = {
    "sqrt": (1, math.sqrt), "exp": (1, math.exp), "ln": (1, math.log), "log": (1, math.log10), "abs": (1, abs),
    "sign": (1, _sign), "sin": (1, math.sin), "cos": (1, math.cos), "tan": (1, math.tan), "asin": (1, math.asin),
    "acos": (1, math.acos), "atan": (1, math.atan), "atan2": (2, math.atan2),
    "ceil": (1, lambda x: float(math.ceil(x))), "floor": (1, lambda x: float(math.floor(x))), "round": (1, _round),
    "ternary": (3, lambda c, a, b: a if c else b),
}  # fmt: skip


def _call(name: str, values: list[float]) -> float:
    if name not in _FUNCTIONS:
        raise FormulaError("Invalid math/group/special function in variable formula")
    count, function = _FUNCTIONS[name]
    if len(values) != count:
        raise FormulaError("Invalid math function in variable formula")
    x = values[0]
    if name == "sqrt" and x < 0.0:
        raise FormulaError("Sqrt of negative value in variable formula")
    if name in ("ln", "log") and x <= 0.0:
        raise FormulaError("Log of zero/negative value in variable formula")
    if name in ("asin", "acos") and not -1.0 <= x <= 1.0:
        raise FormulaError(f"{'Arcsin' if name == 'asin' else 'Arccos'} of invalid value in variable formula")
    return _safely(function, *values)
