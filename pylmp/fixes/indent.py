"""fix ID GROUP indent K sphere x y z R
fix ID GROUP indent K cylinder DIM c1 c2 R
fix ID GROUP indent K cone DIM c1 c2 Rlo Rhi lo hi
fix ID GROUP indent K plane DIM pos lo|hi
   all with [side in|out] [units lattice|box]

A hard body pushes atoms out of itself (side in: keeps them inside itself):

    F = K d^2,  E = K/3 d^3,  d: how deep the atom is in it

Numbers are in lattice units; any may be an equal-style variable, which is in box units. scalar: E (of a cone: -E, as LAMMPS has it);
vector: force on the body. A plane has one side, whatever the keyword says.
Source: LAMMPS manual, fix_indent.html.
"""

from __future__ import annotations

from contextlib import nullcontext

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.indenter import SHAPES
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.text.number import shortest
from pylmp.text.words import Args


@FIXES.register("indent")
class Indent(Fix):
    style = "indent"
    minimizes = True
    has_energy = True
    extensive_scalar = extensive_vector = True
    length = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        self.stiffness = args.number()
        if self.stiffness < 0.0:
            args.fail(f"Illegal fix indent force constant: {shortest(self.stiffness)}", hint="K >= 0")
        kind = args.word()
        if kind.text not in SHAPES:
            args.fail(f"Unknown fix indent geometry: {kind.text}", kind, hint=" ".join(SHAPES))
        self.shape = SHAPES[kind.text].read(args)
        lattice = True
        while len(args):
            key = args.word()
            if key.text not in ("side", "units"):
                args.fail(f"Unknown fix indent argument: {key.text}", key, hint="side units")
            args.need(1, key.text)
            value = args.word()
            if value.text not in (("in", "out") if key.text == "side" else ("lattice", "box")):
                args.fail(f"Unknown fix indent {key.text} argument: {value.text}", value)
            if key.text == "side":
                self.shape.inward = value.text == "in"
            else:
                lattice = value.text == "lattice"
        if lattice:
            self.shape.scale(sim.spacing)
        self._energy = 0.0
        self._force = np.zeros(3)

    def init(self, sim: Simulation) -> None:
        for quantity in self.shape.numbers:
            quantity.check(sim, "fix indent")

    def post_force(self, sim: Simulation) -> None:
        n, k = sim.atoms.n, self.stiffness
        rows = np.flatnonzero(self.members(sim))
        self._energy, self._force = 0.0, np.zeros(3)
        varies = any(quantity.varies for quantity in self.shape.numbers)
        with self.reading(sim, sim.step + 1) if varies else nullcontext():
            depth, direction, r = self.shape.answer(sim, sim.atoms.x[:n][rows])
        inside = ~(depth >= 0.0)
        rows, depth = rows[inside], depth[inside]
        size = (-k if self.shape.inward and self.shape.name != "plane" else k) * depth * depth
        with np.errstate(divide="ignore", invalid="ignore"):
            push = direction[inside] * size[:, None] / r[inside][:, None]
        sim.atoms.f[:n][rows] += push
        self._energy = total(-self.shape.energy_sign * ((k / 3.0) * depth * depth * depth))
        self._force = totals(-push)

    setup = post_force

    def scalar(self, sim: Simulation) -> float:
        return self._energy

    def vector(self, sim: Simulation) -> Floats:
        return self._force
