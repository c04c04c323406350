"""create_atoms TYPE box|region|single|random arguments... keywords..."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.commands.create_box import describe
from pylmp.kernels.random import RanPark
from pylmp.model.atoms import Floats
from pylmp.model.box import Box
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_ELSEWHERE = ("mol", "var", "set", "rotate", "ratio", "subset", "radscale", "meshmode", "mesh")
_EDGE = 1.0e-6  # of the box length: sites this near a periodic face count as on it


@command("create_atoms", needs_box=True)
def create_atoms(sim: Simulation, args: Args) -> None:
    """Fill the box or a region with lattice sites, place one atom, or place atoms at random."""
    args.need(2)
    word = args.word()
    kind = args.as_integer(word)
    if not 1 <= kind <= sim.atom_types:
        args.fail("Invalid atom type in create_atoms command", word, hint=f"types are 1 to {sim.atom_types}")
    style = args.word()
    words = {"box": 0, "region": 1, "single": 3, "random": 3}
    if style.text not in words:
        if style.text in ("mesh",):
            raise Unsupported("LAMMPS has create_atoms mesh, pylmp's native engines do not", style.span)
        args.fail(f"Unknown create_atoms command option {style.text}", style, hint="box region single random")
    if len(args) < words[style.text]:
        args.fail(f"Illegal create_atoms {style.text} command: missing argument(s)", style)
    geometry = [args.word() for _ in range(words[style.text])]
    options = _options(sim, args, kind)
    if style.text == "random":
        x = _random(sim, args, geometry, options)
        types = np.full(len(x), kind)
    elif style.text == "single":
        scale = (1.0, 1.0, 1.0) if options["units"] == "box" else sim.spacing
        x = np.array([[args.as_number(w) * s for w, s in zip(geometry, scale, strict=True)]])
        if sim.dimension == 2 and x[0, 2] != 0.0:
            args.fail("Create_atoms single for 2d simulation requires z coord = 0.0", geometry[2])
        if options["remap"]:
            sim.box.remap(x, np.zeros((1, 3), np.int64))
        keep = _within(sim.box, x)
        x, types = x[keep], np.full(int(keep.sum()), kind)
    else:
        x, types = _sites(sim, args, geometry, options, kind)
    sim.atoms.append(x, types)
    sim.atoms.number()
    sim.natoms += len(x)
    what = "box" if style.text == "random" or options["units"] == "box" else "lattice"
    if style.text in ("box", "region"):
        what = "lattice" if options["units"] == "lattice" else "box"
    sim.console.both(
        f"Created {len(x)} atoms\n  using {what} units in {describe(sim.box)}\n  create_atoms CPU = 0.000 seconds\n"
    )


def _options(sim: Simulation, args: Args, kind: int) -> dict[str, Any]:
    options: dict[str, Any] = {
        "units": "lattice", "remap": False, "overlap": 0.0, "maxtry": 1000, "basis": {},
    }  # fmt: skip
    while len(args):
        word = args.word()
        if word.text == "units":
            value = args.word()
            if value.text not in ("box", "lattice"):
                args.fail(f"Unknown create_atoms units option {value.text}", value, hint="box or lattice")
            options["units"] = value.text
        elif word.text == "remap":
            options["remap"] = args.yes()
        elif word.text == "overlap":
            options["overlap"] = args.number()
        elif word.text == "maxtry":
            options["maxtry"] = args.integer()
        elif word.text == "basis":
            args.need(2)
            which, other = args.integer(), args.integer()
            sites = len(sim.lattice.basis) if sim.lattice else 0
            if not 1 <= which <= sites or not 1 <= other <= sim.atom_types:
                args.fail(f"Out of range basis setting '{which} {other}' in create_atoms command")
            options["basis"][which - 1] = other
        elif word.text in _ELSEWHERE:
            raise Unsupported(f"LAMMPS has create_atoms {word.text}, pylmp's native engines do not", word.span)
        else:
            args.fail(f"Illegal create_atoms command option {word.text}", word, hint="units remap overlap maxtry basis")
    return options


def _sites(sim: Simulation, args: Args, geometry: list[Word], options: dict[str, Any], kind: int) -> tuple[Floats, Any]:
    """Lattice sites in the box (and the region), in LAMMPS's order: z slowest, then y, x, basis."""
    lattice, box = sim.lattice, sim.box
    region = _region(sim, args, geometry[0]) if geometry else None
    if lattice is None or not lattice.basis:
        args.fail("Cannot create atoms with undefined lattice", args.owner, hint="lattice comes first")
    ranges = _ranges(sim, lattice, region)
    found, types = [], []
    for k, j, i in product(ranges[2], ranges[1], ranges[0]):
        for site, (bx, by, bz) in enumerate(lattice.basis):
            found.append(lattice.to_box((i + bx, j + by, k + bz)))
            types.append(options["basis"].get(site, kind))
    x, kinds = np.array(found).reshape(-1, 3), np.array(types, np.int64)
    keep = region.inside(x) if region else np.ones(len(x), bool)
    keep &= _within(box, x, _EDGE)
    return x[keep], kinds[keep]


