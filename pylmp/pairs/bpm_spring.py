"""pair_style bpm/spring: a repulsive spring with damping, F = k (rc - r) - gamma w (rhat . v), w = 1 - (r/rc)^8, r < rc.

With the keyword anharmonic yes a cubic term ka (rc - r)^3 is added. Source: LAMMPS manual, pair_bpm_spring.html.
"""

from __future__ import annotations

from typing import Any

from pylmp.laws import select, sqrt
from pylmp.model.blob import FLAG, Blob
from pylmp.model.mixing import mix_distance, mix_energy
from pylmp.model.registry import PAIRS
from pylmp.model.style import Coeff, Law, Options, PairStyle, Restriction
from pylmp.text.words import Args


def spring(options: Options) -> Law:
    anharmonic = bool(options["anharmonic"])

    def law(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
        """c = k, gamma, ka, rc, rc^2."""
        k, gamma, ka, cut, cut2 = c
        r = sqrt(r2)
        ri = 1.0 / r
        gap = cut - r
        force = k * gap
        energy = 0.5 * force * gap
        if anharmonic:
            force = force + ka * gap * gap * gap
            energy = energy + 0.25 * ka * gap * gap * gap * gap
        energy = energy * factor
        s = r2 / cut2
        s = s * s
        s = s * s
        force = force - gamma * dot * (1.0 - s) * ri
        force = force * (factor * ri)
        inside = r2 < cut2
        return select(inside, force, 0.0), select(inside, energy, 0.0)

    return law


def alone(options: Options) -> Law:
    """As LAMMPS evaluates one pair alone: w = 1 - (r/rc)^4, and the force is not divided by r. Measured."""
    anharmonic = bool(options["anharmonic"])
    listed = spring(options)

    def law(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
        k, gamma, ka, cut, cut2 = c
        r = sqrt(r2)
        gap = cut - r
        force = k * gap
        if anharmonic:
            force = force + ka * gap * gap * gap
        s = r2 / cut2
        s = s * s
        force = (force - gamma * dot * (1.0 / r) * (1.0 - s)) * factor
        _, energy = listed(r2, dot, factor, c)
        return select(r2 < cut2, force, 0.0), energy

    return law


def settings(sim: Any, args: Args) -> Options:
    options = {"anharmonic": False}
    while len(args):
        word = args.word()
        if word.text != "anharmonic":
            args.fail(f"Illegal pair_style command {word.text}", word, hint="the one keyword is anharmonic yes|no")
        if not len(args):
            args.fail("Illegal pair_coeff bpm/spring anharmonic command: missing argument(s)", word, hint="yes or no")
        options["anharmonic"] = args.yes()
    return options


def read(sim: Any, args: Args, options: Options) -> tuple[tuple[float, ...], float]:
    wanted = 4 if options["anharmonic"] else 3
    if len(args) != wanted:
        names = "k rc gamma" + (" ka" if wanted == 4 else "")
        args.fail("Incorrect args for pair coefficients", args.words[-1], hint=f"pair_coeff I J {names}")
    k, cut, gamma = args.number(), args.number(), args.number()
    return (k, gamma, args.number() if len(args) else 0.0), cut


def row(coeffs: tuple[float, ...], cut: float, shift: bool) -> tuple[float, ...]:
    return (*coeffs, cut, cut * cut)


def mix(a: Any, cut_a: float, b: Any, cut_b: float, rule: str) -> tuple[tuple[float, ...], float]:
    """k and gamma mix like energies, with rc as their distance. Measured: the cubic term of an unlike pair is zero."""
    k, gamma = (mix_energy(a[q], b[q], cut_a, cut_b, rule) for q in (0, 1))
    return (k, gamma, 0.0), mix_distance(cut_a, cut_b, rule)


def write(coeffs: tuple[float, ...], cut: float, whole: bool, options: Options) -> list[float]:
    k, gamma, ka = coeffs
    return [k, cut, gamma, ka] if options["anharmonic"] else [k, cut, gamma]


PAIRS.add(
    "bpm/spring",
    PairStyle(
        name="bpm/spring", manual="pair_bpm_spring.html",
        coeffs=(
            Coeff("k", "force/distance"), Coeff("gamma", "force/velocity"), Coeff("ka", "force/distance^3"),
        ),
        law=spring, alone=alone, settings=settings, read=read, row=row, mix=mix, velocity=True, write=write,
        restrictions=(
            Restriction(
                "P101", "Pair bpm/spring requires ghost atoms store velocity", lambda sim, _: not sim.comm.velocity,
                "comm_modify vel yes",
            ),
        ),
        restart=Blob(settings=(("anharmonic", FLAG),), coeffs=("k", "cut", "gamma", "ka")),
    ),
)  # fmt: skip
