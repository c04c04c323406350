"""fix ID GROUP enforce2d: no motion out of the plane; z velocities and forces are zeroed every step.

Source: LAMMPS manual, fix_enforce2d.html.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pylmp.kernels.exact import pushes
from pylmp.kernels.store import kernel
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@FIXES.register("enforce2d")
class Enforce2d(Fix):
    style = "enforce2d"
    minimizes = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())
        self._function = pushes.flatten(bit == 1)
        self._call: Callable[[], float] = lambda: 0.0

    def functions(self) -> list[Any]:
        return [self._function]

    def init(self, sim: Simulation) -> None:
        if sim.dimension == 3:
            raise ScriptError(
                "Cannot use fix enforce2d with 3d simulation", hint="dimension 2", manual="fix_enforce2d.html"
            )

    def post_neighbor(self, sim: Simulation) -> None:
        atoms = sim.atoms
        self._call = kernel(self._function).bind(atoms.v, atoms.f, atoms.mask, self.bit, atoms.n)

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        return [self._call]

    def post_force(self, sim: Simulation) -> None:
        self._call()

    setup = post_force
