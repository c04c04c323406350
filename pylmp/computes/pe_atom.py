"""compute ID GROUP pe/atom [pair bond fix]: potential energy of each atom: half of each pair's and bond's.

Source: LAMMPS manual, compute_pe_atom.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.asking import ATOM_ENERGY
from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.shares import shares
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_NOTHING_HERE = ("angle", "dihedral", "improper", "kspace", "fix")


@COMPUTES.register("pe/atom")
class PotentialEnergyOfAtoms(Compute):
    style = "pe/atom"
    columns = 0
    tallies = ATOM_ENERGY

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        parts = []
        while len(args):
            key = args.word()
            if key.text not in ("pair", "bond", *_NOTHING_HERE):
                args.illegal(key, hint="pair bond fix")
            parts.append(key.text)
        self.parts = parts or ["pair", "bond"]

    def per_atom(self, sim: Simulation) -> Floats:
        """(n,)"""
        if not sim.tally.has(ATOM_ENERGY, sim.step):
            raise ScriptError("Per-atom energy was not tallied on needed timestep", hint="use it on thermo or dump steps")
        energies = shares(sim, [part for part in ("pair", "bond") if part in self.parts], slice(0, 1))
        return np.where(self.members(sim), energies[:, 0], 0.0)
