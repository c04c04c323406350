"""pair_style morse: E = D [exp(-2 alpha (r - r0)) - 2 exp(-alpha (r - r0))], r < cut.

Source: LAMMPS manual, pair_morse.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import Any

from pylmp.laws import exp, select, sqrt
from pylmp.model.blob import FLAG, MIXING, NUMBER, Blob
from pylmp.model.registry import PAIRS
from pylmp.model.style import Coeff, Options, PairStyle
from pylmp.pairs.lj_cut import global_cutoff
from pylmp.text.words import Args


def morse(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
    """c = D, alpha, r0, 2 D alpha, energy offset, cut^2."""
    d, alpha, r0, slope, offset, cut2 = c
    r = sqrt(r2)
    z = exp(-alpha * (r - r0))
    force = factor * slope * (z * z - z) / r
    energy = (d * (z * z - 2.0 * z) - offset) * factor
    inside = r2 < cut2
    return select(inside, force, 0.0), select(inside, energy, 0.0)


def read(sim: Any, args: Args, options: Options) -> tuple[tuple[float, ...], float]:
    if not 3 <= len(args) <= 4:
        word = args.words[-1] if len(args) < 3 else args.words[args.at + 4]
        args.fail("Incorrect args for pair coefficients", word, hint="pair_coeff I J D alpha r0 [cutoff]")
    d, alpha, r0 = args.number(), args.number(), args.number()
    return (d, alpha, r0), args.number() if len(args) else options["cut"]


def row(coeffs: tuple[float, ...], cut: float, shift: bool) -> tuple[float, ...]:
    d, alpha, r0 = coeffs
    offset = 0.0
    if shift:
        q = -alpha * (cut - r0)
        offset = d * (math.exp(2.0 * q) - 2.0 * math.exp(q))
    return d, alpha, r0, 2.0 * d * alpha, offset, cut * cut


PAIRS.add(
    "morse",
    PairStyle(
        name="morse", manual="pair_morse.html",
        coeffs=(Coeff("D", "energy"), Coeff("alpha", "1/distance"), Coeff("r0", "distance")),
        law=lambda options: morse, settings=global_cutoff, read=read, row=row,
        adapts=("d0", "alpha", "r0"), restart=Blob(
            settings=(("cut", NUMBER), ("shift", FLAG), ("mix", MIXING)), coeffs=("D", "alpha", "r0", "cut"),
        ),
    ),
)  # fmt: skip
