"""fix ID GROUP spring/self K [xyz|xy|xz|yz|x|y|z]: each atom is tied to where it was when the fix was defined.

    f = -K (x - x0),  E = K/2 sum (x - x0)^2, unwrapped

K is a number, or an equal-style or atom-style variable. scalar: E. Source: LAMMPS manual, fix_spring_self.html.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.text.words import Args

_DIRECTIONS = ("xyz", "xy", "xz", "yz", "x", "y", "z")


@FIXES.register("spring/self")
class SpringSelf(Fix):
    style = "spring/self"
    minimizes = True
    has_energy = True
    extensive_scalar = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if not 1 <= len(args) <= 2:
            args.illegal(args.owner, hint="fix ID GROUP spring/self K [xyz]")
        self.stiffness = Quantity.read(args)
        if not self.stiffness.varies and self.stiffness.value <= 0.0:
            args.fail("Illegal force constant for fix spring/self command", hint="K > 0")
        word = args.word() if len(args) else None
        if word is not None and word.text not in _DIRECTIONS:
            args.illegal(word, hint=" ".join(_DIRECTIONS))
        self.along = np.array([axis in (word.text if word else "xyz") for axis in "xyz"])
        self._name = f"fix spring/self {identity}"
        atoms = sim.atoms
        home = np.zeros((atoms.capacity, 3))
        home[: atoms.n] = sim.box.unwrap(atoms.x[: atoms.n], atoms.image[: atoms.n])
        atoms.extra[self._name] = home
        atoms.newcomers[self._name] = lambda atoms, rows: atoms.x[rows]
        self._energy = 0.0

    def atom_state(self, sim: Simulation) -> Floats:
        home = sim.atoms.extra[self._name][: sim.atoms.n]
        return np.where(self.members(sim)[:, None], home, 0.0)

    def restore_atoms(self, sim: Simulation, values: Floats) -> None:
        sim.atoms.extra[self._name][: sim.atoms.n] = values

    def removed(self, sim: Simulation) -> None:
        sim.atoms.extra.pop(self._name, None)
        sim.atoms.newcomers.pop(self._name, None)

    def init(self, sim: Simulation) -> None:
        self.stiffness.check(sim, "fix spring/self", atoms=True)

    def _stiffness(self, sim: Simulation, rows: NDArray[np.bool_]) -> Floats | float:
        """K, or (k,) K of each chosen atom. LAMMPS does not have computes evaluated anew for it."""
        k = self.stiffness.numbers(sim, rows)
        return k[rows] if isinstance(k, np.ndarray) else k

    def post_force(self, sim: Simulation) -> None:
        atoms, n = sim.atoms, sim.atoms.n
        rows = self.members(sim)
        d = sim.box.unwrap(atoms.x[:n], atoms.image[:n])[rows] - atoms.extra[self._name][:n][rows]
        d[:, ~self.along] = 0.0
        k = self._stiffness(sim, rows)
        atoms.f[:n][rows] -= (k * d.T).T
        self._energy = 0.5 * total(k * (d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]))

    setup = post_force

    def scalar(self, sim: Simulation) -> float:
        return self._energy
