"""Conditions of the if command.

Two numbers compare as numbers, anything else as text, and text knows == and != only.
"""

from __future__ import annotations

from typing import Any

from lark import UnexpectedInput

from pylmp.text.grammar import parser


class ConditionError(Exception):
    """The condition is wrong; the caller says where it stands."""


def holds(text: str) -> bool:
    """Whether a condition, all variables replaced, is true. Raises ConditionError."""
    try:
        tree: Any = parser("condition").parse(text)
    except UnexpectedInput:
        raise ConditionError("Invalid Boolean syntax in if command") from None
    if tree.data in ("word", "quoted"):
        raise ConditionError("Invalid Boolean syntax in if command")
    return _value(tree) != 0.0


def _value(node: Any) -> float | str:
    kind = str(node.data)
    if kind == "quoted":
        return str(node.children[0])[1:-1]
    if kind == "word":
        return _number(str(node.children[0]))
    if kind == "negation":
        value = _value(node.children[0])
        if isinstance(value, str):
            raise ConditionError("Invalid Boolean syntax in if command")
        return float(value == 0.0)
    return _compare(str(node.children[1]), _value(node.children[0]), _value(node.children[2]))


def _number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def _compare(sign: str, a: float | str, b: float | str) -> float:
    if sign in ("==", "!="):
        if type(a) is not type(b):
            raise ConditionError("If command boolean is comparing string to number")
        return float((a == b) == (sign == "=="))
    if isinstance(a, str) or isinstance(b, str):
        both = isinstance(a, str) and isinstance(b, str)
        raise ConditionError(
            "If command boolean can only operate on numbers" if both else "If command boolean is comparing string to number"
        )
    truth = {
        "<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b,
        "&&": a != 0.0 and b != 0.0, "||": a != 0.0 or b != 0.0, "|^": (a != 0.0) != (b != 0.0),
    }  # fmt: skip
    return float(truth[sign])
