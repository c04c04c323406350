"""The tables that pair_style table looks things up in, made of a section of a file.

All run over the squared distance s: lookup holds the middles of N - 1 equal intervals, linear and spline N equally spaced points,
bitmap 2^N points whose distance grows with s: the last bits of the exponent and the first bits of the mantissa of s as a single
precision number are its place in the table (D. Wolff, W. Rudd, Comp. Phys. Comm. 120, 20 (1999)).

Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.spline import evaluate, second_derivatives
from pylmp.model.style import Options
from pylmp.model.table_file import MOST, Section, warn_of_forces
from pylmp.text.diagnostic import Unsupported

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

LOOKUP, LINEAR, SPLINE, BITMAP = range(4)  # as restart files have them
KINDS = {"lookup": LOOKUP, "linear": LINEAR, "spline": SPLINE, "bitmap": BITMAP}
_NEAR = 1.0e-6  # distances of a file that are taken for those that its parameters describe
_EXPONENT, _MANTISSA = 8, 24  # bits of a single precision number, with the leading one


@dataclass
class Source:
    """A section, made ready. e2, f2: second derivatives of its splines; match: its values are the table's."""

    section: Section
    low: float
    high: float
    cut: float
    e2: Floats
    f2: Floats
    match: bool

    def energy(self, r: Floats) -> Floats:
        return self.section.e if self.match else evaluate(self.section.r, self.section.e, self.e2, r)

    def force(self, r: Floats) -> Floats:
        return self.section.f if self.match else evaluate(self.section.r, self.section.f, self.f2, r)


def settle(sim: Simulation, section: Section) -> tuple[float, float]:
    """The range of a section. R, RSQ and BITMAP say better than its rows which distances are meant; what looks wrong is warned of."""
    n = len(section.r)
    if section.parameters.spacing is None:
        warn_of_forces(sim, section, f" {section.keyword}")
        return (float(section.r[0]), float(section.r[-1])) if n else (0.0, 0.0)
    how, low, high = section.parameters.spacing
    k = np.arange(n)
    with np.errstate(all="ignore"):
        if how == "BITMAP":
            r = _file_distances(section, low, high)
        elif how == "R":
            r = low + (high - low) * k / (n - 1)
        else:
            r = np.sqrt(low * low + (high * high - low * low) * k / (n - 1))
        wrong = int((np.abs(r - section.r) / section.r > _NEAR).sum())
    section.r = r
    if how != "BITMAP":
        warn_of_forces(sim, section, f" {section.keyword}")
    if wrong:
        sim.console.warning(
            f"{wrong} of {n} distance values in table 1e-06 with relative error\n"
            f"WARNING:  over {section.keyword} to re-computed values"
        )
    return low, high


def source_of(section: Section, ends: tuple[float, float], cut: float | None, options: Options) -> Source:
    """Check a settled section and spline it. cut: as pair_coeff says, or None."""
    low, high = ends
    if len(section.r) <= 1:
        section.fail("Invalid pair table length", "two rows or more")
    cut = high if cut is None else cut
    if cut <= low or cut > high:
        section.fail("Pair table cutoff outside of table", f"the table reaches from {low:g} to {high:g}")
    if low <= 0.0:
        section.fail("Invalid pair table lower boundary", "distances above 0")
    kind, count, spacing = options["style"], options["entries"], section.parameters.spacing
    how = spacing[0] if spacing else ""
    match = high == cut and (
        (kind == LINEAR and how == "RSQ" and len(section.r) == count)
        or (kind == BITMAP and how == "BITMAP" and len(section.r) == 1 << count)
    )
    if how == "BITMAP" and not match:
        section.fail("Bitmapped table in file does not match requested table", f"pair_style table bitmap, 2^N rows, cutoff {high:g}")
    e2 = f2 = np.zeros(0)
    if how != "BITMAP":
        e2 = second_derivatives(section.r, section.e, -section.f[0], -section.f[-1])
        f2 = second_derivatives(section.r, section.f, *section.end_slopes())
    return Source(section, low, high, cut, e2, f2, match)


def _file_distances(section: Section, low: float, high: float) -> Floats:
    count = section.parameters.count.bit_length() - 1
    if section.parameters.count != 1 << count:
        section.fail("Bitmapped table is incorrect length in table file", "2^N rows")
    try:
        return np.sqrt(bits_of(low, high, count).distances())
    except UnfitBits as error:
        section.fail(str(error), "a range and a number of rows that fit each other")


def spread(source: Source, kind: int, count: int) -> tuple[tuple[float, ...], Floats]:
    """(numbers for the law, columns one after the other). count: N."""
    if kind == BITMAP:
        return _bitmap(source, count)
    low2, cut2 = source.low * source.low, source.cut * source.cut
    delta = (cut2 - low2) / (count - 1)
    head = (low2, 1.0 / delta, delta, float(count), delta * delta / 6.0)
    if kind == LOOKUP:
        r = np.sqrt(low2 + (np.arange(count - 1) + 0.5) * delta)
        return head, np.concatenate([source.energy(r), source.force(r) / r])
    s = low2 + np.arange(count, dtype=np.float64) * delta
    r = np.sqrt(s)
    energy, force = source.energy(r), source.force(r)
    if kind == LINEAR:
        force = force / r
        return head, np.concatenate([energy, _steps(energy), force, _steps(force)])
    slopes = _slopes(source, force, low2, cut2, delta)
    e2 = second_derivatives(s, energy, -force[0] / (2.0 * math.sqrt(low2)), -force[-1] / (2.0 * source.cut))
    force = force / r
    return head, np.concatenate([energy, e2, force, second_derivatives(s, force, *slopes)])


