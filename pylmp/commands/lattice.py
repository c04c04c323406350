"""lattice STYLE SCALE keywords...

Styles none sc bcc fcc hcp diamond sq sq2 hex custom. scale: of a cell edge a1, under lj units the number density instead.
"""

from __future__ import annotations

import math

from pylmp.model.lattice import BASES, FLAT, Lattice, cross, dot, primitive
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.number import eight, shortest
from pylmp.text.words import Args, Word

_ZERO = (0.0, 0.0, 0.0)


@command("lattice")
def lattice(sim: Simulation, args: Args) -> None:
    """Define the lattice in force: sites for create_atoms, spacings for coordinates in lattice units."""
    style = args.word()
    if style.text == "none":
        if len(args) != 1:
            args.fail(f"Illegal lattice command: expected 2 arguments but found {len(args) + 1}", args.owner)
        scale = _scale(args, style)
        sim.lattice = Lattice(scale=scale, spacing=(scale, scale, scale))
        return
    if style.text not in (*BASES, "custom"):
        args.fail(f"Unknown lattice keyword: {style.text}", style, hint=f"{' '.join(BASES)} custom none")
    found = Lattice(style.text, vectors=primitive(style.text), basis=BASES.get(style.text, ()))
    args.need(1)
    if style.text != "custom" and (style.text in FLAT) != (sim.dimension == 2):
        args.fail("Lattice style incompatible with simulation dimension", style, hint="sq sq2 hex are flat, the others not")
    scale = _scale(args, style)
    while len(args):
        _keyword(args, args.word(), found)
    _check(sim, args, found)
    a1, a2, a3 = found.vectors
    volume = abs(dot(a1, cross(a2, a3)))
    if volume == 0.0:
        args.fail("Degenerate lattice primitive vectors", args.owner, hint="three that do not lie in a plane")
    if sim.units.name == "lj":  # from the density of basis atoms
        scale = math.pow(len(found.basis) / volume / scale, 1.0 / sim.dimension)
    found.scale = scale
    found.finish()
    if min(found.spacing) <= 0.0:
        args.fail("Lattice spacings are invalid", args.owner, hint="three positive numbers")
    sim.lattice = found
    sim.console.both(f"Lattice spacing in x,y,z = {' '.join(eight(s) for s in found.spacing)}\n")


def _scale(args: Args, style: Word) -> float:
    word = args.word()
    scale = args.as_number(word)
    if scale <= 0.0:
        args.fail(f"Invalid lattice {style.text} argument: {word.text}", word, hint="a positive number")
    return scale


def _keyword(args: Args, key: Word, found: Lattice) -> None:
    if key.text == "orient":
        args.need(4, key.text)
        axis = args.word()
        if axis.text not in ("x", "y", "z"):
            args.fail(f"Unknown lattice orient argument: {axis.text}", axis, hint="x, y or z")
        rows = list(found.orient)
        rows["xyz".index(axis.text)] = (args.integer(), args.integer(), args.integer())
        found.orient = tuple(rows)
    elif key.text in ("origin", "spacing", "a1", "a2", "a3", "basis"):
        args.need(3, key.text)
        if key.text not in ("origin", "spacing") and found.style != "custom":
            args.fail(f"Invalid {key.text} option in lattice command for non-custom style", key, hint="lattice custom")
        words = [args.word() for _ in range(3)]
        a, b, c = (args.as_number(word) for word in words)
        if key.text in ("origin", "basis"):
            for word, value in zip(words, (a, b, c), strict=True):
                if not 0.0 <= value < 1.0:
                    says = f"Invalid lattice {key.text} argument: {shortest(value)}"
                    args.fail(says, word, hint="from 0 up to, but not, 1")
        if key.text == "origin":
            found.origin = a, b, c
        elif key.text == "spacing":
            found.given_spacing = a, b, c
        elif key.text == "basis":
            found.basis = (*found.basis, (a, b, c))
        else:
            vectors = list(found.vectors)
            vectors[int(key.text[1]) - 1] = a, b, c
            found.vectors = vectors[0], vectors[1], vectors[2]
    elif key.text == "triclinic/general":
        raise Unsupported("LAMMPS has lattice triclinic/general, pylmp's native engines do not", key.span)
    else:
        args.fail(f"Unknown lattice keyword: {key.text}", key, hint="origin orient spacing a1 a2 a3 basis")


def _check(sim: Simulation, args: Args, found: Lattice) -> None:
    """What LAMMPS checks once all keywords are read, in its order."""
    if not found.basis:
        args.fail("No basis atoms in lattice", args.owner, hint="basis 0 0 0")
    x, y, z = ((float(a), float(b), float(c)) for a, b, c in found.orient)
    if dot(x, y) or dot(y, z) or dot(x, z):
        args.fail("Lattice orient vectors are not orthogonal", args.owner)
    if dot(cross(x, y), z) <= 0.0:
        args.fail("Lattice orient vectors are not right-handed", args.owner)
    a1, a2, a3 = found.vectors
    if any(cross(a, b) == _ZERO for a, b in ((a1, a2), (a2, a3), (a1, a3))):
        args.fail("Lattice primitive vectors are collinear", args.owner)
    if sim.dimension == 2:
        if found.origin[2] != 0.0:
            args.fail("Lattice origin z coord must be 0.0 for 2d simulation", args.owner)
        if a1[2] or a2[2] or a3[0] or a3[1]:
            args.fail("Lattice a1/a2/a3 vectors are not compatible with 2d simulation", args.owner)
        if x[2] or y[2] or z[0] or z[1]:
            args.fail("Lattice orient vectors are not compatible with 2d simulation", args.owner)
        if any(site[2] != 0.0 for site in found.basis):
            args.fail("Lattice basis atom z coords must be zero for 2d simulation", args.owner)
    if found.given_spacing is not None and min(found.given_spacing) <= 0.0:
        args.fail("Lattice spacings are invalid", args.owner, hint="three positive numbers")
