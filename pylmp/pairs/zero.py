"""pair_style zero: a neighbor list and no force. Source: LAMMPS manual, pair_zero.html."""

from __future__ import annotations

from typing import Any

from pylmp.model.blob import NUMBER, UNLESS, Blob
from pylmp.model.mixing import mix_distance
from pylmp.model.registry import PAIRS
from pylmp.model.style import Options, PairStyle
from pylmp.text.words import Args


def settings(sim: Any, args: Args) -> Options:
    if not len(args):
        args.fail("Illegal pair_style zero command: missing argument(s)", args.owner, hint="pair_style zero CUTOFF")
    options: Options = {"cut": args.number(), "nocoeff": False, "full": False}
    while len(args):
        word = args.word()
        if word.text not in ("nocoeff", "full"):
            args.fail(f"Unknown pair style zero option {word.text}", word, hint="nocoeff or full")
        options[word.text] = True
    return options


def read(sim: Any, args: Args, options: Options) -> tuple[tuple[float, ...], float]:
    if options["nocoeff"]:
        args.rest()
    if len(args) > 1:
        args.fail("Incorrect args for pair coefficients", args.words[args.at + 1], hint="pair_coeff I J [cutoff]")
    return (), args.number() if len(args) else options["cut"]


def mix(a: Any, cut_a: float, b: Any, cut_b: float, rule: str) -> tuple[tuple[float, ...], float]:
    return (), mix_distance(cut_a, cut_b, rule)


PAIRS.add(
    "zero",
    PairStyle(
        name="zero", manual="pair_zero.html", coeffs=(), law=None, settings=settings, read=read,
        row=lambda coeffs, cut, shift: (), mix=mix, mixes_energy=False,
        restart=Blob(
            settings=(("cut", NUMBER), ("nocoeff", UNLESS)), coeffs=("cut",), defaults=(("full", False),),
        ),
    ),
)  # fmt: skip
