"""compute ID GROUP coord/atom cutoff R [group GROUP2] [TYPES...]: how many atoms, of some types each, are near each atom.

A column a type range; no range: all types. Bonded neighbors that special_bonds leaves out are not counted. Source: LAMMPS manual,
compute_coord_atom.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.occasional import listed_pairs
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.wish import Wish
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args


@COMPUTES.register("coord/atom")
class CoordAtom(Compute):
    style = "coord/atom"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) < 2:
            args.illegal(args.owner, hint="coord/atom cutoff R")
        style = args.word()
        if style.text == "orientorder":
            word = args.word()
            if word.text not in sim.computes:
                args.fail(f"Could not find compute coord/atom compute ID {word.text}", word)
            raise Unsupported("LAMMPS has compute coord/atom orientorder, pylmp's native engines do not", style.span)
        if style.text != "cutoff":
            args.fail("Invalid cstyle in compute coord/atom", style, hint="cutoff R")
        self.cutoff = args.number()
        self.other = 1
        word = args.peek()  # type: ignore[assignment]
        if word is not None and word.text == "group" and len(args) > 1:
            args.word()
            name = args.word()
            self.other = sim.groups.bit(name.text)
            if not self.other:
                args.fail(f"Group ID {name.text} requested by compute coord/atom does not exist", name)
        self.ranges = [args.types(sim.atom_types) for _ in range(len(args))] or [range(1, sim.atom_types + 1)]
        self.columns = len(self.ranges) if len(self.ranges) > 1 else 0

    def wish(self, sim: Simulation) -> Wish:
        return Wish(full=True)

    def init(self, sim: Simulation) -> None:
        if sim.pair is None:
            raise ScriptError("Compute coord/atom requires a pair style be defined", hint="pair_style zero is enough")
        if self.cutoff > float(sim.pair.cut.max()):
            text = "Compute coord/atom cutoff is longer than pairwise cutoff"
            raise ScriptError(text, hint=f"at most {float(sim.pair.cut.max()):g}")

    def per_atom(self, sim: Simulation) -> Floats:
        """(n,) with at most one type range, else (n, ranges)."""
        pairs = listed_pairs(sim, Wish(full=True))
        near = (pairs.r2 < self.cutoff * self.cutoff) & ((sim.atoms.mask[pairs.j] & self.other) != 0)
        near &= self.members(sim)[pairs.i]
        rows, kinds = pairs.i[near], sim.atoms.type[pairs.j[near]]
        counts = [
            np.bincount(rows[(kinds >= types.start) & (kinds < types.stop)], minlength=sim.atoms.n) for types in self.ranges
        ]
        table = np.stack(counts, axis=1).astype(float)
        return table if self.columns else table[:, 0]
