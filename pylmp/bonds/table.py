"""bond_style table linear|spline N; bond_coeff TYPE FILE KEYWORD: energy and force from N values between those of a file.

The file's energy and force are splined over its lengths, N values are taken at equal distances, and between these the
potential is linear or a cubic spline. Up to one distance short of the first length it goes on as it began; with linear it
also goes on beyond the last one for that far.

Source: LAMMPS manual, bond_table.html. Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pylmp.laws import select, sqrt, whole
from pylmp.model.atoms import Floats, Ints
from pylmp.model.blob import INTEGER, Blob
from pylmp.model.registry import BONDS
from pylmp.model.spline import evaluate, second_derivatives
from pylmp.model.style import BondStyle, Coeff, Law, Options
from pylmp.model.table_file import Section, TableFile, number_of_values, warn_of_forces
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import eight
from pylmp.text.words import Args

LINEAR, SPLINE = 1, 2  # as restart files have them
KINDS = {"linear": LINEAR, "spline": SPLINE}


def law(options: Options) -> Law:
    spline = options["style"] == SPLINE

    def tabulated(r2: Any, dot: Any, h: Any, c: Any) -> Any:
        """c = first length, 1/distance, distance, N, distance^2/6, length at rest, where the data begin, data (four columns of N + 1)."""
        low, inverse, delta, count, sixth, _, begin, data = c
        r = sqrt(r2)
        i = whole((r - low) * inverse)
        i = select(i < 0, 0, i)
        i = select(i > whole(count) - 1, whole(count) - 1, i)
        at, column = whole(begin) + i, whole(count) + 1
        t = (r - (low + i * delta)) * inverse
        if spline:
            a = 1.0 - t
            aaa, bbb = a * a * a - a, t * t * t - t
            energy = a * data[at] + t * data[at + 1] + (aaa * data[at + column] + bbb * data[at + column + 1]) * sixth
            at = at + 2 * column
            force = a * data[at] + t * data[at + 1] + (aaa * data[at + column] + bbb * data[at + column + 1]) * sixth
        else:
            energy = data[at] + t * data[at + column]
            force = data[at + 2 * column] + t * data[at + 3 * column]
        return force / r, energy, h, True

    return tabulated


def outside(options: Options) -> Law:
    spline = options["style"] == SPLINE

    def watch(r2: Any, c: Any) -> Any:
        """A length that the table does not reach, or that is none. Where LAMMPS reads behind its table, this one ends."""
        low, inverse, count = c[0], c[1], c[3]
        place = (sqrt(r2) - low) * inverse
        outside = (place <= -1.0) | (place >= count) | (r2 - r2 != 0.0)
        if spline:
            return outside | (place > count - 1.0)
        return outside | ((place > 1.0) & (count < 3.0))

    return watch


def report(sim: Any, part: Any, bonds: Ints) -> None:
    first, second, kind = bonds[0].tolist()
    d = sim.atoms.x[first] - sim.atoms.x[second]
    complain(float(np.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])), kind, part)


def report_alone(sim: Any, part: Any, r2: Floats, kinds: Ints) -> None:
    if len(r2):
        complain(float(np.sqrt(r2[0])), int(kinds[0]), part)


def complain(r: float, kind: int, part: Any) -> None:
    if not math.isfinite(r):
        raise ScriptError("Illegal bond in bond style table", hint="atoms flew away: a smaller timestep", manual="bond_table.html")
    side = "< table inner" if r < part.table[kind, 0] else "> table outer"
    raise ScriptError(
        f"Bond length {side} cutoff: type {kind} length {eight(r)}", hint="a table that reaches farther, or a smaller timestep",
        manual="bond_table.html",
    )  # fmt: skip


def parse(sim: Any, args: Args) -> Options:
    if len(args) != 2:
        last = args.words[-1] if args.words else args.owner
        args.fail("Illegal bond_style command: must have 2 arguments", last, hint="bond_style table linear|spline N")
    style, entries = args.word(), args.word()
    if style.text not in KINDS:
        args.fail(f"Unknown table style {style.text} in bond style table", style, hint="linear or spline")
    return {"style": KINDS[style.text], "entries": number_of_values(args, entries, "bond")}


def read(sim: Any, args: Args, options: Options) -> tuple[tuple[float, ...], Floats]:
    """FILE KEYWORD -> (numbers for the law, data)."""
    if len(args) != 2:
        last = args.words[-1] if args.words else args.owner
        args.fail("Illegal bond_coeff command: must have 3 arguments", last, hint="bond_coeff TYPE FILE KEYWORD")
    name, keyword = args.word(), args.word()
    section = TableFile(sim, "bond", name).section(keyword.text)
    warn_of_forces(sim, section, "")
    if len(section.r) <= 1:
        section.fail(f"Invalid bond table length: {section.parameters.count}", "two rows or more")
    if section.r[0] >= section.r[-1]:
        section.fail("Bond table values are not increasing", "lengths ascend")
    return spread(section, options["entries"], options["style"] == SPLINE)


def spread(section: Section, count: int, spline: bool) -> tuple[tuple[float, ...], Floats]:
    """The file's table over count equal distances."""
    r, e, f = section.r, section.e, section.f
    ends = section.end_slopes()
    e2 = second_derivatives(r, e, -f[0], -f[-1])
    f2 = second_derivatives(r, f, *ends)
    low, delta = r[0], (r[-1] - r[0]) / (count - 1)
    places = low + np.arange(count) * delta
    energy, force = evaluate(r, e, e2, places), evaluate(r, f, f2, places)
    data = np.zeros((4, count + 1))
    data[0, :count], data[2, :count] = energy, force
    if spline:
        data[1, :count] = second_derivatives(places, energy, -force[0], -force[-1])
        data[3, :count] = second_derivatives(places, force, *ends)
    else:
        for row in (0, 2):
            data[row + 1, : count - 1] = data[row, 1:count] - data[row, : count - 1]
            data[row + 1, count - 1] = 2.0 * data[row + 1, count - 2] - data[row + 1, max(count - 3, 0)]
    rest = section.parameters.rest
    length = r[np.argmin(e)] if rest is None else rest
    return (low, 1.0 / delta, delta, float(count), delta * delta / 6.0, length), data.ravel()


BONDS.add(
    "table",
    BondStyle(
        name="table", manual="bond_table.html",
        coeffs=(
            Coeff("lo", "distance"), Coeff("1/delta", "1/distance"), Coeff("delta", "distance"), Coeff("N", "unitless"),
            Coeff("delta^2/6", "distance^2"), Coeff("r0", "distance"),
        ),
        law=law, parse=parse, read=read, watch=outside, report=report, report_alone=report_alone, writes=False,
        length=lambda coeffs, options: coeffs[5], omp=True, release="table",
        restart=Blob(settings=(("style", INTEGER), ("entries", INTEGER)), kept=False),
    ),
)  # fmt: skip
