"""fix ID GROUP momentum N [linear 0|1 0|1 0|1] [angular] [rescale]: every N steps the group stops drifting or turning.

linear takes the center-of-mass velocity out of the directions marked 1, angular the rotation about the center of mass; rescale
then gives the kinetic energy back. Source: LAMMPS manual, fix_momentum.html.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pylmp.model.fix import Fix
from pylmp.model.motion import center_of_mass_velocity, remove_rotation
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_HINT = "fix ID GROUP momentum N [linear 0|1 0|1 0|1] [angular] [rescale]"


@FIXES.register("momentum")
class Momentum(Fix):
    style = "momentum"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if not len(args):
            args.illegal(args.owner, hint=_HINT)
        self.every = args.integer()
        if self.every <= 0:
            args.illegal(hint="every so many steps")
        self.linear: list[bool] | None = None
        self.angular = self.rescale = False
        while len(args):
            key = args.word()
            if key.text == "linear" and len(args) >= 3:
                flags = [args.integer() for _ in range(3)]
                if any(flag not in (0, 1) for flag in flags):
                    args.illegal(hint="0 or 1 for each direction")
                self.linear = [flag == 1 for flag in flags]
            elif key.text == "angular":
                self.angular = True
            elif key.text == "rescale":
                self.rescale = True
            else:
                args.illegal(key, hint=_HINT)
        if self.linear is None and not self.angular:
            args.illegal(hint="linear or angular")

    def init(self, sim: Simulation) -> None:
        if not self.members(sim).any():
            raise ScriptError("Fix momentum group has no atoms", hint=f"group {self.group} is empty")

    def end_of_step(self, sim: Simulation) -> None:
        rows = self.members(sim)
        v = sim.atoms.v[: sim.atoms.n]
        before = _kinetic(sim, rows) if self.rescale else 0.0
        if self.linear is not None:
            drift = center_of_mass_velocity(sim, rows)
            for d in range(3):
                if self.linear[d]:
                    v[rows, d] -= drift[d]
        if self.angular:
            remove_rotation(sim, rows)
        if self.rescale:
            after = _kinetic(sim, rows)
            v[rows] *= math.sqrt(before / after) if after != 0.0 else 1.0


def _kinetic(sim: Simulation, rows: NDArray[np.bool_]) -> float:
    """sum m v^2."""
    v = sim.atoms.v[: sim.atoms.n][rows]
    return total(sim.masses()[rows] * (v[:, 0] * v[:, 0] + v[:, 1] * v[:, 1] + v[:, 2] * v[:, 2]))
