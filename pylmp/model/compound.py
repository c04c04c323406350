"""Regions made of regions: union and intersect."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.model.atoms import Floats
from pylmp.model.region import Extent, Inside, Options, Region, Scale
from pylmp.model.surface import Contact
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


class Compound(Region):
    """A style defines combine(insides) and join(extents). Parts are looked up by name at each use, each with its own side."""

    def __init__(self, sim: Simulation, args: Args, options: Options, scale: Scale) -> None:
        super().__init__(sim, options)
        if options.motion:
            args.fail("Region union or intersect cannot be dynamic", args.owner, hint="move or rotate the parts instead")
        count = args.integer()
        words = [args.word() for _ in range(count)]
        self.names = [word.text for word in words]
        for word in words:
            if word.text not in sim.regions:
                args.fail(f"Region {self.style} region {word.text} does not exist", word)
        self.extent = self.join([part.bounds for part in self.parts()])

    @classmethod
    def count_words(cls, args: Args) -> int:
        """N comes first: at least two regions, and their names."""
        if len(args) < 3:
            args.fail(f"Illegal region {cls.style} command: missing argument(s)", args.owner, hint="N REGION1 REGION2 ...")
        word = args.words[args.at]
        count = args.as_integer(word)
        if count < 2:
            args.fail(f"Illegal region {cls.style} n: {count}", word, hint="two regions at least")
        return 1 + count

    def parts(self) -> list[Region]:
        """Raises ScriptError if one was deleted."""
        for name in self.names:
            if name not in self.sim.regions:
                raise ScriptError(f"Region {self.style} region {name} does not exist", manual="region.html")
        return [self.sim.regions[name] for name in self.names]

    @property
    def dynamic(self) -> bool:
        return any(part.dynamic for part in self.parts())

    @property
    def bounds(self) -> Extent | None:
        """As it was known when the region was defined."""
        return None if self.options.outside else self.extent

    def combine(self, insides: list[Inside]) -> Inside:
        raise NotImplementedError

    def join(self, extents: list[Extent | None]) -> Extent | None:
        raise NotImplementedError

    def init(self) -> None:
        for part in self.parts():
            part.init()

    def update(self) -> None:
        for part in self.parts():
            part.update()

    def contains(self, x: Floats) -> Inside:
        return self.combine([part.match(x) for part in self.parts()])

    # ---- its surface: what of the surfaces of its parts is not buried --------------------------------------------

    def from_inside(self, x: Floats, cutoff: float) -> list[Contact]:
        return self._exposed(x, cutoff, self.style == "intersect")

    def from_outside(self, x: Floats, cutoff: float) -> list[Contact]:
        """As in LAMMPS, which for a union asks the wrong way round: only what is buried of the surfaces of its parts touches."""
        parts = self.parts()
        for part in parts:
            part.options.outside = not part.options.outside
        try:
            return self._exposed(x, cutoff, False)
        finally:
            for part in parts:
                part.options.outside = not part.options.outside

    def _exposed(self, x: Floats, cutoff: float, everywhere: bool) -> list[Contact]:
        """Contacts with the surfaces of the parts, where the point touched belongs to all others (everywhere) or to none."""
        found = []
        parts = self.parts()
        for part in parts:
            for contact in part.surface(x, cutoff):
                for other in parts:
                    if other is part or (other.options.opened and not everywhere):
                        continue
                    contact.near = contact.near & (other.match(x - contact.away) == everywhere)
                found.append(contact)
        return found
