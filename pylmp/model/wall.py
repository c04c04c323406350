"""What the fixes wall/lj93, wall/lj126, wall/lj1043, wall/harmonic and wall/morse share: flat walls that push along one axis.

    fix ID GROUP wall/... FACE coord [parameters] cutoff ... [units lattice|box] [fld yes|no] [pbc yes|no]

FACE is xlo xhi ylo yhi zlo or zhi; coord a number, EDGE (the box face as it is now) or an equal-style variable; parameters may be
variables too. scalar: energy of all walls; vector: force on each wall. Source: LAMMPS manual, fix_wall.html.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.quantity import Quantity
from pylmp.model.sums import total
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

FACES = ("xlo", "xhi", "ylo", "yhi", "zlo", "zhi")
# distances (k,) to a wall -> (outward force (k,), energy (k,))
Law = Callable[[Floats], tuple[Floats, Floats]]


def read_coordinate(sim: Simulation, args: Args, face: str) -> Quantity:
    """The next word as the place of a wall: a number, EDGE, or v_NAME; without the lattice's scale."""
    word = args.peek()
    if word is not None and word.text == "EDGE":
        args.word()
        box, axis = sim.box, "xyz".index(face[0])
        return Quantity(float(box.lo[axis] if face[1:] == "lo" else box.hi[axis]), scale=0.0)
    return Quantity.read(args)


def scale_coordinate(coord: Quantity, face: str, scale: tuple[float, float, float]) -> None:
    """Lattice units; EDGE is where it is."""
    if coord.scale:
        coord.scale = scale["xyz".index(face[0])]
        coord.value *= coord.scale


@dataclass
class Face:
    """One wall: its name, its place, its parameters, how far it reaches, and its law once the parameters are known."""

    name: str
    coord: Quantity
    parameters: list[Quantity]
    cutoff: float
    law: Law | None = None

    @property
    def axis(self) -> int:
        return "xyz".index(self.name[0])

    @property
    def high(self) -> bool:
        return self.name[1:] == "hi"


