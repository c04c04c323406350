"""pair_style table lookup|linear|spline|bitmap N keywords...; pair_coeff I J FILE KEYWORD [CUTOFF]: energy and force from N values between
those of a file.

The file's energy and force are splined over its distances; between N values of these, taken over the squared distance, energy and
force over distance are constant (lookup), linear (linear, bitmap) or cubic (spline).

Source: LAMMPS manual, pair_table.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import Any

from pylmp.laws import bits, select, single, whole
from pylmp.model.blob import FLAG, INTEGER, Blob
from pylmp.model.pair_tables import BITMAP, KINDS, LOOKUP, SPLINE, settle, source_of, spread
from pylmp.model.registry import PAIRS
from pylmp.model.style import Law, Options, PairStyle
from pylmp.model.table_file import TableFile, number_of_values
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest
from pylmp.text.words import Args

HEAD = 5  # numbers before the tables
LONG_RANGE = ("ewald", "pppm", "msm", "dispersion", "tip4p")  # what the table may be combined with


def law(options: Options) -> Law:
    kind = options["style"]
    if kind == BITMAP:
        return mapped
    spline, lookup = kind == SPLINE, kind == LOOKUP

    def tabulated(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
        """c = first distance^2, 1/step, step, N, step^2/6, cutoff^2, where the data begin, data (columns of N or N - 1)."""
        low2, inverse, delta, count, sixth, cut2, begin, data = c
        column = whole(count)
        last = column - 2
        i = whole((r2 - low2) * inverse)
        i = select(i < 0, 0, i)
        i = select(i > last, last, i)
        at = whole(begin) + i
        if lookup:
            energy, force = data[at], data[at + column - 1]
        else:
            t = (r2 - (low2 + i * delta)) * inverse
            up = at + 2 * column
            if spline:
                a = 1.0 - t
                aaa, ttt = a * a * a - a, t * t * t - t
                energy = a * data[at] + t * data[at + 1] + (aaa * data[at + column] + ttt * data[at + column + 1]) * sixth
                force = a * data[up] + t * data[up + 1] + (aaa * data[up + column] + ttt * data[up + column + 1]) * sixth
            else:
                energy = data[at] + t * data[at + column]
                force = data[up] + t * data[up + column]
        inside = r2 < cut2
        return select(inside, factor * force, 0.0), select(inside, factor * energy, 0.0)

    return tabulated


def mapped(r2: Any, dot: Any, factor: Any, c: Any) -> Any:
    """c = first distance^2, mask, shift, size, 0, cutoff^2, where the data begin, data (six columns): see model/pair_tables.py."""
    _, mask, shift, size, _, cut2, begin, data = c
    column = whole(size)
    at = whole(begin) + ((bits(r2) & whole(mask)) >> whole(shift))
    t = (single(r2) - data[at]) * data[at + column]
    energy = data[at + 2 * column] + t * data[at + 3 * column]
    force = data[at + 4 * column] + t * data[at + 5 * column]
    inside = r2 < cut2
    return select(inside, factor * force, 0.0), select(inside, factor * energy, 0.0)


def outside(options: Options) -> Law:
    bitmap = options["style"] == BITMAP

    def watch(r2: Any, c: Any) -> Any:
        """A distance that the table does not reach."""
        low2, inverse, count, cut2 = c[0], c[1], c[3], c[5]
        if bitmap:
            return r2 < low2
        return (r2 < cut2) & ((r2 < low2) | (whole((r2 - low2) * inverse) >= whole(count) - 1))

    return watch


def report(sim: Any, part: Any, first: int, second: int) -> None:
    atoms = sim.atoms
    d = atoms.x[first] - atoms.x[second]
    r2 = float(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])
    i, j = int(atoms.type[first]), int(atoms.type[second])
    side = "< table inner" if r2 < part.table[i, j, 0] else "> table outer"
    raise ScriptError(
        f"Pair distance {side} cutoff: ijtype {i} {j} dist {shortest(math.sqrt(r2))}",
        hint="a table that begins nearer, or a smaller timestep", manual="pair_table.html",
    )  # fmt: skip


def settings(sim: Any, args: Args) -> Options:
    if len(args) < 2:
        says, last = "Illegal pair_style table command: missing argument(s)", args.words[-1] if args.words else args.owner
        args.fail(says, last, hint="pair_style table lookup|linear|spline|bitmap N")
    style, entries = args.word(), args.word()
    if style.text not in KINDS:
        hint = " ".join(KINDS)
        args.fail(f"Unknown table style in pair_style command: {style.text}", style, hint=hint)
    options: Options = {"style": KINDS[style.text], "entries": number_of_values(args, entries, "pair")}
    options |= dict.fromkeys(LONG_RANGE, False)
    while len(args):
        word = args.word()
        if word.text not in LONG_RANGE:
            args.fail(f"Unknown pair_style table keyword: {word.text}", word, hint=" ".join(LONG_RANGE))
        options[word.text] = True
    return options


def read(sim: Any, args: Args, options: Options) -> tuple[tuple[Any, ...], float]:
    """FILE KEYWORD [CUTOFF] -> (numbers for the law and the array of its tables, cutoff)."""
    if not 2 <= len(args) <= 3:
        last = args.words[-1] if args.words else args.owner
        args.fail("Illegal pair_coeff command", last, hint="pair_coeff I J FILE KEYWORD [CUTOFF]")
    name, keyword = args.word(), args.word()
    section = TableFile(sim, "pair", name).section(keyword.text)
    ends = settle(sim, section)
    source = source_of(section, ends, args.number() if len(args) else None, options)
    head, data = spread(source, options["style"], options["entries"])
    return (*head, data), source.cut


PAIRS.add(
    "table",
    PairStyle(
        name="table", manual="pair_table.html", coeffs=(), law=law, settings=settings, read=read,
        row=lambda coeffs, cut, shift: (*coeffs[:HEAD], cut * cut), data=lambda coeffs, cut: coeffs[HEAD],
        watch=outside, report=report, write=None,
        restart=Blob(settings=(("style", INTEGER), ("entries", INTEGER), *((name, FLAG) for name in LONG_RANGE)), kept=False),
    ),
)  # fmt: skip
