"""Per-atom values of computes, fixes and variables, as dumps read them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from pylmp.model.atoms import Ints
from pylmp.model.compute import current
from pylmp.model.reference import Reference, length, offers
from pylmp.model.simulation import Simulation
from pylmp.model.variables import Variables
from pylmp.text.words import Args, Word

# What LAMMPS says of a reference that does not fit. {style} of the dump; {what} compute or fix; {name} its ID.
ATTRIBUTE = {
    "missing": "Could not find dump {style} {what} ID: {name}", "variable": "Could not find dump {style} variable name {name}",
    "style": "Dump {style} variable {name} is not atom-style variable", "kind": "Dump {style} {what} {name} does not compute per-atom info",
    "vector": "Dump {style} {what} {name} does not calculate per-atom vector",
    "array": "Dump {style} {what} {name} does not calculate per-atom array", "range": "Dump {style} {what} {name} vector is accessed out-of-range",
}  # fmt: skip


def per_atom(
    sim: Simulation, args: Args, word: Word, found: Reference, says: Mapping[str, str], bit: int, style: str = ""
) -> Callable[..., Any]:
    """values(simulation, rows, known) of a per-atom vector, or a column of a per-atom array. Raises ScriptError where there is none.

    bit: of the dump's group, for whose atoms variables are evaluated
    """

    def fail(key: str, hint: str = "") -> None:
        colon = ":" if found.kind == "f" else ""  # LAMMPS's own
        args.fail(says[key].format(style=style, what=found.what, name=found.name, colon=colon), word, hint=hint)

    if found.kind == "v":
        kind = Variables(sim).style(found.name)
        if kind is None:
            fail("variable", f"variable {found.name} atom ...")
        if kind not in ("atom", "atomfile") or found.index:
            fail("style", f"variable {found.name} atom ...")
        return _evaluated(found, bit)
    source = found.source(sim)
    if source is None:
        fail("missing")
    if not offers(source, "per_atom"):
        fail("kind")
    columns = length(sim, source, "per_atom")
    if not found.index and columns:
        fail("vector", f"{word.text}[*]")
    if found.index and not columns:
        fail("array", word.text.split("[")[0])
    if found.index and not 1 <= found.index[0] <= columns:
        fail("range", f"1 to {columns}")
    return _evaluated(found, bit)


def _evaluated(found: Reference, bit: int) -> Callable[..., Any]:
    key = (found.kind, found.name)

    def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
        store = known.setdefault("sources", {})
        if key not in store:
            if found.kind == "v":
                members = np.flatnonzero((sim.atoms.mask[: sim.atoms.n] & bit) != 0)
                store[key] = np.zeros(sim.atoms.n)
                store[key][members] = Variables(sim).per_atom(found.name, members)
            else:
                store[key] = current(sim, found.source(sim), "per_atom")
        return store[key][rows] if not found.index else store[key][rows, found.index[0] - 1]

    return values
