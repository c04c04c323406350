"""pair_style lj/expand: E = 4 epsilon [(sigma/(r - delta))^12 - (sigma/(r - delta))^6], r < cut + delta.

Source: LAMMPS manual, pair_lj_expand.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import Any

from pylmp.laws import select, sqrt
from pylmp.model.blob import FLAG, MIXING, NUMBER, Blob
from pylmp.model.mixing import mix_distance, mix_energy
from pylmp.model.registry import PAIRS
from pylmp.model.style import Coeff, Options, PairStyle
from pylmp.pairs.lj_cut import global_cutoff
from pylmp.text.words import Args


def expanded(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
    """c = 48 eps sigma^12, 24 eps sigma^6, 4 eps sigma^12, 4 eps sigma^6, delta, energy offset, (cut + delta)^2."""
    lj1, lj2, lj3, lj4, delta, offset, cut2 = c
    r = sqrt(r2)
    rs = r - delta
    r2i = 1.0 / (rs * rs)
    r6 = r2i * r2i * r2i
    force = factor * (r6 * (lj1 * r6 - lj2)) / rs / r
    energy = (r6 * (lj3 * r6 - lj4) - offset) * factor
    inside = r2 < cut2
    return select(inside, force, 0.0), select(inside, energy, 0.0)


def read(sim: Any, args: Args, options: Options) -> tuple[tuple[float, ...], float]:
    if not 3 <= len(args) <= 4:
        word = args.words[-1] if len(args) < 3 else args.words[args.at + 4]
        args.fail("Incorrect args for pair coefficients", word, hint="pair_coeff I J epsilon sigma delta [cutoff]")
    epsilon, sigma, delta = args.number(), args.number(), args.number()
    return (epsilon, sigma, delta), args.number() if len(args) else options["cut"]


def row(coeffs: tuple[float, ...], cut: float, shift: bool) -> tuple[float, ...]:
    epsilon, sigma, delta = coeffs
    s6, s12 = math.pow(sigma, 6.0), math.pow(sigma, 12.0)
    reach = cut + delta
    offset = 0.0
    if shift and reach > 0.0:
        ratio = sigma / reach
        offset = 4.0 * epsilon * (math.pow(ratio, 12.0) - math.pow(ratio, 6.0))
    return 48.0 * epsilon * s12, 24.0 * epsilon * s6, 4.0 * epsilon * s12, 4.0 * epsilon * s6, delta, offset, reach * reach


def mix(a: Any, cut_a: float, b: Any, cut_b: float, rule: str) -> tuple[tuple[float, ...], float]:
    epsilon = mix_energy(a[0], b[0], a[1], b[1], rule)
    coeffs = (epsilon, mix_distance(a[1], b[1], rule), 0.5 * (a[2] + b[2]))
    return coeffs, mix_distance(cut_a, cut_b, rule)


def tail(coeffs: tuple[float, ...], cut: float, ni: float, nj: float) -> tuple[float, float]:
    """Integrals of energy and virial beyond the cutoff over ni nj pairs of atoms (times 1/V, 1/V^2)."""
    epsilon, sigma, d = coeffs
    s2 = sigma * sigma
    s6 = s2 * s2 * s2
    c2 = cut * cut
    c3 = c2 * cut
    c9 = c3 * (c3 * c3)
    d2 = d * d
    d3 = d2 * d
    steep = 1.0 / 9.0 + d / (5.0 * cut) + d2 / (11.0 * c2)
    flat = 1.0 / 3.0 + d / (2.0 * cut) + d2 / (5.0 * c2)
    energy = 8.0 * math.pi * ni * nj * epsilon * s6 * (s6 * steep / c9 - flat / c3)
    steep = 1.0 / 9.0 + 3.0 * d / (10.0 * cut) + 3.0 * d2 / (11.0 * c2) + d3 / (12.0 * c3)
    flat = 1.0 / 3.0 + 3.0 * d / (4.0 * cut) + 3.0 * d2 / (5.0 * c2) + d3 / (6.0 * c3)
    return energy, 16.0 * math.pi * ni * nj * epsilon * s6 * (2.0 * s6 * steep / c9 - flat / c3)


PAIRS.add(
    "lj/expand",
    PairStyle(
        name="lj/expand", manual="pair_lj_expand.html",
        coeffs=(Coeff("epsilon", "energy"), Coeff("sigma", "distance"), Coeff("delta", "distance")),
        law=lambda options: expanded, settings=global_cutoff, read=read, row=row, mix=mix, tail=tail,
        reach=lambda coeffs, cut: cut + coeffs[2],
        adapts=("epsilon", "sigma", "delta"), restart=Blob(
            settings=(("cut", NUMBER), ("shift", FLAG), ("mix", MIXING), ("tail", FLAG)),
            coeffs=("epsilon", "sigma", "delta", "cut"),
        ),
    ),
)  # fmt: skip
