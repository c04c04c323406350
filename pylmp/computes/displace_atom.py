"""compute ID GROUP displace/atom [refresh VARIABLE]: how far each atom has come since the compute was defined.

Columns dx dy dz dr of unwrapped positions. refresh: after a dump that said dump_modify refresh, atoms for which the atom-style variable
is not 0 start anew. Source: LAMMPS manual, compute_displace_atom.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.keepsake import Keepsake
from pylmp.model.motion import unwrapped
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@COMPUTES.register("displace/atom")
class DisplaceAtom(Keepsake):
    style = "displace/atom"
    columns = 4

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.variable = ""
        while len(args):
            key = args.word()
            if key.text != "refresh" or not len(args):
                args.illegal(key, hint="refresh VARIABLE")
            word = args.word()
            self.variable = word.text
            style = Variables(sim).style(word.text)
            if style is None:
                args.fail("Variable name for compute displace/atom does not exist", word)
            if style not in ("atom", "atomfile"):
                args.fail("Compute displace/atom variable is not atom-style variable", word)
        rows = self.members(sim)
        start = np.zeros((sim.atoms.n, 3))
        start[rows] = unwrapped(sim, rows)
        self.keep(sim, start)

    def init(self, sim: Simulation) -> None:
        if self.variable and Variables(sim).style(self.variable) is None:
            raise ScriptError("Variable name for compute displace/atom does not exist", hint="it was deleted")

    def per_atom(self, sim: Simulation) -> Floats:
        """(n, 4)"""
        rows = self.members(sim)
        d = unwrapped(sim, rows) - self.kept(sim)[rows]
        x, y, z = d.T
        result = np.zeros((sim.atoms.n, 4))
        result[rows] = np.column_stack([d, np.sqrt(x * x + y * y + z * z)])
        return result

    def refresh(self, sim: Simulation) -> None:
        """A dump was written: atoms whose variable is not 0 are measured from where they are now."""
        if not self.variable:
            return
        again = Variables(sim).per_atom(self.variable) != 0.0
        sim.atoms.extra[self.key][: sim.atoms.n][again] = unwrapped(sim, again)
