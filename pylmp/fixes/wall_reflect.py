"""fix ID GROUP wall/reflect FACE coord ... [units lattice|box]: atoms that have crossed a wall are put back, their velocity turned.

    beyond the wall at c:  x = c + (c - x),  v = -v

FACE is xlo xhi ylo yhi zlo or zhi; coord a number, EDGE (the box face as it is now) or an equal-style variable.
Source: LAMMPS manual, fix_wall_reflect.html.
"""

from __future__ import annotations

from contextlib import nullcontext

from pylmp.model.fix import Fix
from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.wall import FACES, read_coordinate, scale_coordinate
from pylmp.text.words import Args


@FIXES.register("wall/reflect")
class WallReflect(Fix):
    style = "wall/reflect"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.walls: list[tuple[str, Quantity]] = []
        scale = sim.spacing
        args.need(1)
        while len(args):
            key = args.word()
            if key.text in FACES:
                args.need(1, key.text)
                if any(face == key.text for face, _ in self.walls):
                    args.fail("Wall defined twice in fix wall/reflect command", key)
                self.walls.append((key.text, read_coordinate(sim, args, key.text)))
            elif key.text == "units":
                args.need(1, key.text)
                value = args.word()
                if value.text not in ("box", "lattice"):
                    args.fail(f"Unknown fix wall/reflect units argument: {value.text}", value, hint="box or lattice")
                scale = sim.spacing if value.text == "lattice" else (1.0, 1.0, 1.0)
            else:
                args.fail(f"Unknown fix wall/reflect keyword: {key.text}", key, hint=" ".join([*FACES, "units"]))
        if not self.walls:
            args.missing("FACE coord ...")
        for face, coord in self.walls:
            if sim.box.periodic["xyz".index(face[0])]:
                text = f"Cannot use fix wall/reflect in periodic dimension {face[0]}"
                args.fail(text, args.owner, hint="boundary f, s or m")
            scale_coordinate(coord, face, scale)

    def init(self, sim: Simulation) -> None:
        for _, coord in self.walls:
            coord.check(sim, "fix wall/reflect")

    def post_integrate(self, sim: Simulation) -> None:
        varies = any(coord.varies for _, coord in self.walls)
        with self.reading(sim, sim.step + 1) if varies else nullcontext():
            for face, coord in self.walls:
                self._reflect(sim, "xyz".index(face[0]), face[1:] == "hi", coord.number(sim))

    def _reflect(self, sim: Simulation, axis: int, high: bool, wall: float) -> None:
        n = sim.atoms.n
        x, v = sim.atoms.x[:n, axis], sim.atoms.v[:n, axis]
        beyond = ((x > wall) if high else (x < wall)) & self.members(sim)
        out = x[beyond]
        x[beyond] = wall - (out - wall) if high else wall + (wall - out)
        v[beyond] = -v[beyond]
