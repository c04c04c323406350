"""compute ID GROUP nbond/atom [bond/type N]: how many bonds each atom has. Source: LAMMPS manual, compute_nbond_atom.html."""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.bond import bond_pairs
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@COMPUTES.register("nbond/atom")
class BondsOfAtom(Compute):
    style = "nbond/atom"
    columns = 0

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if not sim.has_bonds:
            args.fail("Compute nbond/atom used in system without bonds", args.owner, hint="atom_style bond")
        self.kind = 0
        while len(args):
            key = args.word()
            if key.text != "bond/type":
                args.fail(f"Unknown compute nbond/atom command {key.text}", key, hint="bond/type N")
            args.need(1, key.text)
            self.kind = args.integer()

    def per_atom(self, sim: Simulation) -> Floats:
        """(n,) bonds of each atom, both ends counted, broken and turned-off ones not."""

        def wanted(kinds):
            return (kinds > 0) if self.kind == 0 else (kinds == self.kind)

        rows, _, partners = bond_pairs(sim, wanted)
        known = partners >= 0  # a bond to a lost atom does not count
        counts = np.bincount(rows[known], minlength=sim.atoms.n).astype(float)
        if sim.newton_bond:
            counts += np.bincount(partners[known], minlength=sim.atoms.n)
        counts[~self.members(sim)] = 0.0
        return counts
