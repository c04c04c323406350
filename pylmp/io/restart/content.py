"""A restart file as a value: what it says, without any simulation."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass
class Force:
    """One force field as the file holds it.

    style     LAMMPS's name
    settings  numbers that stand first, by name, in order
    columns   a bond-like style: one list of coefficients over types for each coefficient
    pairs     a pair style: the numbers of every pair of types that was given coefficients
    parts     hybrid: the styles side by side, settings only
    """

    style: str
    settings: dict[str, float] = field(default_factory=dict)
    columns: list[list[float]] = field(default_factory=list)
    pairs: dict[tuple[int, int], list[float]] = field(default_factory=dict)
    parts: list[Force] = field(default_factory=list)


@dataclass
class Kept:
    """What one fix keeps per atom. values (n, width) float64; rows of some atoms may be shorter, counts (n,) says how long."""

    identity: str
    style: str
    width: int
    values: Floats = field(default_factory=lambda: np.zeros((0, 0)))
    counts: Ints = field(default_factory=lambda: np.zeros(0, np.int64))


@dataclass
class Content:
    """header    by the names of layout.HEADER, in the order of the file; "atom style" is (name, its words)
    groups    slot of each group name
    mass      (types,)
    labels    type labels as the file lists them, or None
    forces    by kind (pair bond angle dihedral improper), in the order of the file
    fixes     (ID, style, state) of fixes that keep a global state
    atoms     per-atom arrays over all atoms in the order of the file: x (n, 3), id, type, mask, image (n, 3), v, and what the
              style carries: q, molecule, num_bond, bond_type (n, most), bond_atom (n, most, 1), ... (angle_atom (n, most, 3))
    kept      what fixes keep per atom
    files     0: all in one file; else how many files hold the atoms
    """

    header: dict[str, Any] = field(default_factory=dict)
    groups: dict[str, int] = field(default_factory=dict)
    mass: list[float] = field(default_factory=list)
    labels: list[str] | None = None
    forces: dict[str, Force] = field(default_factory=dict)
    fixes: list[tuple[str, str, bytes]] = field(default_factory=list)
    atoms: dict[str, Any] = field(default_factory=dict)
    kept: list[Kept] = field(default_factory=list)
    files: int = 0

    @property
    def n(self) -> int:
        return len(self.atoms["id"]) if self.atoms else 0
