"""compute ID GROUP reduce MODE inputs... [inputs peratom|local]: one number from many.

Modes sum min max ave sumsq avesq sumabs aveabs maxabs minabs. Source: LAMMPS manual, compute_reduce.html.
LAMMPS 22 Jul 2025 returns 1e20 for minabs whatever the input; so does this.
"""

from __future__ import annotations

import re
from typing import Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args, Word

_BIG = 1.0e20
_MODES = ("sum", "min", "max", "ave", "sumsq", "avesq", "sumabs", "aveabs", "maxabs", "minabs")
_PLAIN = {f"{name}{axis}": (name or "x", k) for name in ("", "v", "f") for k, axis in enumerate("xyz")}


@COMPUTES.register("reduce")
class Reduce(Compute):
    style = "reduce"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(2)
        mode = args.word()
        if mode.text not in _MODES:
            args.fail(f"Unknown compute reduce mode: {mode.text}", mode, hint=" ".join(_MODES))
        self.mode = mode.text
        words = []
        while (word := args.peek()) is not None and (word.text in _PLAIN or re.match(r"[cfv]_", word.text)):
            words.append(args.word())
        self.local_inputs = False
        while len(args):
            key = args.word()
            if key.text == "replace":
                raise Unsupported("LAMMPS has compute reduce replace, pylmp's native engines do not", key.span)
            if key.text != "inputs":
                args.fail(f"Unknown compute reduce keyword: {key.text}", key, hint="inputs peratom|local")
            value = args.word()
            if value.text not in ("peratom", "local"):
                args.illegal(value, hint="inputs peratom or inputs local")
            self.local_inputs = value.text == "local"
        if not words:
            args.missing()
        self.inputs = [self._input(sim, args, word) for word in words]
        self.length = len(self.inputs)
        if self.length > 1:
            self.scalar = None  # type: ignore[method-assign,assignment]
        else:
            self.vector = None  # type: ignore[method-assign,assignment]
        self.extensive_scalar = self.extensive_vector = self.mode in ("sum", "sumsq", "sumabs")

    def _input(self, sim: Simulation, args: Args, word: Word) -> tuple[str, str, int]:
        """(kind, name, column from 1, 0 for a vector); kind is plain, c or f."""
        if word.text in _PLAIN:
            return "plain", word.text, 0
        found = re.fullmatch(r"([cfv])_([A-Za-z0-9_]+)(?:\[(\d+)\])?", word.text)
        if not found:
            args.illegal(word)
        if found[1] == "v":
            raise Unsupported("LAMMPS has variables in compute reduce, pylmp's native engines do not", word.span)
        kind, name = found[1], found[2]
        source = self._source(sim, kind, name)
        if source is None:
            what = "Compute" if kind == "c" else "Fix"
            args.fail(f"{what} ID {name} for compute reduce does not exist", word)
        wanted = "local" if self.local_inputs else "per_atom"
        if getattr(source, wanted, None) is None:
            values = "local" if self.local_inputs else "per-atom"
            what = "compute" if kind == "c" else "fix"
            args.fail(
                f"Compute reduce {what} {name} does not calculate {values} values", word,
                hint="inputs local" if not self.local_inputs and hasattr(source, "local") else "",
            )  # fmt: skip
        return kind, name, int(found[3] or 0)

    @staticmethod
    def _source(sim: Simulation, kind: str, name: str) -> Any:
        if kind == "c":
            return sim.computes.get(name)
        return next((fix for fix in sim.fixes if fix.id == name), None)

    def _values(self, sim: Simulation, item: tuple[str, str, int]) -> Floats:
        kind, name, column = item
        if kind == "plain":
            array, axis = _PLAIN[name]
            return np.asarray(getattr(sim.atoms, array)[: sim.atoms.n, axis][self.members(sim)])
        source = self._source(sim, kind, name)
        if source is None:
            raise ScriptError(f"{'Compute' if kind == 'c' else 'Fix'} ID {name} for compute reduce does not exist")
        values = source.local(sim) if self.local_inputs else source.per_atom(sim)
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
        if mode.startswith("ave") and len(values):
            result = result / len(values)
        return result

    def scalar(self, sim: Simulation) -> float:  # type: ignore[no-redef]
        return self._reduce(self._values(sim, self.inputs[0]))

    def vector(self, sim: Simulation) -> Floats:  # type: ignore[no-redef]
        return np.array([self._reduce(self._values(sim, item)) for item in self.inputs])
