"""compute ID GROUP group/group GROUP2 [pair yes|no] [kspace yes|no] [boundary yes|no] [molecule off|inter|intra]

Energy between two groups, and the force of GROUP2 on GROUP; of pair interactions only, each pair once. Source: LAMMPS manual,
compute_group_group.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.occasional import listed_pairs
from pylmp.model.pair_alone import weighted
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.model.wish import Wish
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@COMPUTES.register("group/group")
class GroupGroup(Compute):
    style = "group/group"
    length = 3
    extensive_scalar = extensive_vector = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if not len(args):
            args.illegal(args.owner, hint="the ID of a second group")
        word = args.word()
        self.other_group = word.text
        self.other = sim.groups.bit(word.text)
        if not self.other:
            args.fail(f"Group ID {word.text} requested by compute group/group does not exist", word)
        self.pair, self.kspace, self.molecule = True, False, "off"
        while len(args):
            key = args.word()
            if key.text not in ("pair", "kspace", "boundary", "molecule") or not len(args):
                args.illegal(key, hint="pair kspace boundary molecule")
            if key.text == "molecule":
                value = args.word()
                if value.text not in ("off", "inter", "intra"):
                    args.illegal(value, hint="off inter intra")
                self.molecule = value.text
            elif key.text == "boundary":
                args.yes()
            else:
                setattr(self, key.text, args.yes())

    def wish(self, sim: Simulation) -> Wish | None:
        return Wish() if self.pair else None

    def init(self, sim: Simulation) -> None:
        if self.pair and sim.pair is None:
            raise ScriptError("No pair style defined for compute group/group", hint="pair_style comes first")
        if self.kspace:
            raise ScriptError("No Kspace style defined for compute group/group", hint="kspace no")
        self.other = sim.groups.bit(self.other_group)

    def _interactions(self, sim: Simulation) -> tuple[Floats, Floats]:
        """(energies in order, (k, 3) forces in order) of the pairs between the groups."""
        if not self.pair:
            return np.zeros(0), np.zeros((0, 3))
        pairs = listed_pairs(sim, Wish())
        atoms = sim.atoms
        mine, theirs = ((atoms.mask & bit) != 0 for bit in (self.bit, self.other))
        forward, backward = mine[pairs.i] & theirs[pairs.j], mine[pairs.j] & theirs[pairs.i]
        take = forward | backward
        if self.molecule != "off":
            same = atoms.molecule[pairs.i] == atoms.molecule[pairs.j]
            take &= same if self.molecule == "intra" else ~same
        take &= pairs.r2 < np.square(sim.pair.cut[atoms.type[pairs.i], atoms.type[pairs.j]])
        pairs, forward, backward = pairs.take(take), forward[take], backward[take]
        over_r, energy = weighted(sim, pairs)
        once = sim.newton_pair | (pairs.j < atoms.n)
        push = pairs.d * over_r[:, None]
        # A pair inside both groups acts on the first with F and then -F, in this order.
        forces = np.stack([np.where(forward[:, None], push, 0.0), np.where((backward & once)[:, None], -push, 0.0)], axis=1)
        return np.where(once, energy, 0.5 * energy), forces.reshape(-1, 3)

    def scalar(self, sim: Simulation) -> float:
        return total(self._interactions(sim)[0])

    def vector(self, sim: Simulation) -> Floats:
        """(3,)"""
        return totals(self._interactions(sim)[1])
