"""What a region is: a set of points, with an extent where it is bounded. It may change and move with variables.

Source: LAMMPS manual, region.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, NoReturn

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.quantity import Quantity
from pylmp.model.surface import Contact
from pylmp.model.transform import Motion
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

BIG = 1.0e20
Inside = NDArray[np.bool_]
Corner = tuple[float, float, float]
Scale = tuple[float, float, float]
Extent = tuple[Corner, Corner]


@dataclass
class Options:
    """What the keywords after the geometry say. opened: faces 1 to 6. lattice: coordinates are in lattice units."""

    outside: bool = False
    lattice: bool = True
    opened: tuple[int, ...] = ()
    motion: Motion | None = None


class Region:
    """A style defines __init__(sim, args, scale), contains(x), and reshape() if variables may give its shape.

    Surface points belong to a region. side out is the negation; a region with an open face contains every point.

    words    how many its geometry has
    faces    how many it has, for ``open``
    extent   lowest and highest corner, None if unbounded
    cell     lo, hi and tilts of the box that create_box makes of it, if tilted
    varying  a variable gives part of its shape
    """

    style: ClassVar[str] = ""
    words: ClassVar[int] = 0
    faces: ClassVar[int] = 6
    extent: Extent | None = None
    cell: tuple[Corner, Corner, Corner] | None = None
    varying = False

    def __init__(self, sim: Simulation, options: Options) -> None:
        self.sim = sim
        self.options = options
        self._shape: list[Quantity] = []

    # ---- what a style uses to read its geometry ---------------------------------------------------------------

    def quantity(self, args: Args, scale: float) -> Quantity:
        """A number or the name of an equal-style variable, times scale."""
        found = Quantity.read(args, scale=scale)
        if found.varies:
            self.varying = True
            self._shape.append(found)
        return found

    def bound(
        self, args: Args, axis: int, high: bool, scale: float, *, edge: bool = True, variable: bool = True
    ) -> Quantity:
        """The same, or INF or EDGE (where edge), a variable only where variable."""
        word = args.peek()
        if word is not None and word.text in (("INF", "EDGE") if edge else ("INF",)):
            args.word()
            face = self.edge(args, axis, high)
            return face if word.text == "EDGE" else Quantity(BIG if high else -BIG)
        return self.quantity(args, scale) if variable else Quantity(scale * args.number())

    def edge(self, args: Args, axis: int, high: bool) -> Quantity:
        """A face of the box, or of the brick around a tilted one, as it is now."""
        if not self.sim.has_box:
            args.fail("Cannot use region INF or EDGE when box does not exist", hint="create_box comes first")
        low, up = self.sim.box.bounds
        return Quantity(float((up if high else low)[axis]))

    def read_axis(self, args: Args) -> tuple[int, list[int]]:
        """x, y or z: the index of a region's axis, and those of the two others. The faces that open names are checked."""
        for face in self.options.opened:
            if face > self.faces:
                args.fail(
                    f"Illegal region {self.style} open face: {face}", args.owner, hint=f"faces are 1 to {self.faces}"
                )
        word = args.word()
        if word.text not in ("x", "y", "z"):
            args.fail(f"Illegal region {self.style} axis: {word.text}", word, hint="x, y or z")
        axis = "xyz".index(word.text)
        return axis, [d for d in range(3) if d != axis]

    def shaped(self) -> None:
        """Once the geometry is read: variables must exist, and give a shape."""
        self.check()
        if self.varying:
            self.reshape()

    def check(self) -> None:
        for quantity in self._shape:
            quantity.check(self.sim, f"region {self.style}")

    def bad_value(self, says: str = "Variable evaluation in region gave bad value") -> NoReturn:
        raise ScriptError(says, manual="region.html")

    @classmethod
    def count_words(cls, args: Args) -> int:
        """How many words follow the style's name, keywords aside."""
        return cls.words

    # ---- what a style defines ---------------------------------------------------------------------------------

    def reshape(self) -> None:
        """Take the shape's numbers as they are now. Raises ScriptError if they make no sense."""

    def contains(self, x: Floats) -> Inside:
        """(n,) bool for (n, 3) positions: within the shape."""
        raise NotImplementedError

    def from_inside(self, x: Floats, cutoff: float) -> list[Contact]:
        """Contacts of points (n, 3) inside the shape with its faces, in LAMMPS's order; none for points outside."""
        raise self.no_surface()

    def from_outside(self, x: Floats, cutoff: float) -> list[Contact]:
        """The same for points outside, none for points inside."""
        raise self.no_surface()

    def no_surface(self, what: str = "") -> Unsupported:
        return Unsupported(f"LAMMPS has walls of region style {what or self.style}, pylmp's native engines do not")

    def open_face(self, number: int) -> bool:
        """Face number (from 1) is no wall."""
        return number in self.options.opened

    # ---- what the rest of the program uses ----------------------------------------------------------------------

    def init(self) -> None:
        """At the start of a run: what it refers to must be there."""
        self.check()
        if self.options.motion:
            self.options.motion.check(self.sim)

    def update(self) -> None:
        """Shape and place as variables give them now; before a loop over points."""
        if self.varying:
            self.check()
            self.reshape()
        if self.options.motion:
            self.options.motion.update(self.sim)

    def match(self, x: Floats) -> Inside:
        """(n,) bool for (n, 3) positions, after update: side, motion and open faces taken into account."""
        if self.options.opened:
            return np.ones(len(x), bool)
        if self.options.motion:
            x = self.options.motion.undo(x)
        inside = self.contains(x)
        return ~inside if self.options.outside else inside

    def surface(self, x: Floats, cutoff: float) -> list[Contact]:
        """Contacts of points (n, 3) that are nearer to the surface than cutoff; after update."""
        motion = self.options.motion
        points = motion.undo(x) if motion else x
        if self.options.opened:
            contacts = self.from_outside(points, cutoff) + self.from_inside(points, cutoff)
        else:
            contacts = (self.from_outside if self.options.outside else self.from_inside)(points, cutoff)
        if motion and motion.rotates:
            for contact in contacts:
                contact.away = x - motion.redo(points - contact.away)
        return contacts

    def inside(self, x: Floats) -> Inside:
        """update, then match."""
        self.update()
        return self.match(x)

    @property
    def dynamic(self) -> bool:
        """Its place changes with time."""
        return self.options.motion is not None

    @property
    def bounds(self) -> Extent | None:
        """Its extent, if that is known and does not change."""
        return None if self.options.outside or self.varying or self.dynamic else self.extent


