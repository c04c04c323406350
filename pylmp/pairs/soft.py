"""pair_style soft: E = A [1 + cos(pi r/cut)], r < cut: pushes overlapping atoms apart without ever diverging.

Source: LAMMPS manual, pair_soft.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import Any

from pylmp.laws import cos, select, sin, sqrt
from pylmp.model.blob import MIXING, NUMBER, Blob
from pylmp.model.mixing import mix_distance
from pylmp.model.registry import PAIRS
from pylmp.model.style import Coeff, Options, PairStyle
from pylmp.pairs.lj_cut import global_cutoff
from pylmp.text.words import Args

PI = math.pi


def soft(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
    """c = A, cut, cut^2."""
    a, cut, cut2 = c
    r = sqrt(r2)
    angle = PI * r / cut
    apart = r > 0.0
    force = select(apart, factor * a * sin(angle) * PI / cut / select(apart, r, 1.0), 0.0)
    energy = factor * a * (1.0 + cos(angle))
    inside = r2 < cut2
    return select(inside, force, 0.0), select(inside, energy, 0.0)


def read(sim: Any, args: Args, options: Options) -> tuple[tuple[float, ...], float]:
    if not 1 <= len(args) <= 2:
        word = args.words[-1] if len(args) < 1 else args.words[args.at + 2]
        args.fail("Incorrect args for pair coefficients", word, hint="pair_coeff I J A [cutoff]")
    return (args.number(),), args.number() if len(args) else options["cut"]


def mix(a: Any, cut_a: float, b: Any, cut_b: float, rule: str) -> tuple[tuple[float, ...], float]:
    """A mixes geometrically whatever the rule."""
    return (math.sqrt(a[0] * b[0]),), mix_distance(cut_a, cut_b, rule)


PAIRS.add(
    "soft",
    PairStyle(
        name="soft", manual="pair_soft.html", coeffs=(Coeff("A", "energy"),), law=lambda options: soft,
        settings=global_cutoff, read=read, row=lambda coeffs, cut, shift: (coeffs[0], cut, cut * cut), mix=mix, mixes_energy=False,
        adapts=("a",), restart=Blob(settings=(("cut", NUMBER), ("mix", MIXING)), coeffs=("A", "cut")),
    ),
)  # fmt: skip
