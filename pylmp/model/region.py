"""What a region is: a set of points, with an extent where it is bounded."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

BIG = 1.0e20
Corner = tuple[float, float, float]
Extent = tuple[Corner, Corner]


class Region:
    """A style defines __init__(sim, args, scale) and contains(x). extent: lowest and highest corner, None if unbounded.

    Surface points belong to a region. side out is the negation.
    """

    extent: Extent | None = None
    cell: tuple[Corner, Corner, Corner] | None = None  # lo, hi and tilts of the box that create_box makes of it, if tilted
    outside = False

    def contains(self, x: Floats) -> NDArray[np.bool_]:
        raise NotImplementedError

    def inside(self, x: Floats) -> NDArray[np.bool_]:
        """(n,) bool for (n, 3) positions, the side taken into account."""
        return ~self.contains(x) if self.outside else self.contains(x)

    @property
    def bounds(self) -> Extent | None:
        return None if self.outside else self.extent


def named(sim: Simulation, name: str, owner: str) -> Region:
    """The region called name. Raises ScriptError if it was deleted; owner is whom LAMMPS's sentence names."""
    found: Region | None = sim.regions.get(name)
    if found is None:
        raise ScriptError(f"Region {name} for {owner} does not exist", hint="it was deleted")
    return found


def bound(sim: Simulation, args: Args, axis: int, high: bool, scale: float) -> float:
    """A coordinate, INF or EDGE."""
    word = args.word()
    if word.text in ("INF", "EDGE"):
        if not sim.has_box:
            args.fail("Cannot use region INF or EDGE when box does not exist", word, hint="create_box comes first")
        if word.text == "INF":
            return BIG if high else -BIG
        return float(sim.box.hi[axis] if high else sim.box.lo[axis])
    return scale * number(args, word)


def number(args: Args, word: Word) -> float:
    if word.text.startswith("v_"):
        raise Unsupported("LAMMPS has variables in regions, pylmp's native engines do not", word.span)
    return args.as_number(word)


def read_options(args: Args, start: int) -> tuple[bool, bool]:
    """(outside, lattice units) from the keywords after the geometry's words."""
    outside, lattice = False, True
    words: list[Any] = args.words[start:]
    while words:
        word = words.pop(0)
        if word.text in ("side", "units") and not words:
            args.missing()
        if word.text == "side":
            value = words.pop(0)
            if value.text not in ("in", "out"):
                args.fail(f"Unknown region side setting: {value.text}", value, hint="in or out")
            outside = value.text == "out"
        elif word.text == "units":
            value = words.pop(0)
            if value.text not in ("box", "lattice"):
                args.fail(f"Unknown region units: {value.text}", value, hint="box or lattice")
            lattice = value.text == "lattice"
        elif word.text in ("move", "rotate", "open"):
            raise Unsupported(f"LAMMPS has region keyword {word.text}, pylmp's native engines do not", word.span)
        else:
            args.fail(f"Unknown region command argument: {word.text}", word, hint="side units")
    return outside, lattice