def _steps(values: Floats) -> Floats:
    """From each value to the next."""
    return np.append(values[1:] - values[:-1], 0.0)


def _slopes(source: Source, f: Floats, low2: float, cut2: float, delta: float) -> tuple[float, float]:
    """Slopes of f/r over the squared distance at both ends: from those of the file, else of short secants."""
    given, low, cut = source.section.parameters.slopes, math.sqrt(low2), source.cut
    step = 0.1 * delta
    near, far = math.sqrt(low2 + step), math.sqrt(cut2 - step)
    inside = source.force(np.array([near, far]))
    first = (inside[0] / near - f[0] / low) / step
    last = (f[-1] / math.sqrt(cut2) - inside[1] / far) / step
    if given:
        first = (given[0] / low - f[0] / low2) / (2.0 * low)
        if cut == source.section.r[-1]:
            last = (given[1] / cut - f[-1] / (cut * cut)) / (2.0 * cut)
    return float(first), float(last)


@dataclass(frozen=True)
class Bits:
    """How a squared distance between low^2 and high^2 is a place in a table of 2^count.

    mask     the bits of a single precision number that are looked at, and all below
    shift    how many of these are below
    above    the other bits, of low^2 and of high^2
    """

    count: int
    mask: int
    shift: int
    above: tuple[int, int]
    least: float

    def distances(self) -> Floats:
        """Squared distances of all places; those that low^2 excludes are beyond high^2's power of two."""
        places = np.arange(1 << self.count, dtype=np.int64) << self.shift
        low = _number(places | self.above[0])
        return np.where(low < self.least, _number(places | self.above[1]), low)


class UnfitBits(ValueError):
    """A table that bits cannot make; LAMMPS's sentence."""


def bits_of(low: float, high: float, count: int) -> Bits:
    """Raises UnfitBits if the table is too small or too large for these distances."""
    exponent = math.frexp(low * low)[1] - 1  # of the power of two below low^2
    exponents = 0  # bits of the exponent that the range needs
    while 2.0 ** (1 << exponents) < high * high / 2.0**exponent:
        exponents += 1
    mantissa = count - exponents
    if exponents > _EXPONENT:
        raise UnfitBits("Too many exponent bits for lookup table")
    if mantissa + 1 > _MANTISSA:
        raise UnfitBits("Too many mantissa bits for lookup table")
    if mantissa < 3:
        raise UnfitBits("Too few bits for lookup table")
    shift = _MANTISSA - (mantissa + 1)
    mask = (1 << (count + shift)) - 1
    low_bits, high_bits = (int(bits) & ~mask for bits in _bits(np.array([low * low, high * high])))
    return Bits(count, mask, shift, (low_bits, high_bits), low * low)


def _bits(values: Floats) -> Ints:
    return values.astype(np.float32).view(np.int32).astype(np.int64)


def _number(bits: Ints) -> Floats:
    return bits.astype(np.int32).view(np.float32).astype(np.float64)


def _bitmap(source: Source, count: int) -> tuple[tuple[float, ...], Floats]:
    """Columns: squared distances, 1 over the steps between them, energies, their steps, forces over distance, their steps.

    The places of ascending distances follow one another around the end of the table. The last one's steps lead to the cutoff.
    """
    try:
        bits = bits_of(source.low, source.cut, count)
    except UnfitBits as error:
        source.section.fail(str(error), "another N of pair_style table bitmap")
    if 1 << count > MOST:
        raise Unsupported(f"LAMMPS has pair tables of 2^{count} values, pylmp's native engines do not", hint="a smaller N")
    s = bits.distances()
    energy, force = _mapped(source, s)
    columns = [s, energy, force]
    steps = [np.append(values[1:], values[0]) - values for values in columns]
    with np.errstate(all="ignore"):
        steps[0] = 1.0 / steps[0]
    first = int(np.argmin(s))
    last = first - 1
    cut2 = source.cut * source.cut
    if _number(np.array([((last % len(s)) << bits.shift) | bits.above[1]]))[0] < cut2:
        if source.match:
            for step in steps:
                step[last] = step[last - 1]
        else:
            end = np.array([cut2]).astype(np.float32).astype(np.float64)
            more = _mapped(source, end)
            steps[0][last] = 1.0 / (end[0] - s[last])
            steps[1][last], steps[2][last] = more[0][0] - energy[last], more[1][0] - force[last]
    head = (float(s[first]), float(bits.mask), float(bits.shift), float(1 << count), 0.0)
    return head, np.concatenate([column for pair in zip(columns, steps, strict=True) for column in pair])


def _mapped(source: Source, s: Floats) -> tuple[Floats, Floats]:
    """Energy and force over distance."""
    r = np.sqrt(s)
    return source.energy(r), source.force(r) / r
