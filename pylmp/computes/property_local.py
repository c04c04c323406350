"""compute ID GROUP property/local natom1..., batom1 batom2 btype: a row a bond, in local atom and slot order.

Source: LAMMPS manual, compute_property_local.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.bond import bond_pairs
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args

_ELSEWHERE = ("natom", "ntype", "patom", "ptype")


def rows_of_bonds(sim: Simulation, inside, wanted) -> tuple[Ints, Ints, Ints]:  # type: ignore[no-untyped-def]
    """(rows, slots, partner rows) of bonds with both atoms inside, each bond once, types as wanted."""
    rows, slots, partners = bond_pairs(sim, wanted)
    keep = (partners >= 0) & inside[rows] & inside[partners]
    if not sim.newton_bond:
        keep &= sim.atoms.tag[rows] < sim.atoms.bond_atom[rows, slots]
    return rows[keep], slots[keep], partners[keep]


@COMPUTES.register("property/local")
class PropertyLocal(Compute):
    style = "property/local"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        self.names: list[str] = []
        for word in args.rest():
            if word.text not in ("batom1", "batom2", "btype"):
                if word.text.rstrip("1234") in ("aatom", "atype", "datom", "dtype", "iatom", "itype"):
                    args.fail(
                        "Compute property/local for property that isn't allocated", word, hint="batom1 batom2 btype"
                    )
                if word.text.rstrip("1234") in _ELSEWHERE and self.names:
                    args.fail("Compute property/local cannot use these inputs together", word)
                if word.text.rstrip("1234") in _ELSEWHERE or word.text == "cutoff":
                    raise Unsupported(
                        f"LAMMPS has compute property/local {word.text}, pylmp's native engines do not", word.span
                    )
                args.fail(f"Unknown compute property/local keyword: {word.text}", word, hint="batom1 batom2 btype")
            self.names.append(word.text)
        if not sim.has_bonds:
            args.fail("Compute property/local for property that isn't allocated", args.owner, hint="atom_style bond")
        self.columns = len(self.names)

    def local(self, sim: Simulation) -> Floats:
        """(rows,) or (rows, columns): IDs and types; broken bonds (type 0) are left out."""
        atoms = sim.atoms
        rows, slots, _ = rows_of_bonds(sim, self.members(sim), lambda kinds: kinds != 0)
        values = {
            "batom1": atoms.tag[rows], "batom2": atoms.bond_atom[rows, slots], "btype": atoms.bond_type[rows, slots],
        }  # fmt: skip
        table = np.stack([values[name].astype(float) for name in self.names], axis=1)
        return table[:, 0] if self.columns == 1 else table
