"""boundary x y z, each one or two letters of p f s m"""

from __future__ import annotations

from pylmp.model.box import Boundary
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("boundary")
def boundary(sim: Simulation, args: Args) -> None:
    """Periodic, fixed, shrink-wrapped, or shrink-wrapped with a minimum, for each face."""
    if sim.has_box:
        args.fail("Boundary command after simulation box is defined", args.owner, hint="boundary comes before the box")
    if len(args) != 3:
        args.fail(f"Illegal boundary command: expected 3 arguments but found {len(args)}", args.owner)
    sim.boundary = read_faces(args)


def read_faces(args: Args) -> Boundary:
    """Three words: what the faces of each direction are."""
    faces = []
    for word in (args.word(), args.word(), args.word()):
        low, high = word.text[:1], word.text[1:2] or word.text[:1]
        for letter in (low, high):
            if letter not in ("p", "f", "s", "m"):
                hint = "p, f, s or m, one for both faces or two letters"
                args.fail(f"Unknown {args.what} keyword: {letter}", word, hint=hint)
        if (low == "p") != (high == "p"):
            args.fail("Both sides of boundary must be periodic", word)
        faces.append((low, high))
    return faces[0], faces[1], faces[2]
