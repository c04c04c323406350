"""fix ID GROUP move linear Vx Vy Vz [units lattice|box]: atoms travel at a constant velocity, whatever the forces.

A component given as NULL moves freely, by velocity Verlet. Source: LAMMPS manual, fix_move.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args


@FIXES.register("move")
class Move(Fix):
    style = "move"
    integrates = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        mode = args.word()
        if mode.text in ("wiggle", "rotate", "transrot", "variable"):
            raise Unsupported(
                f"LAMMPS has fix move {mode.text}, pylmp's native engines do not", mode.span, hint="linear"
            )
        if mode.text != "linear":
            args.fail(f"Unknown fix move mode {mode.text}", mode, hint="linear")
        if len(args) < 3:
            args.fail(
                "Illegal fix move linear command: missing argument(s)", mode, hint="fix ID GROUP move linear Vx Vy Vz"
            )
        words = [args.word() for _ in range(3)]
        velocity = [None if w.text == "NULL" else args.as_number(w) for w in words]
        scale = sim.spacing
        while len(args):
            key = args.word()
            args.need(1, key.text)
            value = args.word()
            if key.text != "units" or value.text not in ("box", "lattice"):
                args.fail(
                    f"Unknown fix move units setting {value.text}"
                    if key.text == "units"
                    else f"Unknown fix move keyword {key.text}",
                    value,
                )
            scale = sim.spacing if value.text == "lattice" else (1.0, 1.0, 1.0)
        self.velocity = [None if v is None else v * s for v, s in zip(velocity, scale, strict=True)]
        if sim.dimension == 2 and self.velocity[2] not in (None, 0.0):
            args.fail("Fix move cannot set linear z motion for 2d problem", words[2])
        self.began = sim.step
        self._name = f"fix move {identity}"
        atoms = sim.atoms
        origin = np.zeros((atoms.capacity, 3))
        origin[: atoms.n] = sim.box.unwrap(atoms.x[: atoms.n], atoms.image[: atoms.n])
        atoms.extra[self._name] = origin

    def _kick(self, sim: Simulation) -> Floats:
        return (0.5 * sim.dt * sim.units.ftm2v) / sim.masses()[self.members(sim)]

    def initial_integrate(self, sim: Simulation) -> None:
        atoms = sim.atoms
        rows = self.members(sim)
        elapsed = (sim.step - self.began) * sim.dt
        x, v = atoms.x[: atoms.n], atoms.v[: atoms.n]
        before = x[rows]
        for d, velocity in enumerate(self.velocity):
            if velocity is None:
                v[rows, d] += self._kick(sim) * atoms.f[: atoms.n][rows, d]
                x[rows, d] += sim.dt * v[rows, d]
            else:
                v[rows, d] = velocity
                x[rows, d] = atoms.extra[self._name][: atoms.n][rows, d] + velocity * elapsed
        x[rows] = _near(sim, x[rows], before)

    def final_integrate(self, sim: Simulation) -> None:
        atoms = sim.atoms
        rows = self.members(sim)
        for d, velocity in enumerate(self.velocity):
            if velocity is None:
                atoms.v[: atoms.n][rows, d] += self._kick(sim) * atoms.f[: atoms.n][rows, d]


def _near(sim: Simulation, new: Floats, old: Floats) -> Floats:
    """The periodic image of new (k, 3) within half a box length of old."""
    for d, periodic in enumerate(sim.box.periodic):
        if not periodic:
            continue
        length = float(sim.box.hi[d] - sim.box.lo[d])
        half = 0.5 * length
        for sign in (1.0, -1.0):
            gap = sign * (new[:, d] - old[:, d])
            far = gap > length
            if far.any():
                new[far, d] -= sign * ((gap[far] / length).astype(np.int64) * length)
            while (out := sign * (new[:, d] - old[:, d]) > half).any():
                new[out, d] -= sign * length
    return new
