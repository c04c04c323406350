"""fix ID GROUP viscous gamma [scale TYPE RATIO]: a drag force, f -= gamma v.

Source: LAMMPS manual, fix_viscous.html.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.kernels.exact import pushes
from pylmp.kernels.store import kernel
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@FIXES.register("viscous")
class Viscous(Fix):
    style = "viscous"
    minimizes = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if not len(args):
            args.illegal(args.owner, hint="fix ID GROUP viscous gamma")
        self.gamma = np.full(sim.atom_types + 1, args.number())
        while len(args):
            key = args.word()
            if key.text != "scale" or len(args) < 2:
                args.illegal(key, hint="scale TYPE RATIO")
            kind, ratio = args.integer(), args.number()
            if not 1 <= kind <= sim.atom_types:
                args.illegal(key)
            self.gamma[kind] *= ratio
        self._function = pushes.viscous(bit == 1, sim.atom_types == 1)
        self._call: Callable[[], float] = lambda: 0.0

    def functions(self) -> list[Any]:
        return [self._function]

    def post_neighbor(self, sim: Simulation) -> None:
        atoms = sim.atoms
        self._call = kernel(self._function).bind(
            atoms.v, atoms.f, atoms.type, atoms.mask, self.gamma, self.bit, atoms.n
        )

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        return [self._call]

    def post_force(self, sim: Simulation) -> None:
        self._call()

    setup = post_force
