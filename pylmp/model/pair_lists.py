"""Which neighbor lists the pair styles need, and which of these are made from others.

Every style of a hybrid asks for a list of its own. LAMMPS builds as few as it can: a style that acts on some types only gets
what a fuller list has of them (skip); one that needs just what another has shares it (copy), or takes what lies within its own
cutoff (trim). Which list is made how decides the order of its entries, and so the last bits of forces. As measured on LAMMPS
22 Jul 2025.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.exact.neighbor import FULL, HALF, HALF_OWNED
from pylmp.kernels.kinds import Function
from pylmp.model.derived_lists import DerivedList, SkipList, TrimList
from pylmp.model.neighbor import NeighborList
from pylmp.model.pair import PairPart, Types
from pylmp.text.diagnostic import Unsupported

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

AnyList = NeighborList | DerivedList

BUILD, SKIP, COPY, TRIM = "", "skip", "copy", "trim"


@dataclass(eq=False)
class Planned:
    """part: whose it is; None: the full one that others are made from. skipped: pairs of types it leaves out.

    cut: its one cutoff for all types without the skin, 0.0: each pair of types has its own. how: made from origin.
    asked: the cutoff that the style of a hybrid asked for, 0.0 for none.
    """

    part: PairPart | None
    skipped: frozenset[Types]
    cut: float
    how: str = BUILD
    origin: Planned | None = None
    full: bool = False
    asked: float = 0.0

    def made_from(self, how: str, origin: Planned) -> None:
        self.how, self.origin = how, origin


def plan(sim: Simulation) -> list[Planned]:
    """The lists in the order in which the log numbers them."""
    parts: list[PairPart] = sim.pair.parts
    types = range(1, sim.atom_types + 1)
    pairs = [(i, j) for i in types for j in types if i <= j]
    largest = [float(part.cut.max()) for part in parts]
    needed = float(sim.pair.cut.max())
    least = min(float(np.min([sim.pair.cut[pair] for pair in pairs])), *largest)
    lists = []
    for part, cut in zip(parts, largest, strict=True):
        skipped = frozenset(pair for pair in pairs if pair not in part.mine and not _left_to_mixing(sim, part, pair))
        asked = cut if sim.pair.hybrid and part.settings.trim else 0.0
        own = asked if not skipped and asked > least else 0.0
        lists.append(Planned(part, skipped, own, full=bool(part.options.get("full")), asked=asked))
    if len(lists) > 1 and any(planned.full for planned in lists):
        raise Unsupported("LAMMPS has pair_style zero full under hybrid, pylmp's native engines do not", hint="zero without full")
    rest: list[Planned] = []
    order = _sorted(lists, needed)
    for k, wanted in enumerate(lists):
        before = [other for other in order if any(other is earlier for earlier in lists[:k])]
        if wanted.skipped:
            _some_types(wanted, before, order, needed, rest)
        elif not wanted.cut:
            _all_pairs(wanted, before, needed)
        else:
            _within(wanted, order)
    return lists + rest


def _sorted(lists: list[Planned], needed: float) -> list[Planned]:
    """The order in which LAMMPS looks for a list to make another one from: by cutoff, sorted by exchanges (ties change places)."""
    order = list(lists)
    for i in range(len(order)):
        least, at = needed, i
        for j in range(i, len(order)):
            cut = order[j].cut or needed
            if cut < least:
                least, at = cut, j
        order[i], order[at] = order[at], order[i]
    return order


def _left_to_mixing(sim: Simulation, part: PairPart, pair: Types) -> bool:
    """Nothing acts on these types, but LAMMPS lists them: it thinks of mixing them."""
    acting = sim.pair.acting
    return not acting.get(pair) and all(acting.get((kind, kind)) == [part] for kind in pair)


def _some_types(wanted: Planned, before: list[Planned], lists: list[Planned], needed: float, rest: list[Planned]) -> None:
    for other in before:
        if other.skipped == wanted.skipped:
            return wanted.made_from(COPY, other)
    for other in lists:
        if not other.skipped and (not other.cut or other.cut >= needed):
            return wanted.made_from(SKIP, other)
    if not rest:
        rest.append(Planned(None, frozenset(), 0.0))
    return wanted.made_from(SKIP, rest[0])


def _all_pairs(wanted: Planned, before: list[Planned], needed: float) -> None:
    for other in before:
        if not other.skipped and (not other.cut or other.cut >= needed):
            return wanted.made_from(COPY, other)


def _within(wanted: Planned, lists: list[Planned]) -> None:
    """Where several styles would copy each other in a circle, LAMMPS fails; here the last of them is built."""
    for other in lists:
        if other is not wanted and not other.skipped and other.cut >= wanted.cut and not _from(other, wanted):
            return wanted.made_from(COPY if other.cut == wanted.cut else TRIM, other)


def _from(one: Planned, other: Planned) -> bool:
    """one is made from other, directly or not."""
    while one.origin is not None:
        one = one.origin
        if one is other:
            return True
    return False


def reaches(sim: Simulation, cut: float) -> bool:
    """A list with that cutoff for all types, 0.0: with each pair's own, holds all pairs within the largest one."""
    return not cut or cut >= float(sim.pair.cut.max())


class PairLists:
    """The neighbor lists of a run. all: those that are built, in this order. whole: a half list of all pairs, or None."""

    def __init__(self, sim: Simulation) -> None:
        planned = plan(sim)
        self._made: dict[Planned, AnyList] = {}
        self.all: list[AnyList] = []
        for one in planned:
            self._make(sim, one)
        self._of = {one.part: self._made[one] for one in planned}
        whole = [one for one in planned if one.part is not None and not one.skipped]
        plain = [one for one in planned if one.origin is None and not one.full and reaches(sim, one.cut)]
        self.whole = next((one for one in map(self._made.get, plain) if isinstance(one, NeighborList)), None)
        self._half = next((self._made[one] for one in whole if not one.full), None)
        self._full = next((self._made[one] for one in whole if one.full), None)

    @property
    def half(self) -> int | None:
        """Entries that the log reports at the end of a run: LAMMPS looks at the first list of a style that acts on all types."""
        return self._half.count if self._half else None

    @property
    def full(self) -> int | None:
        return self._full.count if self._full else None

    def of(self, part: PairPart) -> AnyList:
        return self._of[part]

    def functions(self) -> list[Function]:
        return [function for one in self.all for function in one.functions()]

    def build(self, sim: Simulation, ghost_cutoff: float) -> None:
        for one in self.all:
            one.build(sim, ghost_cutoff)

    def _make(self, sim: Simulation, planned: Planned) -> AnyList:
        if planned in self._made:
            return self._made[planned]
        made: AnyList
        if planned.origin is None:
            mode = FULL if planned.full else HALF if sim.newton_pair else HALF_OWNED
            made = NeighborList(sim, mode, planned.cut + sim.neighbor.skin if planned.cut else 0.0)
        else:
            source = self._make(sim, planned.origin)
            if planned.how == COPY:
                made = source
            elif planned.how == TRIM:
                made = TrimList(source, planned.cut + sim.neighbor.skin)
            else:
                made = SkipList(source, planned.part.cut if planned.part else sim.pair.cut)
        if made not in self.all:
            self.all.append(made)
        self._made[planned] = made
        return made
