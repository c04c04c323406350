"""compute ID GROUP stress/atom TEMP-ID|NULL [ke pair bond fix virial]: stress of each atom times its volume.

    S_ab = -(m v_a v_b + half of each pair's and bond's r_a F_b + those of fixes that count in the virial),  xx yy zz xy xz yz

in units of pressure times volume. Velocities are without the drift that the temperature compute knows. Source: LAMMPS manual,
compute_stress_atom.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.asking import ATOM_VIRIAL
from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.shares import shares
from pylmp.model.simulation import Simulation
from pylmp.model.temperature import Temperature
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_NOTHING_HERE = ("angle", "dihedral", "improper", "kspace")


@COMPUTES.register("stress/atom")
class StressOfAtoms(Compute):
    style = "stress/atom"
    columns = 6
    tallies = ATOM_VIRIAL

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if not len(args):
            args.illegal(args.owner, hint="the ID of a temperature compute, or NULL")
        word = args.word()
        self.temperature = None if word.text == "NULL" else word.text
        if self.temperature is not None:
            if self.temperature not in sim.computes:
                args.fail(f"Could not find compute stress/atom temperature compute {word.text}", word)
            if not isinstance(sim.computes[self.temperature], Temperature):
                args.fail(f"Compute stress/atom compute {word.text} does not compute temperature", word)
        parts = []
        while len(args):
            key = args.word()
            if key.text not in ("ke", "pair", "bond", "fix", "virial", *_NOTHING_HERE):
                args.illegal(key, hint="ke pair bond fix virial")
            parts += ["pair", "bond", "fix"] if key.text == "virial" else [key.text]
        self.parts = parts or ["ke", "pair", "bond", "fix"]

    def init(self, sim: Simulation) -> None:
        if self.temperature is not None and self.temperature not in sim.computes:
            raise ScriptError(f"Could not find compute stress/atom temperature compute {self.temperature}", hint="uncompute took it")

    def per_atom(self, sim: Simulation) -> Floats:
        """(n, 6)"""
        if not sim.tally.has(ATOM_VIRIAL, sim.step):
            raise ScriptError("Per-atom virial was not tallied on needed timestep", hint="use it on thermo or dump steps")
        fixes = [fix for fix in sim.fixes if fix.in_virial and fix.virial_shares is not None and "fix" in self.parts]
        stress = shares(
            sim, [part for part in ("pair", "bond") if part in self.parts], slice(1, 7), [fix.virial_shares for fix in fixes]
        )
        rows = self.members(sim)
        result = np.zeros((sim.atoms.n, 6))
        result[rows] = stress[rows]
        if "ke" in self.parts:
            result[rows] += self._motion(sim, rows)
        result[rows] *= -sim.units.nktv2p
        return result

    def _motion(self, sim: Simulation, rows: np.ndarray[tuple[int], np.dtype[np.bool_]]) -> Floats:
        """(k, 6) m v_a v_b of the chosen atoms."""
        found = sim.computes.get(self.temperature or "")
        if isinstance(found, Temperature) and found.bias:
            found.at_step(sim, "scalar")  # others may read it
        v = found.thermal(sim, rows) if isinstance(found, Temperature) else sim.atoms.v[: sim.atoms.n][rows]
        m = sim.units.mvv2e * sim.masses()[rows]
        x, y, z = v.T
        return np.stack([m * x * x, m * y * y, m * z * z, m * x * y, m * x * z, m * y * z], axis=1)