def _within(box: Box, x: Floats, edge: float = 0.0) -> NDArray[np.bool_]:
    """(n,) bool: positions in the box; edge, of a length: a periodic box begins that far below its low face and ends twice that far
    below its high face, so that one of two images on its faces is in."""
    x, (lo, hi) = x.copy(), box.frame
    box.enter(x)
    margin = np.where(box.periodic, (hi - lo) * edge, 0.0)
    return np.asarray(((x >= lo - margin) & (x < hi - 2.0 * margin)).all(axis=1))


def _ranges(sim: Simulation, lattice: Any, region: Any) -> list[range]:
    """Cells whose sites may lie in the box and the region's extent."""
    low, high = (corner.tolist() for corner in sim.box.brick(*sim.box.frame))
    if region is not None and region.bounds is not None:
        for d in range(3):
            low[d], high[d] = max(low[d], region.bounds[0][d]), min(high[d], region.bounds[1][d])
    corners = [lattice.from_box(corner) for corner in product(*zip(low, high, strict=True))]
    ranges = []
    for d in range(3):
        least, most = min(c[d] for c in corners), max(c[d] for c in corners)
        first = int(least) - 1
        if least < 0.0:
            first -= 1
        ranges.append(range(first, int(most) + 2))
    if sim.dimension == 2:
        ranges[2] = range(1)
    return ranges


def _region(sim: Simulation, args: Args, word: Word) -> Any:
    if word.text not in sim.regions:
        args.fail(f"Create_atoms region {word.text} does not exist", word)
    return sim.regions[word.text]


def _random(sim: Simulation, args: Args, geometry: list[Word], options: dict[str, Any]) -> Floats:
    """Uniformly random positions, tried again while outside the region or too near another atom."""
    count, seed = args.as_integer(geometry[0]), args.as_integer(geometry[1])
    if count < 0:
        args.fail(f"Illegal create_atoms number of random atoms {count}", geometry[0])
    if seed <= 0:
        args.fail(f"Illegal create_atoms random seed {seed}", geometry[1], hint="a positive number")
    region = None if geometry[2].text == "NULL" else _region(sim, args, geometry[2])
    box: Box = sim.box
    low, high = (corner.tolist() for corner in box.bounds)
    if region is not None and region.bounds is not None:
        for d in range(3):
            low[d], high[d] = max(low[d], region.bounds[0][d]), min(high[d], region.bounds[1][d])
    if any(a > b for a, b in zip(low, high, strict=True)):
        args.fail("No overlap of box and region for create_atoms", geometry[2])
    random = RanPark(seed)
    random.skip(30)
    near2 = math.pow(options["overlap"] * (sim.spacing[0] if options["units"] == "lattice" else 1.0), 2.0)
    there: list[Floats] = list(sim.atoms.x[: sim.atoms.n])
    new: list[Floats] = []
    for _ in range(count):
        for _ in range(options["maxtry"]):
            point = np.array([a + random.uniform() * (b - a) for a, b in zip(low, high, strict=True)])
            if sim.dimension == 2:
                point[2] = 0.0
            if region is not None and not region.inside(point[None])[0]:
                continue
            if box.triclinic and not _within(box, point[None])[0]:
                continue
            if near2 > 0.0 and there:
                away = box.minimum_image(point - np.array(there))
                if (away[:, 0] * away[:, 0] + away[:, 1] * away[:, 1] + away[:, 2] * away[:, 2] < near2).any():
                    continue
            there.append(point)
            new.append(point)
            break
    if len(new) < count:
        sim.console.warning(f"Only inserted {len(new)} particles out of {count}")
    return np.array(new).reshape(-1, 3)
