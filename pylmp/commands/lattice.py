"""lattice STYLE SCALE keywords..."""

from __future__ import annotations

import math

from pylmp.model.lattice import BASES, FLAT, Lattice, cross, dot, primitive
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.number import eight, shortest
from pylmp.text.words import Args


@command("lattice")
def lattice(sim: Simulation, args: Args) -> None:
    """Define the lattice in force: sites for create_atoms, spacings for coordinates in lattice units."""
    style = args.word()
    if style.text == "custom":
        raise Unsupported("LAMMPS has lattice custom, pylmp's native engines do not", style.span)
    if style.text == "none":
        if len(args) != 1:
            args.fail(f"Illegal lattice none command: expected 2 arguments but found {len(args) + 1}", args.owner)
        scale = args.number()
        sim.lattice = Lattice(scale=scale, spacing=(scale, scale, scale))
        return
    if style.text not in BASES:
        hint = "sc bcc fcc sq sq2 hex none"
        args.fail(f"Unknown lattice keyword: {style.text}", style, hint=hint)
    word = args.word()
    scale = args.as_number(word)
    if scale <= 0.0:
        args.fail(f"Invalid lattice {style.text} argument: {word.text}", word, hint="a positive number")
    found = Lattice(style.text, vectors=primitive(style.text), basis=BASES[style.text])
    if (style.text in FLAT) != (sim.dimension == 2):
        args.fail("Lattice style incompatible with simulation dimension", style, hint="sq sq2 hex are flat, the others not")
    orient = list(found.orient)
    while len(args):
        key = args.word()
        if key.text == "origin":
            args.need(3)
            words = [args.word() for _ in range(3)]
            values = [args.as_number(w) for w in words]
            for w, value in zip(words, values, strict=True):
                if not 0.0 <= value < 1.0:
                    args.fail(f"Invalid lattice origin argument: {shortest(value)}", w, hint="from 0 up to, but not, 1")
            found.origin = values[0], values[1], values[2]
        elif key.text == "orient":
            args.need(4)
            axis = args.word()
            if axis.text not in ("x", "y", "z"):
                args.fail(f"Unknown lattice orient argument: {axis.text}", axis)
            orient["xyz".index(axis.text)] = (args.integer(), args.integer(), args.integer())
        elif key.text == "spacing":
            args.need(3)
            found.given_spacing = args.number(), args.number(), args.number()
        elif key.text in ("a1", "a2", "a3", "basis"):
            args.fail(f"Invalid {key.text} option in lattice command for non-custom style", key)
        else:
            args.fail(f"Unknown lattice keyword: {key.text}", key, hint="origin orient spacing")
    found.orient = tuple(orient)
    x, y, z = ((float(a), float(b), float(c)) for a, b, c in orient)
    if dot(x, y) or dot(y, z) or dot(x, z):
        args.fail("Lattice orient vectors are not orthogonal", args.owner)
    if dot(cross(x, y), z) <= 0.0:
        args.fail("Lattice orient vectors are not right-handed", args.owner)
    a1, a2, a3 = found.vectors
    volume = abs(dot(a1, cross(a2, a3)))
    reduced = sim.units.name == "lj"  # there the number is a density
    found.scale = math.pow(len(found.basis) / volume / scale, 1.0 / sim.dimension) if reduced else scale
    found.finish()
    sim.lattice = found
    sim.console.both(f"Lattice spacing in x,y,z = {' '.join(eight(s) for s in found.spacing)}\n")
