"""fix ID GROUP addforce fx fy fz [every N] [region ID] [energy v_NAME]: a force on every atom.

fx fy fz are numbers, equal-style or atom-style variables. scalar: potential energy of the force, -sum(f . x) with unwrapped x,
or the sum of the atom-style variable that energy names; vector: total force before. fix_modify energy and virial count them in.
Source: LAMMPS manual, fix_addforce.html.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.kernels.exact import pushes
from pylmp.kernels.store import kernel
from pylmp.model.atoms import Floats
from pylmp.model.forces import ForceFix
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@FIXES.register("addforce")
class AddForce(ForceFix):
    style = "addforce"
    minimizes = True
    extensive_scalar = extensive_vector = True
    has_energy = has_virial = True
    length = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.read_force(args, null=False)
        self.interval = 1
        self.energy = Quantity(absent=True)
        self.read_keywords(sim, args, {"every": self._every, "energy": self._energy_of})
        self._before = np.zeros(3)
        self._energy = 0.0
        self._virial = np.zeros(6)
        self._function = pushes.add(bit == 1)

    @property
    def _plain(self) -> bool:
        """Numbers, for a group, in every step: where nothing is tallied a kernel does it."""
        return not (self.region or self.varies) and self.interval == 1

    def functions(self) -> list[Any]:
        return [self._function] if self._plain else []

    def calls(self, sim: Simulation, hook: str) -> list[Callable[[], float]] | None:
        if not self._plain:
            return None
        push = (force.value for force in self.force)
        return [kernel(self._function).bind(sim.atoms.f, sim.atoms.mask, *push, self.bit, sim.atoms.n)]

    def _every(self, args: Args) -> None:
        self.interval = args.integer()
        if self.interval <= 0:
            args.fail(f"Invalid fix addforce every argument: {self.interval}", hint="every so many steps")

    def _energy_of(self, args: Args) -> None:
        word = args.peek()
        if word is not None and not word.text.startswith("v_"):
            args.fail(f"Invalid fix addforce energy argument: {word.text}", word, hint="v_NAME of an atom-style variable")
        self.energy = Quantity.read(args)

    def init(self, sim: Simulation) -> None:
        super().init(sim)
        if self.energy.varies:
            self.energy.check(sim, "fix addforce", atoms=True)
            if not self.energy.per_atom:
                raise ScriptError(f"Variable {self.energy.name} for fix addforce is invalid style", hint="an atom-style variable")
            if not self.varies:
                raise ScriptError(
                    "Cannot use variable energy with constant force in fix addforce", hint="its energy is known: leave energy out"
                )

        elif sim.relaxing and self.varies:
            raise ScriptError("Must use variable energy with fix addforce", hint="energy v_NAME, whose gradient the force is")

    def post_force(self, sim: Simulation) -> None:
        if sim.step % self.interval:
            return
        atoms = sim.atoms
        tallied = self.virial_due(sim)
        self._energy, self._before = 0.0, np.zeros(3)
        if tallied:
            self._virial = np.zeros(6)
        rows = self.members(sim)
        f = atoms.f[: atoms.n]
        x = sim.box.unwrap(atoms.x[: atoms.n], atoms.image[: atoms.n])[rows]
        a, b, c, energy = self.values(sim, rows, self.energy)
        work = a * x[:, 0], b * x[:, 1], c * x[:, 2]
        if not self.varies:
            self._energy = total(-(work[0] + work[1] + work[2]))
        elif self.energy.varies:
            self._energy = total(np.asarray(energy))
        else:
            self._energy = total(-np.stack(work, axis=1).ravel())
        self._before = totals(f[rows])
        push = np.empty((len(x), 3))
        push[:, 0], push[:, 1], push[:, 2] = a, b, c
        f[rows] += push
        if tallied:
            self._virial = totals(np.stack([*work, a * x[:, 1], a * x[:, 2], b * x[:, 2]], axis=1))
        if self.shares_due(sim):
            self.virial_shares = np.zeros((atoms.n, 6))
            self.virial_shares[rows] = np.stack([*work, a * x[:, 1], a * x[:, 2], b * x[:, 2]], axis=1)

    setup = post_force

    def scalar(self, sim: Simulation) -> float:
        return self._energy

    def vector(self, sim: Simulation) -> Floats:
        return self._before

    def virial(self, sim: Simulation) -> Floats:
        return self._virial
