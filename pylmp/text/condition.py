"""Conditions of the if command.

Two numbers compare as numbers, two words by == and != only.
"""

from __future__ import annotations

from typing import Any

from lark import Token, Tree, UnexpectedInput

from pylmp.text.formula import number
from pylmp.text.formula_error import FormulaError
from pylmp.text.functions import compare
from pylmp.text.grammar import parser

_SYNTAX = "Invalid Boolean syntax in if command"


class ConditionError(Exception):
    """The condition is wrong; the caller says where it stands."""


def holds(text: str) -> bool:
    """Whether a condition, all variables replaced, is true. Raises ConditionError."""
    try:
        tree: Any = parser("condition").parse(text)
    except UnexpectedInput:
        unclosed = text.count("(") > text.count(")")
        raise ConditionError("Invalid syntax in variable formula" if unclosed else _SYNTAX) from None
    value = _value(tree)
    if isinstance(value, str):
        raise ConditionError("If command boolean cannot be single string")
    return value != 0.0


def _value(tree: Tree[Token]) -> float | str:
    """Walks the tree from its leaves up, without recursion."""
    values: dict[int, float | str] = {}
    for node in tree.iter_subtrees():
        parts = [values[id(child)] for child in node.children if isinstance(child, Tree)]
        sign = next(str(child) for child in node.children if isinstance(child, Token))
        values[id(node)] = _one(str(node.data), sign, parts)
    return values[id(tree)]


def _one(kind: str, text: str, parts: list[float | str]) -> float | str:
    if kind == "word":
        return text
    if kind == "number":
        try:
            return number(text.removeprefix("-")) * (-1.0 if text.startswith("-") else 1.0)
        except FormulaError:
            raise ConditionError(_SYNTAX) from None
    a = parts[0]
    if kind == "negation":
        if isinstance(a, str):
            raise ConditionError("If command boolean not cannot operate on string")
        return float(a == 0.0)
    b = parts[1]
    if isinstance(a, str) or isinstance(b, str):
        if text not in ("==", "!="):
            raise ConditionError("If command boolean can only operate on numbers")
        if type(a) is not type(b):
            raise ConditionError("If command boolean is comparing string to number")
        return float((a == b) == (text == "=="))
    return compare(text, a, b)
