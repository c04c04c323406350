"""compute ID GROUP property/local values...: a row a bond, angle, dihedral or improper, in local atom and slot order.

batom1 batom2 btype; aatom1 aatom2 aatom3 atype; datom1 .. datom4 dtype; iatom1 .. iatom4 itype: of one kind only.
Source: LAMMPS manual, compute_property_local.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.topology import BOND, KINDS, Entries, Kind, Wanted, entries
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args

_COLUMNS = {
    f"{kind.name[0]}{what}": (kind, column)
    for kind in KINDS
    for column, what in enumerate(["type", *(f"atom{k + 1}" for k in range(kind.size))])
}
_ELSEWHERE = tuple(f"{letter}{what}" for letter in "np" for what in ("atom1", "atom2", "type1", "type2"))


def counted(sim: Simulation, kind: Kind, inside, wanted: Wanted | None) -> Entries:  # type: ignore[no-untyped-def]
    """Those of a kind whose atoms all are inside, each once, types as wanted."""
    found = entries(sim, kind, wanted).once(sim)
    at = found.at(sim)
    return found.take((at >= 0).all(axis=1) & inside[at].all(axis=1))


def rows_of_bonds(sim: Simulation, inside, wanted: Wanted) -> tuple[Ints, Ints, Ints]:  # type: ignore[no-untyped-def]
    """(rows, slots, partner rows) of bonds with both atoms inside, each bond once, types as wanted."""
    found = counted(sim, BOND, inside, wanted)
    return found.rows, found.slots, found.at(sim)[:, 1]


@COMPUTES.register("property/local")
class PropertyLocal(Compute):
    style = "property/local"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        self.kind: Kind | None = None
        self.picked: list[int] = []  # columns: 0 the type, then the atoms
        for word in args.rest():
            kind, column = _COLUMNS.get(word.text, (None, 0))
            if kind is None and word.text not in (*_ELSEWHERE, "cutoff"):
                hint = "batom1 batom2 btype aatom1 .. atype datom1 .. dtype iatom1 .. itype"
                args.fail(f"Unknown compute property/local keyword: {word.text}", word, hint=hint)
            if self.kind is not None and kind is not self.kind:
                args.fail("Compute property/local cannot use these inputs together", word)
            if kind is None:
                says = f"LAMMPS has compute property/local {word.text}, pylmp's native engines do not"
                raise Unsupported(says, word.span)
            self.kind = kind
            self.picked.append(column)
        if self.kind not in sim.style.kinds:
            hint = f"atom_style {sim.atom_style} stores none"
            args.fail("Compute property/local for property that isn't allocated", args.owner, hint=hint)
        self.columns = len(self.picked)

    def local(self, sim: Simulation) -> Floats:
        """(rows,) or (rows, columns): IDs and types; broken bonds (type 0) are left out."""
        assert self.kind is not None
        found = counted(sim, self.kind, self.members(sim), lambda types: types != 0)
        table = np.column_stack([found.types, found.tags])[:, self.picked].astype(float)
        return table[:, 0] if self.columns == 1 else table
