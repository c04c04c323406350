"""compute ID GROUP property/local values...: a row a bond, angle, dihedral or improper, in local atom and slot order.

batom1 batom2 btype; aatom1 aatom2 aatom3 atype; datom1 .. datom4 dtype; iatom1 .. iatom4 itype: of one kind only. natom1 natom2
ntype1 ntype2: a row a neighbor pair; patom1 patom2 ptype1 ptype2: those within the pair style's cutoff.
Source: LAMMPS manual, compute_property_local.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.computes.pair_local import pairs_of, read_cutoff
from pylmp.model.atoms import Floats, Ints
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.topology import BOND, KINDS, Entries, Kind, Wanted, entries
from pylmp.model.wish import Wish
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_COLUMNS = {
    f"{kind.name[0]}{what}": (kind, column)
    for kind in KINDS
    for column, what in enumerate(["type", *(f"atom{k + 1}" for k in range(kind.size))])
}
_PAIRS = {f"{letter}{what}": (letter, column) for letter in "np" for column, what in enumerate(("atom1", "atom2", "type1", "type2"))}


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
        self.kind: Kind | str | None = None  # n or p: pairs
        self.picked: list[int] = []  # columns: 0 the type, then the atoms
        while (word := args.peek()) is not None and (word.text in _COLUMNS or word.text in _PAIRS):
            kind, column = _COLUMNS[word.text] if word.text in _COLUMNS else _PAIRS[word.text]
            if self.kind is not None and kind is not self.kind:
                args.fail("Compute property/local cannot use these inputs together", word)
            self.kind = kind
            self.picked.append(column)
            args.word()
        while len(args):
            read_cutoff(self, args)
        if isinstance(self.kind, Kind) and self.kind not in sim.style.kinds:
            hint = f"atom_style {sim.atom_style} stores none"
            args.fail("Compute property/local for property that isn't allocated", args.owner, hint=hint)
        self.columns = len(self.picked)

    def wish(self, sim: Simulation) -> Wish | None:
        return Wish() if isinstance(self.kind, str) else None

    def init(self, sim: Simulation) -> None:
        if isinstance(self.kind, str) and sim.pair is None:
            raise ScriptError("No pair style is defined for compute property/local", hint="pair_style comes first")

    def local(self, sim: Simulation) -> Floats:
        """(rows,) or (rows, columns): IDs and types; broken bonds (type 0) are left out."""
        assert self.kind is not None
        if isinstance(self.kind, str):
            pairs, atoms = pairs_of(sim, self.members(sim), self.bit, self.kind == "p"), sim.atoms
            whole = [atoms.tag[pairs.i], atoms.tag[pairs.j], atoms.type[pairs.i], atoms.type[pairs.j]]
        else:
            found = counted(sim, self.kind, self.members(sim), lambda types: types != 0)
            whole = [found.types, found.tags]
        table = np.column_stack(whole)[:, self.picked].astype(float)
        return table[:, 0] if self.columns == 1 else table
