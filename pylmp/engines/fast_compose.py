"""Which loops over forces a scene needs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.kernels.fast.choosing import few_types
from pylmp.kernels.fast.forces import force_loop
from pylmp.kernels.fast.terms import BondTerm, PairTerm, idle, joined

if TYPE_CHECKING:
    from pylmp.engines.fast_bonds import FastBonds
    from pylmp.kernels.kinds import Function
    from pylmp.model.atoms import Floats
    from pylmp.model.pair import PairPart
    from pylmp.model.simulation import Simulation


def table_of(parts: list[PairPart]) -> tuple[Floats, list[int]]:
    """(nt+1, nt+1, width) what the joined law of parts receives, and how much of it each of them."""
    tables = [part.table for part in parts] or [np.zeros((8, 8, 0))]
    return tables[0] if len(tables) == 1 else np.concatenate(tables, axis=2), [part.width for part in parts]


class Composer:
    """Composes loops from the laws of pair styles (parts) and of bond styles over the neighbor list (lists)."""

    def __init__(self, sim: Simulation, parts: list[PairPart], bonds: list[FastBonds], lists: Any, ghosts: bool) -> None:
        self._sim, self._parts, self._bonds, self._lists, self._ghosts = sim, parts, bonds, lists, ghosts
        self._periodic = (False, False, False) if ghosts else sim.box.periodic

    def loops(self, level: int) -> list[Function]:
        """A loop for each bond style, the first one over pairs too."""
        alone = joined([part.alone for part in self._parts], table_of(self._parts)[1]) if self._parts else None
        term = self._pair_term(self._parts)
        weighted = self._lists is not None and self._lists.weighted
        bonds: list[BondTerm | None] = [*(listed.term(self._sim, alone) for listed in self._bonds)] or [None]
        return [
            force_loop(term, bond, self._periodic, level, listed=k == 0, weighted=weighted, adds=k > 0)
            for k, bond in enumerate(bonds)
        ]  # fmt: skip

    def of_each_pair_style(self) -> list[Function]:
        """Of several pair styles, a loop for each that sums its energy alone."""
        instead = BondTerm(idle, 0, 0, False, 1, False, False, True, None, None)
        bond = instead if self._bonds and self._bonds[0].part.updates_special else None
        return [force_loop(self._pair_term([part]), bond, self._periodic, 1, weighted=self._lists.weighted) for part in self._parts]

    def _pair_term(self, parts: list[PairPart]) -> PairTerm | None:
        if not parts:
            return None
        widths = [part.width for part in parts]
        law = joined([part.law for part in parts], widths)
        packed = not self._ghosts and self._lists.types > 1
        velocity = any(part.style.velocity for part in parts)
        return PairTerm(law, sum(widths), velocity, few_types(self._sim.atom_types), packed)
