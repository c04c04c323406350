"""fix ID GROUP wall/region REGION lj93|lj126|lj1043|harmonic eps sigma cutoff
fix ID GROUP wall/region REGION morse D0 alpha r0 cutoff

The surface of a region pushes the atoms in it (side out: those around it) away from itself, each face on its own. The formulas are in
pylmp/model/wall_laws.py. scalar: energy; vector: force on the wall. Source: LAMMPS manual, fix_wall_region.html.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from pylmp.model import wall_laws
from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.region import named
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total, totals
from pylmp.model.wall import Law
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_ROOT = 1.41421356237309504880  # of two
_LAWS: dict[str, Callable[..., Law]] = {
    "lj93": wall_laws.lj93, "lj126": wall_laws.lj126, "harmonic": wall_laws.harmonic, "morse": wall_laws.morse,
    "lj1043": lambda eps, sigma, cutoff: wall_laws.lj1043(eps, sigma, cutoff, _ROOT),
}  # fmt: skip


@FIXES.register("wall/region")
class WallRegion(Fix):
    style = "wall/region"
    minimizes = True
    has_energy = has_virial = True
    extensive_scalar = extensive_vector = True
    length = 3

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(5)
        name = args.word()
        if name.text not in sim.regions:
            args.fail(f"Region {name.text} for fix wall/region does not exist", name, hint="region comes first")
        self.region = name.text
        style = args.word()
        self.colloid = style.text == "colloid"
        if style.text not in (*_LAWS, "colloid"):
            args.fail(f"Unknown fix wall/region style {style.text}", style, hint=" ".join(_LAWS))
        if style.text == "morse" and len(args) != 4:
            args.fail("Illegal fix wall/region morse command", style, hint="morse D0 alpha r0 cutoff")
        if len(args) != (4 if style.text == "morse" else 3):
            args.illegal(args.words[5], hint="eps sigma cutoff")
        *self.parameters, self.cutoff = (args.number() for _ in range(len(args)))
        if self.cutoff <= 0.0:
            args.fail("Fix wall/region cutoff <= 0.0", hint="a distance")
        self.law = _LAWS["harmonic" if self.colloid else style.text](*self.parameters, self.cutoff)
        self._energy = 0.0
        self._force = np.zeros(3)
        self._virial = np.zeros(6)

    def init(self, sim: Simulation) -> None:
        named(sim, self.region, "fix wall/region").init()
        if self.colloid:
            raise ScriptError("Fix wall/region colloid requires atom attribute radius", hint="atoms here are points")

    def post_force(self, sim: Simulation) -> None:
        n = sim.atoms.n
        region = named(sim, self.region, "fix wall/region")
        rows = np.flatnonzero(self.members(sim))
        x = sim.atoms.x[:n][rows]
        tallied = self.virial_due(sim)
        self._energy, self._force = 0.0, np.zeros(3)
        if tallied:
            self._virial = np.zeros(6)
        region.update()
        contacts = region.surface(x, self.cutoff)
        outside = not region.match(x).all()
        shape = len(rows), len(contacts)
        near, distance, away = np.zeros(shape, bool), np.zeros(shape), np.zeros((*shape, 3))
        for k, contact in enumerate(contacts):
            near[:, k], distance[:, k], away[:, k] = contact.near, contact.distance, contact.away
        if outside or (distance[near] <= 0.0).any():
            raise ScriptError("Particle outside surface of region used in fix wall/region", hint=f"region {self.region}")
        push, energy = self.law(distance[near])
        ri = 1.0 / distance[near]
        d = away[near]  # atom by atom, the faces of each in order
        forces = np.zeros((*shape, 3))
        forces[near] = push[:, None] * d * ri[:, None]
        for k in range(len(contacts)):
            sim.atoms.f[:n][rows[near[:, k]]] += forces[near[:, k], k]
        self._energy = total(energy)
        f = forces[near]
        self._force = totals(-f)
        if tallied:
            pairs = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
            self._virial = totals(np.stack([f[:, a] * d[:, b] for a, b in pairs], axis=1))

    setup = post_force

    def scalar(self, sim: Simulation) -> float:
        return self._energy

    def vector(self, sim: Simulation) -> Floats:
        return self._force

    def virial(self, sim: Simulation) -> Floats:
        return self._virial