class Wall(Fix):
    """A subclass says parameters (how many numbers stand between coord and cutoff) and law."""

    parameters: ClassVar[int] = 2
    minimizes = True
    has_energy = has_virial = True
    extensive_scalar = extensive_vector = True
    reach_inclusive: ClassVar[bool] = False  # an atom at the cutoff still feels the wall
    passable: ClassVar[bool] = False  # atoms behind the wall are left alone

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.walls: list[Face] = []
        self.early = periodic = False
        scale = sim.spacing
        while len(args):
            key = args.word()
            if key.text in FACES:
                self._wall(sim, args, key)
            elif key.text == "units" and len(args):
                value = args.word()
                if value.text not in ("box", "lattice"):
                    args.illegal(value, hint="units box or lattice")
                scale = sim.spacing if value.text == "lattice" else (1.0, 1.0, 1.0)
            elif key.text == "fld" and len(args):
                self.early = args.yes()
            elif key.text == "pbc" and len(args):
                periodic = args.yes()
            else:
                args.illegal(key, hint=" ".join([*FACES, "units fld pbc"]))
        self._check(sim, args, periodic)
        for wall in self.walls:
            scale_coordinate(wall.coord, wall.name, scale)
        self.length = len(self.walls)
        self._energy = 0.0
        self._on_walls = np.zeros(self.length)
        self._virial = np.zeros(6)

    def law(self, sim: Simulation, parameters: list[float], cutoff: float) -> Law:
        """The law of a wall with these parameters."""
        raise NotImplementedError

    def _wall(self, sim: Simulation, args: Args, key: Word) -> None:
        if len(args) < self.parameters + 2:
            args.fail(f"Missing argument for {args.what} command", key, hint="FACE coord, its parameters, cutoff")
        if any(wall.name == key.text for wall in self.walls):
            args.fail(f"{key.text} wall defined twice in {args.what} command", key)
        coord = read_coordinate(sim, args, key.text)
        parameters = [Quantity.read(args) for _ in range(self.parameters)]
        self.walls.append(Face(key.text, coord, parameters, args.number()))

    def _check(self, sim: Simulation, args: Args, periodic: bool) -> None:
        if not self.walls:
            args.fail(f"Illegal {args.what} command: no walls defined", args.owner, hint="FACE coord ...")
        for wall in self.walls:
            if wall.cutoff <= 0.0:
                args.fail(f"{args.what.capitalize()} cutoff <= 0.0 for {wall.name} wall", args.owner, hint="a distance")
        for wall in self.walls:
            axis = wall.name[0]
            if sim.box.periodic[wall.axis] and not periodic and not (axis == "z" and sim.dimension == 2):
                text = f"Cannot use {wall.name} wall in periodic {axis} dimension"
                args.fail(text, args.owner, hint="boundary f, or the keyword pbc yes")
        if sim.dimension == 2 and any(wall.axis == 2 for wall in self.walls):
            args.fail(f"Cannot use {args.what} zlo/zhi for a 2d simulation", args.owner)

    def init(self, sim: Simulation) -> None:
        for wall in self.walls:
            for quantity in (wall.coord, *wall.parameters):
                quantity.check(
                    sim, "fix wall", missing="Variable name for {1} does not exist", invalid="Variable for {1} is invalid style"
                )
            if not any(parameter.varies for parameter in wall.parameters):
                wall.law = self.law(sim, [parameter.value for parameter in wall.parameters], wall.cutoff)

    def post_force(self, sim: Simulation) -> None:
        if not self.early:
            self._apply(sim)

    setup = post_force

    def min_post_force(self, sim: Simulation) -> None:
        """In minimizations fld makes no difference."""
        self._apply(sim)

    def pre_force(self, sim: Simulation) -> None:
        if self.early:
            self._apply(sim)

    def _apply(self, sim: Simulation) -> None:
        self._energy = 0.0
        self._on_walls = np.zeros(self.length)
        tallied = self.virial_due(sim)
        if tallied:
            self._virial = np.zeros(6)
        if any(q.varies for wall in self.walls for q in (wall.coord, *wall.parameters)):
            with self.reading(sim, sim.step + 1):
                self._push(sim, tallied)
        else:
            self._push(sim, tallied)

    def _now(self, sim: Simulation, wall: Face) -> tuple[float, Law]:
        """Place and law of a wall now."""
        coord = wall.coord.number(sim)
        if any(parameter.varies for parameter in wall.parameters):
            values = []
            for parameter in wall.parameters:
                values.append(parameter.number(sim))
                if parameter.varies and values[-1] < 0.0:
                    raise ScriptError("Variable evaluation in fix wall gave bad value", hint=f"v_{parameter.name} < 0")
            wall.law = self.law(sim, values, wall.cutoff)
        assert wall.law is not None
        return coord, wall.law

    def _push(self, sim: Simulation, tallied: bool) -> None:
        """Every wall in turn. One sum runs over the energies of all of them, and one over the virial of each axis."""
        n = sim.atoms.n
        x, f = sim.atoms.x[:n], sim.atoms.f[:n]
        members = self.members(sim)
        shared = self.shares_due(sim)
        if shared:
            self.virial_shares = np.zeros((n, 6))
        energies: list[Floats] = []
        virials: list[list[Floats]] = [[], [], []]
        for number, wall in enumerate(self.walls):
            coord, law = self._now(sim, wall)
            along = x[:, wall.axis]
            distance = coord - along if wall.high else along - coord
            near = distance <= wall.cutoff if self.reach_inclusive else distance < wall.cutoff
            rows = np.flatnonzero(members & near)
            if not self.passable and (distance[rows] <= 0.0).any():
                raise ScriptError(
                    "Particle on or inside fix wall surface", hint=f"an atom is behind the {wall.name} wall at {coord:g}"
                )
            rows = rows[distance[rows] > 0.0]
            delta = distance[rows]
            push, energy = law(delta)
            f[rows, wall.axis] += -push if wall.high else push
            energies.append(energy)
            self._on_walls[number] = total(push if wall.high else -push)
            virials[wall.axis].append(push * delta)
            if shared:
                self.virial_shares[rows, wall.axis] += push * delta
        self._energy = total(np.concatenate(energies))
        if tallied:
            for axis, terms in enumerate(virials):
                self._virial[axis] = total(np.concatenate(terms)) if terms else 0.0

    def scalar(self, sim: Simulation) -> float:
        return self._energy

    def vector(self, sim: Simulation) -> Floats:
        return self._on_walls

    def virial(self, sim: Simulation) -> Floats:
        return self._virial


def whole_power(base: float, exponent: int) -> float:
    """base^exponent by repeated squaring, in the order in which LAMMPS multiplies."""
    result, square, n = 1.0, base, abs(exponent)
    while n:
        if n & 1:
            result *= square
        n >>= 1
        square *= square
    return 1.0 / result if exponent < 0 else result
