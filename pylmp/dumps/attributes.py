"""What dump custom can print of an atom. Source: LAMMPS manual, dump.html.

Scaled coordinates are (x - lo)*(1/L), fractions of the cell vectors in a triclinic box; unwrapped ones x + image*L; of xsu
LAMMPS loses the last digits by adding and subtracting 512, which is done here too.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.dumps.frame import NAME, REAL, WHOLE, Field
from pylmp.model.atoms import Ints
from pylmp.model.simulation import Simulation

_IMAGE_BIAS = 512  # LAMMPS packs three image flags into one integer


def _array(name: str, d: int | None = None) -> Callable[..., Any]:
    def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
        array = getattr(sim.atoms, name)
        return array[rows] if d is None else array[rows, d]

    return values


def _scaled(d: int) -> Callable[..., Any]:
    def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
        if "fractions" not in known:
            known["fractions"] = sim.box.fractions(sim.atoms.x[rows])
        return known["fractions"][:, d]

    return values


def _unwrapped(d: int) -> Callable[..., Any]:
    def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
        if "unwrapped" not in known:
            known["unwrapped"] = sim.box.unwrap(sim.atoms.x[rows], sim.atoms.image[rows])
        return known["unwrapped"][:, d]

    return values


def _scaled_unwrapped(d: int) -> Callable[..., Any]:
    scaled = _scaled(d)

    def values(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
        return (scaled(sim, rows, known) + (sim.atoms.image[rows, d] + _IMAGE_BIAS)) - _IMAGE_BIAS

    return values


def _constant(value: int) -> Callable[..., Any]:
    return lambda sim, rows, known: np.full(len(rows), value)


def _type_labels(sim: Simulation, rows: Ints, known: dict[Any, Any]) -> Any:
    labels = sim.labels.of("atom")
    return np.array([labels.get(number, "") for number in range(sim.atom_types + 1)], dtype=object)[sim.atoms.type[rows]]


def _all() -> dict[str, Field]:
    fields = [
        Field("id", _array("tag"), WHOLE),
        Field("mol", _array("molecule"), WHOLE),
        Field("type", _array("type"), WHOLE),
        Field("q", _array("q")),
        Field("typelabel", _type_labels, NAME),
        Field("element", lambda sim, rows, known: known["elements"][sim.atoms.type[rows]], NAME),
        Field("mass", lambda sim, rows, known: sim.mass[sim.atoms.type[rows]], REAL),
        Field("proc", _constant(0), WHOLE),
        Field("procp1", _constant(1), WHOLE),
    ]
    for d, axis in enumerate("xyz"):
        fields += [
            Field(axis, _array("x", d)),
            Field(f"{axis}s", _scaled(d)),
            Field(f"{axis}u", _unwrapped(d)),
            Field(f"{axis}su", _scaled_unwrapped(d)),
            Field(f"i{axis}", _array("image", d), WHOLE),
            Field(f"v{axis}", _array("v", d)),
            Field(f"f{axis}", _array("f", d)),
        ]
    return {field.name: field for field in fields}


ATTRIBUTES = _all()

# Attributes of atom styles that pylmp does not have.
NOT_ALLOCATED = (
    "mux", "muy", "muz", "mu", "radius", "diameter", "heatflow", "temperature", "omegax", "omegay", "omegaz",
    "angmomx", "angmomy", "angmomz", "tqx", "tqy", "tqz",
)  # fmt: skip


def absent(sim: Simulation, name: str) -> bool:
    """An attribute that the atom style does not have."""
    return name in NOT_ALLOCATED or (name == "mol" and not sim.has_bonds) or (name == "q" and not sim.style.charged)
