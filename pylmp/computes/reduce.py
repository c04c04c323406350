"""compute ID GROUP reduce MODE inputs... [inputs peratom|local] [replace I J]: one number from many.

Modes sum min max ave sumsq avesq sumabs aveabs maxabs minabs. replace: value I is that of the row where value J has its
extreme. Source: LAMMPS manual, compute_reduce.html.
As LAMMPS 22 Jul 2025 does, minabs gives 1e20 whatever the input, and aveabs of several inputs gives their sums.
sumabs of several inputs is undefined there; here it is the sum.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute, current
from pylmp.model.reference import KINDS, expand
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_BIG = 1.0e20
_MODES = ("sum", "min", "max", "ave", "sumsq", "avesq", "sumabs", "aveabs", "maxabs", "minabs")
_PLAIN = {f"{name}{axis}": (name or "x", k) for name in ("", "v", "f") for k, axis in enumerate("xyz")}


@COMPUTES.register("reduce")
class Reduce(Compute):
    style = "reduce"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(self.words_needed)
        self.read_region(sim, args)
        mode = args.word()
        if mode.text not in _MODES:
            args.fail(f"Unknown {args.what} mode: {mode.text}", mode, hint=" ".join(_MODES))
        self.mode = mode.text
        words = []
        while (word := args.peek()) is not None and (word.text in _PLAIN or re.match(r"[cfv]_", word.text)):
            words.append(args.word())
        self.local_inputs = False
        self.replace: dict[int, int] = {}
        pairs = []
        while len(args):
            key = args.word()
            if key.text == "inputs":
                args.need(1, key.text)
                value = args.word()
                if value.text not in ("peratom", "local"):
                    args.fail(f"Unknown {args.what} inputs argument: {value.text}", value, hint="peratom or local")
                self.local_inputs = value.text == "local"
            elif key.text == "replace":
                args.need(2, key.text)
                if self.mode not in ("min", "max"):
                    args.fail(f"{args.what.capitalize()} replace requires min or max mode", key)
                pairs.append((args.word(), args.word()))
            else:
                args.fail(f"Unknown {args.what} keyword: {key.text}", key, hint="inputs replace")
        if not words:
            args.missing()
        self.check_inputs(args)
        for values in ("per_atom", "local"):
            words = expand(sim, args, words, values)
        for pair in pairs:
            self._replace(args, pair, len(words))
        self.inputs = [self._input(sim, args, word) for word in words]
        self.length = len(self.inputs)
        if self.length > 1:
            self.scalar = None  # type: ignore[method-assign,assignment]
        else:
            self.vector = None  # type: ignore[method-assign,assignment]
        self.extensive_scalar = self.extensive_vector = self.mode in ("sum", "sumsq", "sumabs")

    # ---- for reduce/region ------------------------------------------------------------------------------------

    words_needed = 2

    def read_region(self, sim: Simulation, args: Args) -> None:
        """Take the region's ID."""

    def check_inputs(self, args: Args) -> None:
        """Refuse what this style does not take."""

    # ---- inputs -----------------------------------------------------------------------------------------------

    def _replace(self, args: Args, pair: tuple[Word, Word], count: int) -> None:
        first, second = (args.as_integer(word) - 1 for word in pair)
        for word, which, at in ((pair[0], "first", first), (pair[1], "second", second)):
            if not 0 <= at < count:
                args.fail(f"Invalid {args.what} replace {which} column index {at}", word, hint=f"1 to {count}")
        if first == second:
            args.fail("Compute {} replace columns must be different", pair[1])
        self.replace[first] = second

    def _input(self, sim: Simulation, args: Args, word: Word) -> tuple[str, str, int]:
        """(kind, name, column from 1, 0 for a vector); kind is plain, c or f."""
        if word.text in _PLAIN:
            if self.local_inputs:
                args.fail("Compute {} inputs must be all local", word, hint="c_ID or f_ID with local values")
            return "plain", word.text, 0
        found = re.fullmatch(r"([cfv])_([A-Za-z0-9_]+)(?:\[(\d+)\])?", word.text)
        if not found:
            args.illegal(word)
        kind, name = found[1], found[2]
        if kind == "v":
            return self._variable(sim, args, word, name)
        source = self._source(sim, kind, name)
        what, shape = "compute" if kind == "c" else "fix", "local" if self.local_inputs else "per-atom"
        if source is None:
            args.fail(f"{what.capitalize()} ID {name} for {args.what} does not exist", word)
        if getattr(source, shape.replace("-", "_"), None) is None:
            hint = "inputs local" if not self.local_inputs and hasattr(source, "local") else ""
            args.fail(f"{args.what.capitalize()} {what} {name} does not calculate {shape} values", word, hint=hint)
        column, columns = int(found[3] or 0), int(getattr(source, "columns", 0))
        columns = 0 if columns == 1 else columns
        if column and not columns:
            args.fail(f"{args.what.capitalize()} {what} {name} does not calculate a {shape} array", word, hint=f"{kind}_{name}")
        if columns and not column:
            args.fail(f"{args.what.capitalize()} {what} {name} does not calculate a {shape} vector", word, hint=f"{word.text}[1]")
        if column > columns:
            args.fail(f"{args.what.capitalize()} {what} {name} array is accessed out-of-range", word, hint=f"1 to {columns}")
        return kind, name, column

    def _variable(self, sim: Simulation, args: Args, word: Word, name: str) -> tuple[str, str, int]:
        style = Variables(sim).style(name)
        if style is None:
            args.fail(f"Variable name {name} for {args.what} does not exist", word, hint=f"variable {name} atom ...")
        if self.local_inputs:
            args.fail("Compute {} inputs must be all local", word, hint="c_ID or f_ID with local values")
        if style not in ("atom", "atomfile"):
            args.fail(f"{args.what.capitalize()} variable {name} is not atom-style variable", word)
        return "v", name, 0

    @staticmethod
    def _source(sim: Simulation, kind: str, name: str) -> Any:
        if kind == "c":
            return sim.computes.get(name)
        return next((fix for fix in sim.fixes if fix.id == name), None)

    def init(self, sim: Simulation) -> None:
        """What the inputs name is still there."""
        for kind, name, _ in self.inputs:
            there = Variables(sim).style(name) if kind == "v" else self._source(sim, kind, name)
            if kind != "plain" and there is None:
                what = "Variable name" if kind == "v" else f"{KINDS[kind].capitalize()} ID"
                raise ScriptError(f"{what} {name} for compute {self.style} does not exist", hint="it was deleted")

    def _values(self, sim: Simulation, item: tuple[str, str, int]) -> Floats:
        kind, name, column = item
        if kind == "plain":
            array, axis = _PLAIN[name]
            return np.asarray(getattr(sim.atoms, array)[: sim.atoms.n, axis][self.members(sim)])
        if kind == "v":
            return Variables(sim).per_atom(name, np.flatnonzero(self.members(sim)))
        source = self._source(sim, kind, name)
        if sim.step % getattr(source, "compatible_every", 1):
            raise ScriptError(f"Fix {name} used in compute {self.style} not computed at compatible time")
        values = current(sim, source, "local" if self.local_inputs else "per_atom")
        if column:
            values = values[:, column - 1]
        return np.asarray(values if self.local_inputs else values[self.members(sim)])

    def _reduce(self, values: Floats) -> float:
        mode = self.mode
        if mode in ("sum", "ave"):
            result = total(values)
        elif mode in ("sumsq", "avesq"):
            result = total(values * values)
        elif mode in ("sumabs", "aveabs"):
            result = total(np.abs(values))
        elif mode == "min":
            return min(float(values.min()), _BIG) if len(values) else _BIG
        elif mode == "max":
            return max(float(values.max()), -_BIG) if len(values) else -_BIG
        elif mode == "maxabs":
            return float(np.abs(values).max()) if len(values) else 0.0
        else:
            return _BIG
        if mode.startswith("ave") and len(values) and not (mode == "aveabs" and self.length > 1):
            result = result / len(values)
        return result

    def scalar(self, sim: Simulation) -> float:
        return self._reduce(self._values(sim, self.inputs[0]))

    def vector(self, sim: Simulation) -> Floats:
        table = [self._values(sim, item) for item in self.inputs]
        result = np.array([self._reduce(values) for values in table])
        for to, by in self.replace.items():
            if len(table[by]):
                row = table[by].argmin() if self.mode == "min" else table[by].argmax()
                result[to] = table[to][row]
        return result
