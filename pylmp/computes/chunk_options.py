"""The keywords of compute chunk/atom. Source: LAMMPS manual, compute_chunk_atom.html."""

from __future__ import annotations

from dataclasses import dataclass, field

from pylmp.model.simulation import Simulation
from pylmp.text.words import Args

Bounds = dict[int, tuple[float | None, float | None]]


@dataclass
class Options:
    """once: the number of chunks is found once; None: as the style wants. limit: at most so many chunks, 0: any; exact: just so many.

    bounds: axis -> lowest and highest coordinate of bins, None: the box face
    """

    region: str = ""
    once: bool | None = None
    limit: int = 0
    exact: bool = False
    compress: bool = False
    discard: str = "yes"
    bounds: Bounds = field(default_factory=dict)
    pbc: bool = False
    units: str = "lattice"


def read_options(sim: Simulation, args: Args, bins: bool) -> Options:
    """All that follows the style's own words."""
    options = Options(discard="mixed" if bins else "yes")
    while len(args):
        key = args.word()
        if key.text not in ("region", "nchunk", "limit", "ids", "compress", "discard", "bound", "pbc", "units"):
            args.fail(f"Unknown compute chunk/atom keyword {key.text}", key, hint="region nchunk limit ids compress discard bound pbc units")
        args.need(1, key.text)
        if key.text == "region":
            word = args.word()
            if word.text not in sim.regions:
                args.fail(f"Region {word.text} for compute chunk/atom does not exist", word, hint="region comes first")
            options.region = word.text
        elif key.text == "nchunk":
            options.once = _one_of(args, "nchunk argument", "once", "every") == "once"
        elif key.text == "ids":
            _one_of(args, "ids argument", "once", "nfreq", "every")
        elif key.text == "compress":
            options.compress = args.yes()
        elif key.text == "pbc":
            options.pbc = args.yes()
        elif key.text == "discard":
            options.discard = _one_of(args, "discard argument", "yes", "no", "mixed")
        elif key.text == "units":
            options.units = _one_of(args, "units argument", "box", "lattice", "reduced")
        elif key.text == "limit":
            options.limit = args.integer()
            if options.limit:
                options.exact = _one_of(args, "limit keyword", "max", "exact") == "exact"
        else:
            args.need(3, key.text)
            axis = args.word()
            if axis.text not in ("x", "y", "z"):
                args.fail(f"Unknown compute chunk/atom bound argument {axis.text}", axis, hint="x y z")
            low, high = (args.word() for _ in range(2))
            options.bounds["xyz".index(axis.text)] = (
                None if low.text == "lower" else args.as_number(low), None if high.text == "upper" else args.as_number(high),
            )  # fmt: skip
    return options


def _one_of(args: Args, what: str, *known: str) -> str:
    word = args.word()
    if word.text not in known:
        args.fail(f"Unknown compute chunk/atom {what} {word.text}", word, hint=" ".join(known))
    return word.text