def read_options(sim: Simulation, args: Args, start: int, identity: str, kind: type[Region]) -> Options:
    """Read the keywords that begin at word start."""
    options = Options()
    tail = Args(args.what, args.words[start:], args.owner, args.manual)
    motion = Motion(kind.style, identity)
    while len(tail):
        key = tail.word()
        if key.text == "side":
            tail.need(1, "side")
            value = tail.word()
            if value.text not in ("in", "out"):
                tail.fail(f"Unknown region side setting: {value.text}", value, hint="in or out")
            options.outside = value.text == "out"
        elif key.text == "units":
            tail.need(1, "units")
            value = tail.word()
            if value.text not in ("box", "lattice"):
                tail.fail(f"Unknown region units: {value.text}", value, hint="box or lattice")
            options.lattice = value.text == "lattice"
        elif key.text == "open":
            tail.need(1, "open")
            face = tail.integer()
            if not 1 <= face <= 6:
                tail.fail(f"Illegal region open face index: {face}", hint="faces are 1 to 6")
            options.opened = (*options.opened, face)
        elif key.text == "move":
            tail.need(3, "move")
            motion.read_move(tail)
        elif key.text == "rotate":
            tail.need(7, "rotate")
            motion.read_rotate(tail)
        else:
            tail.fail(f"Unknown region command argument: {key.text}", key, hint="side units open move rotate")
    if motion.moves or motion.rotates:
        motion.finish(args, sim.spacing if options.lattice else (1.0, 1.0, 1.0))
        options.motion = motion
    return options


def around_axis(axis: int, center: list[float], radius: float, low: float, high: float) -> Extent:
    """The extent of a cylinder."""
    corners = []
    for sign, end in ((-1.0, low), (1.0, high)):
        a, b = (c + sign * radius for c in center)
        corners.append(((end, a, b), (a, end, b), (a, b, end))[axis])
    return corners[0], corners[1]


def named(sim: Simulation, name: str, owner: str) -> Region:
    """The region called name. Raises ScriptError if it was deleted; owner is whom LAMMPS's sentence names."""
    found: Region | None = sim.regions.get(name)
    if found is None:
        raise ScriptError(f"Region {name} for {owner} does not exist", hint="it was deleted")
    return found
