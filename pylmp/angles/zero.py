"""angle_style zero [nocoeff]: no forces. angle_coeff TYPE [theta0]; theta0 in degrees, 0 if left out.

Source: LAMMPS manual, angle_zero.html.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from pylmp.model.blob import Blob, nearest
from pylmp.model.many_body import ManyBodyStyle
from pylmp.model.registry import ANGLES
from pylmp.text.words import Args


def parse(args: Args) -> bool:
    if len(args) > 1:
        args.fail("Too many angle_style zero keywords", args.words[1], hint="nocoeff")
    if len(args) and not args.take("nocoeff"):
        word = args.word()
        args.fail(f"Unknown angle_style zero keyword {word}", word, hint="nocoeff")
    return len(args.words) == 0


def read(args: Args, types: int) -> tuple[range, tuple[float, ...]]:
    if not 1 <= len(args) <= 2:
        args.fail("Incorrect args for angle coefficients", args.words[-1], hint="angle_coeff TYPE [theta0]")
    kinds = args.types(types)
    return kinds, (args.number() if len(args) else 0.0,)


def radians(values: Sequence[float]) -> tuple[float]:
    return (values[0] * (math.pi / 180.0),)


def degrees(values: Sequence[float]) -> tuple[float]:
    """Those, with few digits if that will do, of which radians makes these."""
    guess = values[0] / math.pi * 180.0
    short = float(f"{guess:.12g}")
    return (nearest(short if radians((short,)) == (values[0],) else guess, values[0], lambda angle: radians((angle,))[0]),)


ANGLES.add("zero", ManyBodyStyle("zero", "angle_zero.html", 1, parse, read, Blob(coeffs=("theta0",), pack=radians, unpack=degrees)))
