"""compute ID GROUP reduce MODE inputs... [inputs peratom|local] [replace I J]: one number from many.

Modes sum min max ave sumsq avesq sumabs aveabs maxabs minabs. replace: value I is that of the row where value J has its
extreme. Source: LAMMPS manual, compute_reduce.html.
As LAMMPS 22 Jul 2025 does, minabs gives 1e20 whatever the input, and aveabs of several inputs gives their sums.
sumabs of several inputs is undefined there; here it is the sum.
"""

from __future__ import annotations

import re

import numpy as np

from pylmp.model.atom_inputs import AtomInput, read_atom_input
from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.reference import expand
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
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

    def _input(self, sim: Simulation, args: Args, word: Word) -> AtomInput | str:
        """Values of others, or the name of a property of atoms."""
        if word.text not in _PLAIN:
            return read_atom_input(sim, args, word, "local" if self.local_inputs else "per_atom")
        if self.local_inputs:
            args.fail("Compute {} inputs must be all local", word, hint="c_ID or f_ID with local values")
        return word.text

    def init(self, sim: Simulation) -> None:
        """What the inputs name is still there."""
        for item in self.inputs:
            if isinstance(item, AtomInput):
                item.check(sim, f"compute {self.style}")

    def _values(self, sim: Simulation, item: AtomInput | str) -> Floats:
        if isinstance(item, AtomInput):
            return item.values(sim, self.members(sim), f"compute {self.style}")
        array, axis = _PLAIN[item]
        return np.asarray(getattr(sim.atoms, array)[: sim.atoms.n, axis][self.members(sim)])

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
