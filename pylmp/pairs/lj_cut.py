"""pair_style lj/cut: E = 4 epsilon [(sigma/r)^12 - (sigma/r)^6], r < cut.

Source: LAMMPS manual, pair_lj_cut.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import Any

from pylmp.laws import select
from pylmp.model.blob import FLAG, MIXING, NUMBER, Blob
from pylmp.model.mixing import mix_distance, mix_energy
from pylmp.model.registry import PAIRS
from pylmp.model.style import Coeff, Options, PairStyle
from pylmp.text.words import Args


def lj(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
    """c = 48 eps sigma^12, 24 eps sigma^6, 4 eps sigma^12, 4 eps sigma^6, energy offset, cut^2."""
    lj1, lj2, lj3, lj4, offset, cut2 = c
    r2i = 1.0 / r2
    r6 = r2i * r2i * r2i
    inside = r2 < cut2
    force = factor * (r6 * (lj1 * r6 - lj2)) * r2i
    energy = (r6 * (lj3 * r6 - lj4) - offset) * factor
    return select(inside, force, 0.0), select(inside, energy, 0.0)


def global_cutoff(sim: Any, args: Args) -> Options:
    if len(args) != 1:
        args.illegal(args.words[1] if len(args) else args.owner, hint="one number, the cutoff")
    return {"cut": args.number()}


def read(sim: Any, args: Args, options: Options) -> tuple[tuple[float, ...], float]:
    if not 2 <= len(args) <= 3:
        word = args.words[-1] if len(args) < 2 else args.words[args.at + 3]
        args.fail("Incorrect args for pair coefficients", word, hint="pair_coeff I J epsilon sigma [cutoff]")
    epsilon, sigma = args.number(), args.number()
    return (epsilon, sigma), args.number() if len(args) else options["cut"]


def row(coeffs: tuple[float, ...], cut: float, shift: bool) -> tuple[float, ...]:
    epsilon, sigma = coeffs
    s6, s12 = math.pow(sigma, 6.0), math.pow(sigma, 12.0)
    offset = 0.0
    if shift and cut > 0.0:
        ratio = sigma / cut
        offset = 4.0 * epsilon * (math.pow(ratio, 12.0) - math.pow(ratio, 6.0))
    return 48.0 * epsilon * s12, 24.0 * epsilon * s6, 4.0 * epsilon * s12, 4.0 * epsilon * s6, offset, cut * cut


def mix(a: Any, cut_a: float, b: Any, cut_b: float, rule: str) -> tuple[tuple[float, ...], float]:
    epsilon = mix_energy(a[0], b[0], a[1], b[1], rule)
    return (epsilon, mix_distance(a[1], b[1], rule)), mix_distance(cut_a, cut_b, rule)


def tail(coeffs: tuple[float, ...], cut: float, ni: float, nj: float) -> tuple[float, float]:
    """Integrals of energy and virial beyond the cutoff over ni nj pairs of atoms (times 1/V, 1/V^2)."""
    epsilon, sigma = coeffs
    s2 = sigma * sigma
    s6 = s2 * s2 * s2
    c3 = cut * cut * cut
    c6 = c3 * c3
    c9 = c3 * c6
    prefactor = 8.0 * math.pi * ni * nj * epsilon * s6 / (9.0 * c9)
    return prefactor * (s6 - 3.0 * c6), 2.0 * prefactor * (2.0 * s6 - 3.0 * c6)


PAIRS.add(
    "lj/cut",
    PairStyle(
        name="lj/cut", manual="pair_lj_cut.html",
        coeffs=(Coeff("epsilon", "energy"), Coeff("sigma", "distance")),
        law=lambda options: lj, settings=global_cutoff, read=read, row=row, mix=mix, tail=tail,
        adapts=("epsilon", "sigma"), restart=Blob(
            settings=(("cut", NUMBER), ("shift", FLAG), ("mix", MIXING), ("tail", FLAG)), coeffs=("epsilon", "sigma", "cut"),
        ),
    ),
)  # fmt: skip
