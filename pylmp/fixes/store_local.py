"""The internal fix STORE/LOCAL of bond_style bpm/...'s keyword store/local: a record of every broken bond.

Records accumulate; on steps divisible by N those since the last such step become visible as f_ID. Source: LAMMPS manual,
bond_bpm_spring.html; when records show, as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.bond import beside
from pylmp.model.bond_memory import PER_ATOM, PLACES, PLACES_ID
from pylmp.model.fix import Fix


class StoreLocal(Fix):
    """local(sim): (rows,) with one attribute, else (rows, attributes); all float64."""

    style = "STORE/LOCAL"
    internal = True

    def __init__(self, sim: Any, identity: str, every: int, attributes: tuple[str, ...]) -> None:
        self.id, self.group, self.bit = identity, "all", 1
        self.interval = self.pause = every
        self.attributes = attributes
        self.columns = len(attributes)
        self.compatible_every = every
        self._records: list[list[float]] = []
        self._visible: list[list[float]] = []
        if any(name.endswith("/ref") for name in attributes):
            reference = np.zeros((sim.atoms.capacity, 3))
            reference[: sim.atoms.n] = sim.atoms.x[: sim.atoms.n]
            sim.atoms.extra[PLACES] = reference
            if sim.waiting is not None and (kept := sim.waiting.take_atoms(sim, PLACES_ID, PER_ATOM, 3)) is not None:
                reference[: sim.atoms.n] = kept

    def record(self, sim: Any, i: int, j: int) -> None:
        """Note the broken bond of rows i (the lower ID) and j; either may be a ghost."""
        atoms = sim.atoms
        middle = [(float(a) + float(b)) / 2 for a, b in zip(atoms.x[i], beside(sim, i, j), strict=True)]
        values: dict[str, float] = {
            "id1": float(atoms.tag[i]), "id2": float(atoms.tag[j]), "time": float(sim.step),
            "x": middle[0], "y": middle[1], "z": middle[2],
        }  # fmt: skip
        if PLACES in atoms.extra:
            rows = sim.lists.ghosts.first[[int(atoms.tag[i]), int(atoms.tag[j])]]
            ends = atoms.extra[PLACES][rows]
            for name, a, b in zip(("x/ref", "y/ref", "z/ref"), ends[0], ends[1], strict=True):
                values[name] = (float(a) + float(b)) / 2
        self._records.append([values[name] for name in self.attributes])

    def post_force(self, sim: Any) -> None:
        if sim.step % self.interval == 0:
            self._visible, self._records = self._records, []

    def local(self, sim: Any) -> Floats:
        rows = np.array(self._visible).reshape(len(self._visible), self.columns)
        return rows[:, 0] if self.columns == 1 else rows
