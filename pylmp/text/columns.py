"""Evaluation of formulas for many values at once: atoms (atom style) or the elements of vectors (vector style).

LAMMPS walks its tree once for each atom; here each step of the formula is carried out for all of them. Where a right side
is not looked at for some of them (ternary, && and ||), it is carried out for the others only.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.text.diagnostic import ScriptError
from pylmp.text.evaluate import Evaluator, Scope, Value, arithmetic, check_call
from pylmp.text.formula import Step, program
from pylmp.text.formula_error import MATH, FormulaError
from pylmp.text.functions import FUNCTIONS

Floats = NDArray[np.float64]

_ARITHMETIC: dict[str, Callable[..., Any]] = {
    "+": np.add, "-": np.subtract, "*": np.multiply, "/": np.divide, "%": np.fmod,
    "==": np.equal, "!=": np.not_equal, "<": np.less, "<=": np.less_equal, ">": np.greater, ">=": np.greater_equal,
}  # fmt: skip
_ZERO = {"/": "Divide by 0 in variable formula", "%": "Modulo 0 in variable formula", "^": "Power by 0 in variable formula"}
_OF_C = {"exp": "exp", "ln": "log", "log": "log10", "sin": "sin", "cos": "cos", "tan": "tan", "asin": "asin", "acos": "acos",
         "atan": "atan", "atan2": "atan2"}  # fmt: skip
_EXACT: dict[str, Callable[..., Any]] = {
    "sqrt": np.sqrt, "abs": np.abs, "ceil": np.ceil, "floor": np.floor, "sign": lambda x: np.where(x >= 0.0, 1.0, -1.0),
    "round": lambda x: np.where(x - np.floor(x) >= 0.5, np.ceil(x), np.floor(x)),
}  # fmt: skip


@dataclass
class _Branch:
    """A right side being carried out for some rows only: what decided, the rows before, and the value of the first choice."""

    decides: Value
    rows: Any
    first: Value = 0.0


class Columns(Evaluator):
    """mode: atom or vector. rows: which atoms or elements values are wanted of, None: all."""

    def __init__(self, scope: Scope, mode: str, rows: Any = None) -> None:
        super().__init__(scope)
        self.mode = mode
        self.rows = rows
        self._branches: list[_Branch] = []
        self.length: int | None = None

    def run(self, text: str) -> Value:
        with np.errstate(all="ignore"):
            return super().run(text)

    # ---- right sides ------------------------------------------------------------------------------------------

    def direct(self, step: Step, at: int) -> int:
        if step.kind == "lazy":
            left = self.stack[-1]
            self._branches.append(_Branch(left, self.rows))
            self._narrow((left != 0.0) if step.text == "&&" else (left == 0.0))
        elif step.kind == "else":
            return self._choose(step, at)
        elif step.kind == "goto":
            branch = self._branches[-1]
            if not isinstance(branch.decides, np.ndarray):
                return step.target
            branch.first = self.stack.pop()
            self.rows = branch.rows
            self._narrow(branch.decides == 0.0)
        elif step.text.startswith("end"):
            branch, last = self._branches.pop(), self.stack.pop()
            self.rows = branch.rows
            if isinstance(branch.decides, np.ndarray):
                self.stack.append(_merge(branch.decides != 0.0, branch.first, last))
            else:  # as LAMMPS does: it forgets what it chose where that is no single number
                self.stack.append(0.0 if isinstance(last, np.ndarray) else last)
        return at

    def _choose(self, step: Step, at: int) -> int:
        """The first choice of a ternary; the second at once if one number decides so for all."""
        condition = self.stack.pop()
        self._branches.append(_Branch(condition, self.rows))
        if isinstance(condition, np.ndarray):
            self._narrow(condition != 0.0)
        elif condition == 0.0:
            return step.target
        return at

    def _narrow(self, mask: Any) -> None:
        if isinstance(mask, np.ndarray):
            chosen = np.flatnonzero(mask)
            self.rows = chosen if self.rows is None else self.rows[chosen]
        elif not mask:
            self.rows = np.zeros(0, np.int64)

    # ---- values -----------------------------------------------------------------------------------------------

    def _chosen(self, value: Value) -> Value:
        """The rows wanted of a value for all atoms or of a whole vector."""
        if not isinstance(value, np.ndarray):
            return value
        if self.mode == "vector":
            if self.length not in (None, len(value)):
                raise FormulaError("Inconsistent lengths in vector-style variable")
            self.length = len(value)
        return value if self.rows is None else value[self.rows[self.rows < len(value)]]

    def value(self, step: Step, kind: str, values: list[Value]) -> Value:
        result = super().value(step, kind, values)
        if kind == "reference" and step.text[0] == "v" and self.mode == "vector":
            return self._chosen(result)  # an atom-style variable comes for the rows wanted
        return result

    def measured(self, kind: str, name: str, index: tuple[int, ...]) -> Value:
        return self._chosen(super().measured(kind, name, index))

    def named(self, function: str, names: tuple[str, ...]) -> Value:
        return self._chosen(super().named(function, names))

    def atoms(self, name: str) -> Value:
        if self.mode == "vector":
            raise ScriptError("Atom vector in vector-style variable formula", hint=f"{name}[1] is that of the atom with ID 1")
        return self._chosen(self.scope.atoms(name))

    def operate(self, sign: str, a: Value, b: Value) -> Value:
        if sign in ("&&", "||"):
            self.rows = self._branches.pop().rows
            left = (a != 0.0) if sign == "&&" else (a == 0.0)
            return _merge(left, _truth(b), float(sign == "||"))
        if sign in _ZERO and np.any(b == 0.0):
            raise FormulaError(_ZERO[sign], plain=True)
        if sign == "^":
            return self.scope.of_c("pow", a, b)
        if sign == "|^":
            return _truth(_truth(a) != _truth(b))
        if not isinstance(a, np.ndarray) and not isinstance(b, np.ndarray):
            return arithmetic(sign, a, b)
        return np.asarray(_ARITHMETIC[sign](a, b), float)

    def negate(self, sign: str, a: Value) -> Value:
        return -a if sign == "-" else _truth(a == 0.0)

    def call(self, name: str, values: list[Value]) -> Value:
        check_call(name, values)
        if name in ("random", "normal"):
            return self.draw(name, values)
        try:
            return self._call(name, values)
        except FormulaError as error:
            raise FormulaError(str(error), plain=True) from None

    def _call(self, name: str, values: list[Value]) -> Value:
        _, function, timed = FUNCTIONS[name]
        more = (self.scope.clock(),) if timed else ()
        if not any(isinstance(value, np.ndarray) for value in values):
            return function(*values, *more)
        x = values[0]
        if name == "sqrt" and np.any(x < 0.0):
            raise FormulaError("Sqrt of negative value in variable formula")
        if name in ("ln", "log") and np.any(x <= 0.0):
            raise FormulaError("Log of zero/negative value in variable formula")
        if name in ("asin", "acos") and np.any((x < -1.0) | (x > 1.0)):
            raise FormulaError(f"Arc{name[1:]} of invalid value in variable formula")
        if name in _EXACT:
            return np.asarray(_EXACT[name](x), float)
        if name in _OF_C:
            return self.scope.of_c(_OF_C[name], *values)
        table = np.broadcast_arrays(*values)  # functions of the clock
        return np.array([function(*row, *more) for row in zip(*(column.tolist() for column in table), strict=True)])

    def draw(self, name: str, values: list[Value]) -> Value:
        """A number for each row, in order; the atoms have a stream of their own."""
        a, b, seed = values
        count = self._count(values)
        if count == 0:
            return np.zeros(0)
        stream = self.scope.random(float(seed[0]) if isinstance(seed, np.ndarray) else seed, self.mode)
        if name == "random":
            return np.array([stream.uniform() for _ in range(count)]) * (b - a) + a
        if np.any(b < 0.0):
            raise FormulaError(MATH, plain=True)
        return a + b * np.array([stream.gaussian() for _ in range(count)])

    def _count(self, values: Sequence[Value]) -> int:
        """How many rows there are."""
        if self.rows is not None:
            return len(self.rows)
        known = next((len(value) for value in values if isinstance(value, np.ndarray)), self.length)
        return known if known is not None else self.scope.count()


def evaluate_columns(text: str, scope: Scope, mode: str, rows: Any = None) -> Value:
    """The values of an atom-style or vector-style formula: (rows,) float64, or one float that holds for all of them.

    Raises FormulaError, or ScriptError from scope.
    """
    draws = _draws(text, scope, frozenset())
    if draws == 0 or (draws == 1 and mode == "atom"):
        return Columns(scope, mode, rows).run(text)
    # LAMMPS draws all numbers of one atom or element before those of the next.
    if mode == "atom":
        every = list(range(scope.count()) if rows is None else rows)
        return np.array([_one(Columns(scope, mode, np.array([row])).run(text)) for row in every], float)
    first = Columns(scope, mode, np.array([0]))
    values = [_one(first.run(text))]
    if first.length is None:
        return values[0]
    values += [_one(Columns(scope, mode, np.array([row])).run(text)) for row in range(1, first.length)]
    return np.array(values[: first.length])


def _draws(text: str, scope: Scope, seen: frozenset[str]) -> int:
    """How many random numbers one evaluation takes, those of the variables it names included."""
    count = 0
    for step in program(text)[0]:
        if step.kind == "call" and step.text in ("random", "normal"):
            count += 1
        elif step.kind == "reference" and step.text[0] == "v" and not step.names and step.text not in seen:
            inner = scope.formula(step.text[2:])
            count += _draws(inner, scope, seen | {step.text}) if inner is not None else 0
    return count


def _one(value: Value) -> float:
    return float(value[0]) if isinstance(value, np.ndarray) else float(value)


def _truth(value: Any) -> Value:
    return (value != 0.0).astype(float) if isinstance(value, np.ndarray) else float(value != 0.0)


def _merge(mask: Any, chosen: Value, other: Value) -> Value:
    """chosen where mask holds, else other; each is a number or has a value for each of its own rows."""
    if not isinstance(mask, np.ndarray):
        return chosen if mask else other
    result = np.empty(len(mask))
    result[mask] = chosen
    result[~mask] = other
    return result
