"""Conditions of the if command.

Two numbers compare as numbers, two words by == and != only.
"""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Any

from lark import Token, Tree, UnexpectedInput

from pylmp.text.formula import number
from pylmp.text.formula_error import FormulaError
from pylmp.text.functions import compare
from pylmp.text.grammar import parser

_OPERANDS = re.compile(r"([A-Za-z][A-Za-z0-9_/]*)|[0-9.-][0-9.]*(?:[eE][-+]?[0-9]*)?")
_SYNTAX = "Invalid Boolean syntax in if command"


class ConditionError(Exception):
    """The condition is wrong; the caller says where it stands."""


def holds(text: str) -> bool:
    """Whether a condition, all variables replaced, is true. Raises ConditionError."""
    operands: list[str] = []

    def blank(found: re.Match[str]) -> str:
        operands.append(found[0])
        return " a " if found[1] else " 0 "

    try:
        steps = _steps(_OPERANDS.sub(blank, text))
    except UnexpectedInput:
        unclosed = text.count("(") > text.count(")")
        raise ConditionError("Invalid syntax in variable formula" if unclosed else _SYNTAX) from None
    stack: list[float | str] = []
    waiting = iter(operands)
    for kind, sign, takes in steps:
        first = len(stack) - takes
        parts = stack[first:]
        del stack[first:]
        stack.append(_one(kind, sign if takes else next(waiting), parts))
    if isinstance(stack[0], str):
        raise ConditionError("If command boolean cannot be single string")
    return stack[0] != 0.0


@lru_cache(1000)
def _steps(shape: str) -> list[tuple[str, str, int]]:
    """(kind, sign, how many values it takes) from the leaves up, for all conditions that differ in their words and numbers alone."""
    steps: list[tuple[str, str, int]] = []
    waiting: list[Any] = [parser("condition").parse(shape)]
    while waiting:
        node = waiting.pop()
        if isinstance(node, Tree):
            parts = [child for child in node.children if isinstance(child, Tree)]
            sign = next(str(child) for child in node.children if isinstance(child, Token))
            waiting += [(str(node.data), sign, len(parts)), *reversed(parts)]
        else:
            steps.append(node)
    return steps


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
