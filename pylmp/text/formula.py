"""Formulas of variables and of ``$(...)``: parsed by Lark into steps for a stack. No recursion, whatever the nesting.

Source: LAMMPS manual, variable.html; precedence and sentences as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
import re
from functools import lru_cache
from typing import Any, NamedTuple

from lark import Token, Tree, UnexpectedInput

from pylmp.text.formula_error import FormulaError
from pylmp.text.functions import FUNCTIONS
from pylmp.text.grammar import parser

_LAZY = ("&&", "||")
NAMED = (  # functions whose arguments are names
    "count mass charge xcm vcm fcm bound gyration ke angmom torque inertia omega sum min max ave trap slope sort rsort gmask rmask "
    "grmask next is_file is_os is_timeout extract_setting label2type is_typelabel is_active is_available is_defined"
)  # fmt: skip
_WORDS_AND_NUMBERS = re.compile(
    rf"(?:{NAMED.replace(' ', '|')})\([^()]*\)|[A-Za-z]\w*(?:\[[^\[\]]*\])*|([0-9.]+(?:[eE][-+]?[0-9]*)?)", re.ASCII
)
_NUMBER = re.compile(r"\d+\.?\d*([eE][-+]?\d+)?|\.\d+([eE][-+]?\d+)?")


class Step(NamedTuple):
    """One step of a formula's program: takes some values from the stack and puts one there.

    kind     number, binary, unary, reference, named, call, word; or one that only directs:
             else (takes a value; if it is 0, go on at target), goto, mark, and lazy (the right side of && and || begins)
    names    what stands between brackets or parentheses, where that is no formula
    at       offset in the formula
    """

    kind: str
    text: str
    takes: int = 0
    names: tuple[str, ...] = ()
    target: int = 0
    at: int = 0


@lru_cache(2000)
def program(text: str) -> tuple[tuple[Step, ...], dict[int, str]]:
    """A formula as steps in the order in which LAMMPS carries them out, and its numbers by their offset.

    Formulas that differ in their numbers alone are parsed once. Raises FormulaError.
    """
    numbers: dict[int, str] = {}

    def blank(found: re.Match[str]) -> str:
        if found[1] is None:
            return found[0]
        numbers[found.start()] = found[0]
        return "0" * len(found[0])

    shape = _WORDS_AND_NUMBERS.sub(blank, text)
    try:
        return _steps(shape), numbers
    except FormulaError as error:
        if error.place:
            error.place = (text, *error.place[1:])
        raise


@lru_cache(2000)
def _steps(text: str) -> tuple[Step, ...]:
    try:
        tree: Any = parser("formula").parse(text)
    except UnexpectedInput as error:
        raise _syntax(text, error.pos_in_stream) from None
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


def _syntax(text: str, at: int | None) -> FormulaError:
    if at is None or not 0 <= at < len(text):
        at = len(text)
    elif text[at] == "[" and "]" not in text[at:]:
        return FormulaError("Mismatched brackets in variable", plain=True).inside(text, at, 1)
    return FormulaError("Invalid syntax in variable formula").inside(text, at, 1)


def _parts(node: Tree[Token]) -> list[Tree[Token] | Step]:
    """What a node of the tree becomes: the steps of its parts, then its own."""
    token = next(child for child in node.children if isinstance(child, Token))
    parts = [child for child in node.children if isinstance(child, Tree)]
    kind, text, at = str(node.data), str(token), token.start_pos or 0
    if kind == "named":
        text, _, inside = text[:-1].partition("(")
        return [Step(kind, text, 0, tuple(name.strip() for name in inside.split(",")), at=at)]
    if kind in ("reference", "word"):
        text, *brackets = text.split("[")
        return [Step(kind, text, 0, tuple(bracket[:-1] for bracket in brackets), at=at)]
    if kind == "call":
        text = text[:-1]
        if text not in FUNCTIONS:  # found wrong before its arguments are looked at
            return [Step(kind, text, at=at)]
    if kind == "call" and text == "ternary" and len(parts) == 3:  # only the chosen side is evaluated
        other, end = f"else {id(node)}", f"end {id(node)}"
        return [
            parts[0], Step("else", other, 1, at=at), parts[1], Step("goto", end), Step("mark", other), parts[2],
            Step("mark", end),
        ]  # fmt: skip
    if text in _LAZY:
        return [parts[0], Step("lazy", text), parts[1], Step(kind, text, 2, at=at)]
    return [*parts, Step(kind, text, len(parts), at=at)]


def number(text: str) -> float:
    """The longest part from the start that is a number, as C reads it."""
    found = _NUMBER.match(text)
    value = float(found[0]) if found else math.nan
    if not math.isfinite(value):
        raise FormulaError(f"Invalid number {text} in variable formula")
    return value
