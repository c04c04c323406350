"""The pair force field of a simulation: one style, or several side by side under pair_style hybrid and hybrid/overlay."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.pair_alone import Alone, compose, evaluate
from pylmp.model.settings import PairSettings
from pylmp.model.style import Options, PairStyle
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args

Types = tuple[int, int]
Values = tuple[tuple[float, ...], float]  # coefficients, cutoff


class PairPart:
    """One style at work.

    style, options     as pair_style said; number: which of several parts of one style, 0 if it is the only one
    settings           as pair_modify said
    given              (i, j) -> coefficients and cutoff as pair_coeff said
    mine               pairs of types (i <= j) that this part acts on; all of them unless hybrid
    all                (i, j) of mine -> coefficients and cutoff, mixed ones included (after init)
    cut                (nt+1, nt+1) distances at which its law ends, 0.0 where it does not act (after init)
    table              (nt+1, nt+1, width) what the law receives (after init)
    data               what the law looks up, where the style has tables (after init); each row of table ends with where its own begin
    energy             of the last evaluation that tallied
    """

    def __init__(self, style: PairStyle, options: Options, number: int = 0) -> None:
        self.style = style
        self.options = options
        self.number = number
        self.settings = PairSettings()
        self.given: dict[Types, Values] = {}
        self.mine: list[Types] = []
        self.all: dict[Types, Values] = {}
        self.cut = np.zeros((1, 1))
        self.table = np.zeros((1, 1, 0))
        self.data = np.zeros(1)
        self.energy = 0.0
        self.law: Function = style.law(options) if style.law else None
        self.alone: Function = style.alone(options) if style.alone else self.law

    @property
    def width(self) -> int:
        return self.table.shape[2]

    def read(self, args: Args) -> Values:
        """The words of pair_coeff behind the types (and style name)."""
        values = self.style.read(args, self.options)
        if len(args):
            args.fail("Incorrect args for pair coefficients", args.peek())
        return values

    def complete(self, mine: list[Types], types: int) -> int:
        """Mix what was not given, fill cut and table. Returns how many pairs of types were mixed."""
        self.mine = mine
        self.all, mixed = {}, 0
        for i, j in mine:
            if (i, j) in self.given:
                self.all[i, j] = self.given[i, j]
            elif self.style.mix is not None:
                self.all[i, j] = self.style.mix(*self.given[i, i], *self.given[j, j], self.settings.mix)
                mixed += bool(self.style.coeffs)  # LAMMPS counts pairs whose energies it mixes
        size = types + 1
        self.cut = np.zeros((size, size))
        rows = {pair: self.style.row(*values, self.settings.shift) for pair, values in self.all.items()}
        if self.style.data is not None:
            begins, self.data = _tables([self.style.data(*values) for values in self.all.values()])
            rows = {pair: (*row, begin) for (pair, row), begin in zip(rows.items(), begins, strict=True)}
        self.table = np.zeros((size, size, len(next(iter(rows.values()), ()))))
        for (i, j), row in rows.items():
            self.table[i, j] = self.table[j, i] = row
            self.cut[i, j] = self.cut[j, i] = self.style.reach(*self.all[i, j])
        return mixed

    def tails(self, sim: Simulation) -> tuple[float, float]:
        """Long-range corrections (energy, pressure) before division by V and V*V."""
        if not self.settings.tail or self.style.tail is None:
            return 0.0, 0.0
        counts = np.bincount(sim.atoms.type[: sim.atoms.n], minlength=sim.atom_types + 1)
        energy = pressure = 0.0
        for i, j in self.mine:
            e, p = self.style.tail(*self.all[i, j], float(counts[i]), float(counts[j]))
            for _ in range(1 if i == j else 2):
                energy += e
                pressure += p
        return energy, pressure


def _tables(arrays: list[Floats]) -> tuple[list[float], Floats]:
    """Where each begins in the whole, and the whole."""
    ends = np.cumsum([len(array) for array in arrays])
    return [0.0, *map(float, ends[:-1])], np.concatenate(arrays)


class Pair:
    """name: the style, "hybrid" or "hybrid/overlay". parts: the styles at work, one unless hybrid.

    acting    (i, j), i <= j -> parts that act on these types, in the order pair_coeff named them; none for `pair_coeff I J none`
    settings  as pair_modify said of all parts
    cut       (nt+1, nt+1) the largest cutoff of any part (after init)
    alone     what bond_style quartic takes out; None if nothing has a law (after init)
    """

    def __init__(self, name: str, parts: list[PairPart], types: int) -> None:
        self.name = name
        self.parts = parts
        self.types = types
        self.settings = PairSettings() if self.hybrid else parts[0].settings
        self.acting: dict[Types, list[PairPart]] = {}
        self.alone: Alone | None = None
        self.cut = np.zeros((types + 1, types + 1))

    @property
    def hybrid(self) -> bool:
        return self.name.startswith("hybrid")

    @property
    def tail(self) -> bool:
        return any(part.settings.tail for part in self.parts)

    @property
    def working(self) -> list[PairPart]:
        """The parts that have a law."""
        return [part for part in self.parts if part.law is not None]

    def single(
        self, r2: Floats, dot: Floats, first: Ints, second: Ints, factor: Floats | float = 1.0
    ) -> tuple[Floats, Floats]:
        """(force over r, energy) of pairs of atoms of types first and second, each alone; factor: their special weights."""
        return evaluate(self.working, r2, dot, first, second, factor)

    def coeff(self, args: Args) -> None:
        """pair_coeff: two type ranges, under hybrid the style's name, then the style's words."""
        if all(word.text.isdigit() for word in args.words[:2]) and int(args.words[0].text) > int(args.words[1].text):
            args.words[:2] = args.words[1::-1]
        first, second = args.types(self.types), args.types(self.types)
        part = self._named(args) if self.hybrid else self.parts[0]
        values = part.read(args) if part else ((), 0.0)
        pairs = [(i, j) for i in first for j in second if j >= i]
        if not pairs:
            args.fail(
                "Incorrect args for pair coefficients", args.words[1], hint="no pair of types I <= J in these ranges"
            )
        for pair in pairs:
            if part is None:
                self.acting[pair] = []
                continue
            part.given[pair] = values
            if self.name != "hybrid/overlay":
                self.acting[pair] = [part]
            elif part not in self.acting.setdefault(pair, []):
                self.acting[pair].append(part)

    def _named(self, args: Args) -> PairPart | None:
        """The part that pair_coeff names, by its style and, where several have that style, its number; None for none."""
        word = args.word()
        same = [part for part in self.parts if part.style.name == word.text]
        if word.text == "none":
            if len(args):
                args.fail("Incorrect args for pair coefficients", args.peek(), hint="nothing after none")
            return None
        if not same:
            hint = " ".join(dict.fromkeys(part.style.name for part in self.parts)) + " none"
            args.fail(f"Expected hybrid sub-style instead of {word.text} in pair_coeff command", word, hint=hint)
        return same[0]

    def init(self, sim: Simulation) -> None:
        """Mix what was not given, check, fill the tables. Raises ScriptError for unset or broken restrictions."""
        settings = self.settings
        if settings.shift and settings.tail:
            raise ScriptError(
                "Cannot have both pair_modify shift and tail set to yes", hint="one of the two, or neither"
            )
        if settings.tail and sim.dimension == 2:
            raise ScriptError("Cannot use pair tail corrections with 2d simulations", hint="pair_modify tail no")
        if settings.tail and not all(sim.box.periodic):
            sim.console.warning("Using pair tail corrections with non-periodic system")
        self._check_set()
        for part in self.parts:
            for restriction in part.style.restrictions:
                restriction.check(sim, part.options, part.style.manual)
        mixed, unlike = 0, self.types * (self.types - 1) // 2
        for part in self.parts:
            mine = [pair for pair in self._pairs() if part in self._acting(pair)]
            mixed += part.complete(mine, self.types)
        self.cut = np.max([part.cut for part in self.parts], axis=0)
        self.alone = compose(self.working) if self.working else None
        sim.console.both(f"Generated {mixed} of {unlike} mixed pair_coeff terms from {settings.mix} mixing rule\n")

    def _acting(self, pair: Types) -> list[PairPart]:
        """The parts that act on a pair of types; where none was said, the one whose coefficients can be mixed."""
        if pair in self.acting:
            return self.acting[pair]
        like = [self.acting.get((kind, kind), []) for kind in pair]
        return like[0] if len(like[0]) == 1 and like[0] == like[1] and like[0][0].style.mix is not None else []

    def _check_set(self) -> None:
        hint, manual = "pair_coeff * * ... sets all", "pair_coeff.html"
        if not self.acting:
            raise ScriptError(
                "All pair coeffs are not set. Status:\nPair style not yet initialized", hint=hint, manual=manual
            )
        pairs = self._pairs()
        if all(pair in self.acting or self._acting(pair) for pair in pairs):
            return
        status = "".join(f"\n{i:6d} {j:6d}: is {'set' if (i, j) in self.acting else 'not set'}" for i, j in pairs)
        raise ScriptError(f"All pair coeffs are not set. Status:{status}", hint=hint, manual=manual)

    def write_coeffs(self, whole: bool) -> list[tuple[tuple[int, ...], list[float]]]:
        """Lines of a data file: (I,) and numbers (Pair Coeffs), or whole: (I, J) and numbers (PairIJ Coeffs)."""
        (part,) = self.parts
        if whole:
            return [(pair, part.style.write(*part.all[pair], True, part.options)) for pair in self._pairs()]
        return [((i,), part.style.write(*part.given[i, i], False, part.options)) for i in range(1, self.types + 1)]

    def tails(self, sim: Simulation) -> tuple[float, float]:
        """Long-range corrections (energy, pressure) before division by V and V*V; zero unless pair_modify tail yes."""
        energy = pressure = 0.0
        for part in self.parts:
            e, p = part.tails(sim)
            energy += e
            pressure += p
        return energy, pressure

    def _pairs(self) -> list[Types]:
        """All (i, j) with i <= j."""
        return [(i, j) for i in range(1, self.types + 1) for j in range(i, self.types + 1)]
