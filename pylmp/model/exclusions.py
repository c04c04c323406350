"""Pairs that neigh_modify exclude keeps out of neighbor lists. Source: LAMMPS manual, neigh_modify.html."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Ints
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


@dataclass
class Exclusions:
    """types: pairs of atom types; groups: pairs of group bits; intra, inter: group bits, both atoms in it and in the same molecule,
    in different ones."""

    types: list[tuple[int, int]] = field(default_factory=list)
    groups: list[tuple[int, int]] = field(default_factory=list)
    intra: list[int] = field(default_factory=list)
    inter: list[int] = field(default_factory=list)

    def __bool__(self) -> bool:
        return bool(self.types or self.groups or self.intra or self.inter)

    def check(self, sim: Simulation) -> None:
        """At the start of a run. Raises ScriptError."""
        if any(not 1 <= kind <= sim.atom_types for pair in self.types for kind in pair):
            raise ScriptError(
                "Invalid atom type in neighbor exclusion list",
                hint=f"types are 1 to {sim.atom_types}",
                manual="neigh_modify.html",
            )

    def drop(self, sim: Simulation, i: Ints, j: Ints) -> NDArray[np.bool_]:
        """(k,) bool: which pairs of owned rows i and rows j are to be left out."""
        atoms = sim.atoms
        out = np.zeros(len(i), bool)
        if self.types:
            table = np.zeros((sim.atom_types + 1, sim.atom_types + 1), bool)
            for one, other in self.types:
                table[one, other] = table[other, one] = True
            out |= table[atoms.type[i], atoms.type[j]]
        for one, other in self.groups:
            a, b = (atoms.mask & one) != 0, (atoms.mask & other) != 0
            out |= (a[i] & b[j]) | (b[i] & a[j])
        if self.intra or self.inter:
            molecule = atoms.molecule[atoms.rows_by_tag()[atoms.tag[: atoms.total]]]  # of ghosts too
            same = molecule[i] == molecule[j]
            for bits, wanted in ((self.intra, same), (self.inter, ~same)):
                for bit in bits:
                    chosen = (atoms.mask & bit) != 0
                    out |= chosen[i] & chosen[j] & wanted
        return out
