"""dump_modify thresh ATTRIBUTE OPERATOR VALUE|LAST: which atoms a frame holds. Source: LAMMPS manual, dump_modify.html."""

from __future__ import annotations

import operator
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.dumps.attributes import ATTRIBUTES, absent
from pylmp.dumps.sources import per_atom
from pylmp.model.reference import Reference, parse
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

Chosen = NDArray[np.bool_]


def _differ(a: Any, b: Any) -> Any:
    """One is zero, the other is not."""
    return (a == 0.0) != (b == 0.0)


_OPERATORS: dict[str, Callable[[Any, Any], Any]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "==": operator.eq, "!=": operator.ne,
    "|^": _differ,
}  # fmt: skip


@dataclass
class Threshold:
    """Atoms are kept whose attribute stands to value as the operator says.

    value   a number; None: LAST, the attribute of the same atom when the last frame was due, at first what it is then
    key     where that is kept with the atoms
    source  the compute, fix or variable of the attribute, None: a property of atoms
    """

    name: str
    values: Callable[..., Any]
    compare: Callable[[Any, Any], Any]
    value: float | None
    key: str
    source: Reference | None = None
    begun: bool = field(default=False)

    def keep(self, sim: Simulation, chosen: Chosen, known: dict[Any, Any]) -> Chosen:
        """chosen (n,) without the atoms that do not pass."""
        n = sim.atoms.n
        if absent(sim, self.name):
            raise ScriptError("Threshold for an atom property that isn't allocated", hint=f"{self.name}: other atom styles have it")
        now = np.asarray(self.values(sim, np.arange(n), {"sources": known.setdefault("sources", {})}), float)
        if self.value is not None:
            return chosen & np.asarray(self.compare(now, self.value), bool)
        stored = sim.atoms.extra.get(self.key)
        before = np.asarray(stored[:n], float) if self.begun and stored is not None else now
        fresh = np.zeros(sim.atoms.capacity)
        fresh[:n] = now
        sim.atoms.extra[self.key] = fresh
        self.begun = True
        return chosen & np.asarray(self.compare(now, before), bool)


def read_threshold(sim: Simulation, args: Args, key: str, bit: int) -> Threshold | None:
    """The words after ``thresh``; None for ``thresh none``."""
    word = args.word()
    if word.text == "none":
        return None
    if len(args) < 2:
        args.fail("Illegal dump_modify thresh command: missing argument(s)", word, hint="thresh ATTRIBUTE OPERATOR VALUE")
    values, source = _attribute(sim, args, word, bit)
    sign = args.word()
    if sign.text not in _OPERATORS:
        args.fail("Invalid dump_modify thresh operator", sign, hint=" ".join(_OPERATORS))
    limit = args.word()
    value = None if limit.text == "LAST" else args.as_number(limit)
    return Threshold(word.text, values, _OPERATORS[sign.text], value, key, source)


def _attribute(sim: Simulation, args: Args, word: Word, bit: int) -> tuple[Callable[..., Any], Reference | None]:
    name = word.text
    if absent(sim, name):
        return (lambda sim, rows, known: np.zeros(len(rows))), None
    if name in ATTRIBUTES and name not in ("element", "typelabel"):
        return ATTRIBUTES[name].values, None
    if name[:2] in ("i_", "d_") or name[:3] in ("i2_", "d2_"):
        args.fail(f"Could not find custom per-atom property ID: {name.split('_', 1)[1].split('[')[0]}", word)
    found = parse(name)
    if found is None or "*" in name:
        args.fail(f"Invalid dump_modify thresh attribute: {name}", word, hint=" ".join(ATTRIBUTES))
    return per_atom(sim, args, word, found, THRESHOLD, bit), found


# What LAMMPS says of a reference that does not fit. {what} compute, fix; {name} its ID.
THRESHOLD = {
    "missing": "Could not find dump modify {what} ID{colon} {name}", "variable": "Could not find dump modify variable name: {name}",
    "style": "Dump modify variable {name} is not atom-style variable", "kind": "Dump modify {what} ID {name} does not compute per-atom info",
    "vector": "Dump modify {what} ID {name} does not compute per-atom vector",
    "array": "Dump modify {what} ID {name} does not compute per-atom array", "range": "Dump modify {what} ID {name} vector is not large enough",
}  # fmt: skip
