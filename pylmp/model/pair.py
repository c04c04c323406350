"""The pair force field of a simulation: a style, its settings, and coefficients for every pair of atom types."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.style import PairStyle
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args

GEOMETRIC, ARITHMETIC, SIXTHPOWER = "geometric", "arithmetic", "sixthpower"


def mix_distance(a: float, b: float, rule: str) -> float:
    """A length (sigma, cutoff) of an unlike pair."""
    if rule == ARITHMETIC:
        return 0.5 * (a + b)
    if rule == SIXTHPOWER:
        return math.pow(0.5 * (_sixth(a) + _sixth(b)), 1.0 / 6.0)
    return math.sqrt(a * b)


def mix_energy(e1: float, e2: float, s1: float, s2: float, rule: str) -> float:
    """A well depth of an unlike pair; sigmas matter for sixthpower only."""
    if rule == SIXTHPOWER:
        return 2.0 * math.sqrt(e1 * e2) * (s1 * (s1 * s1)) * (s2 * (s2 * s2)) / (_sixth(s1) + _sixth(s2))
    return math.sqrt(e1 * e2)


def _sixth(x: float) -> float:
    """x^6 by repeated squaring, which C's pow rounds differently."""
    square = x * x
    return square * (square * square)


class Pair:
    """style, options: as pair_style said. mix, shift, tail: as pair_modify said.

    After init: cut (nt+1, nt+1) cutoffs, 0.0 where none; table (nt+1, nt+1, width) what the law receives.
    """

    def __init__(self, style: PairStyle, options: dict[str, object], types: int) -> None:
        self.style = style
        self.options = options
        self.mix = GEOMETRIC
        self.shift = self.tail = False
        self.given: dict[tuple[int, int], tuple[tuple[float, ...], float]] = {}
        self.all: dict[tuple[int, int], tuple[tuple[float, ...], float]] = {}
        self.types = types
        self.cut = np.zeros((types + 1, types + 1))
        self.table = np.zeros((types + 1, types + 1, 0))
        self.law = style.law(options) if style.law else None
        self.alone = style.alone(options) if style.alone else self.law
        self.velocity = style.velocity

    @property
    def width(self) -> int:
        return self.table.shape[2]

    def coeff(self, args: Args) -> None:
        """pair_coeff: two type ranges, then the style's words."""
        if all(word.text.isdigit() for word in args.words[:2]) and int(args.words[0].text) > int(args.words[1].text):
            args.words[:2] = args.words[1::-1]
        first, second = args.types(self.types), args.types(self.types)
        values = self.style.read(args, self.options)
        if len(args):
            args.fail("Incorrect args for pair coefficients", args.peek())
        pairs = [(i, j) for i in first for j in second if j >= i]
        if not pairs:
            args.fail(
                "Incorrect args for pair coefficients", args.words[1], hint="no pair of types I <= J in these ranges"
            )
        for pair in pairs:
            self.given[pair] = values

    def init(self, sim: Simulation) -> None:
        """Mix what was not given, check, fill cut and table. Raises ScriptError for unset or broken restrictions."""
        if self.shift and self.tail:
            raise ScriptError(
                "Cannot have both pair_modify shift and tail set to yes", hint="one of the two, or neither"
            )
        if self.tail and sim.dimension == 2:
            raise ScriptError("Cannot use pair tail corrections with 2d simulations", hint="pair_modify tail no")
        if self.tail and not all(sim.box.periodic):
            sim.console.warning("Using pair tail corrections with non-periodic system")
        self._check_set()
        for restriction in self.style.restrictions:
            restriction.check(sim, self.options, self.style.manual)
        mixed, unlike = 0, self.types * (self.types - 1) // 2
        self.all = {}
        for i, j in self._pairs():
            if (i, j) in self.given:
                self.all[i, j] = self.given[i, j]
            elif self.style.mix is not None:
                self.all[i, j] = self.style.mix(*self.given[i, i], *self.given[j, j], self.mix)
                mixed += bool(self.style.coeffs)  # LAMMPS counts pairs whose energies it mixes
        self._fill()
        sim.console.both(f"Generated {mixed} of {unlike} mixed pair_coeff terms from {self.mix} mixing rule\n")

    def _check_set(self) -> None:
        hint, manual = "pair_coeff * * ... sets all", "pair_coeff.html"
        if not self.given:
            raise ScriptError(
                "All pair coeffs are not set. Status:\nPair style not yet initialized", hint=hint, manual=manual
            )
        pairs = self._pairs()
        alike = all((i, i) in self.given for i in range(1, self.types + 1))
        if alike and (self.style.mix is not None or all(pair in self.given for pair in pairs)):
            return
        status = "".join(f"\n{i:6d} {j:6d}: is {'set' if (i, j) in self.given else 'not set'}" for i, j in pairs)
        raise ScriptError(f"All pair coeffs are not set. Status:{status}", hint=hint, manual=manual)

    def _fill(self) -> None:
        rows = {pair: self.style.row(*values, self.shift) for pair, values in self.all.items()}
        size = self.types + 1
        self.cut = np.zeros((size, size))
        self.table = np.zeros((size, size, len(next(iter(rows.values())))))
        for (i, j), values in rows.items():
            self.table[i, j] = self.table[j, i] = values
            self.cut[i, j] = self.cut[j, i] = self.all[i, j][1]

    def write_coeffs(self, whole: bool) -> list[tuple[tuple[int, ...], list[float]]]:
        """Lines of a data file: (I,) and numbers (Pair Coeffs), or whole: (I, J) and numbers (PairIJ Coeffs)."""
        if whole:
            return [(pair, self.style.write(*self.all[pair], True, self.options)) for pair in self._pairs()]
        return [((i,), self.style.write(*self.given[i, i], False, self.options)) for i in range(1, self.types + 1)]

    def tails(self, sim: Simulation) -> tuple[float, float]:
        """Long-range corrections (energy, pressure) before division by V and V*V; zero unless pair_modify tail yes."""
        if not self.tail or self.style.tail is None:
            return 0.0, 0.0
        counts = np.bincount(sim.atoms.type[: sim.atoms.n], minlength=self.types + 1)
        energy = pressure = 0.0
        for i, j in self._pairs():
            e, p = self.style.tail(*self.all[i, j], float(counts[i]), float(counts[j]))
            for _ in range(1 if i == j else 2):
                energy += e
                pressure += p
        return energy, pressure

    def _pairs(self) -> list[tuple[int, int]]:
        """All (i, j) with i <= j."""
        return [(i, j) for i in range(1, self.types + 1) for j in range(i, self.types + 1)]
