"""The pair force field of a simulation: one style, or several side by side under pair_style hybrid and hybrid/overlay."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np

from pylmp.model.atoms import Floats, Ints
from pylmp.model.fix import BIRTHS
from pylmp.model.pair_alone import Alone, compose, evaluate, in_order
from pylmp.model.settings import PairSettings
from pylmp.model.style import Options, PairStyle
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args

Types = tuple[int, int]
Values = tuple[tuple[Any, ...], float]  # coefficients, cutoff


class PairPart:
    """One style at work.

    style, options     as pair_style said; number: which of several parts of one style, 0 if it is the only one
    settings           as pair_modify said
    given              (i, j) -> coefficients and cutoff as pair_coeff said
    mine               pairs of types (i <= j) that this part acts on; all of them unless hybrid
    all                (i, j) of mine -> coefficients and cutoff, mixed ones included (after init)
    mixed, mixes       those that were mixed, and whether any was: for what LAMMPS says of it
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
        self.mixed: set[Types] = set()
        self.mixes = False
        self.cut = np.zeros((1, 1))
        self.table = np.zeros((1, 1, 0))
        self.data = np.zeros(1)
        self.energy = 0.0
        self.watch: Function = style.watch(options) if style.watch else None
        self.law: Function = style.law(options) if style.law else None
        self.alone: Function = style.alone(options) if style.alone else self.law

    @property
    def width(self) -> int:
        return self.table.shape[2]

    @property
    def called(self) -> str:
        """As pair_coeff under hybrid names it."""
        return f"{self.style.name} {self.number}" if self.number else self.style.name

    def read(self, sim: Simulation, args: Args) -> Values:
        """The words of pair_coeff behind the types (and style name)."""
        values = self.style.read(sim, args, self.options)
        if len(args):
            args.fail("Incorrect args for pair coefficients", args.peek())
        return values

    def check_weights(self, sim: Simulation) -> None:
        """Raise ScriptError if weights of this part alone do not go with those of all."""
        for kind, mine, all_ in (("lj", self.settings.lj, sim.special.lj), ("coul", self.settings.coul, sim.special.coul)):
            for k, (a, b) in enumerate(zip(mine or all_, all_, strict=True)):
                if a != b and b in (0.0, 1.0):
                    raise ScriptError(
                        f"Pair_modify special {kind} 1-{k + 2} setting for pair hybrid substyle {self.style.name} incompatible "
                        "with global special_bonds setting",
                        hint=f"special_bonds {kind} with a weight between 0 and 1", manual="pair_modify.html",
                    )  # fmt: skip

    def complete(self, mine: list[Types], types: int) -> None:
        """Mix what was not given, fill cut and table."""
        self.mine = mine
        self.all, self.mixed = {}, set()
        for i, j in mine:
            if (i, j) in self.given:
                self.all[i, j] = self.given[i, j]
            elif self.style.mix is not None:
                self.all[i, j] = self.style.mix(*self.given[i, i], *self.given[j, j], self.settings.mix)
                if self.style.mixes_energy:
                    self.mixed.add((i, j))
        size = types + 1
        self.cut = np.zeros((size, size))
        rows = {pair: self.style.row(*values, self.settings.shift) for pair, values in self.all.items()}
        if self.style.data is not None:
            arrays = [self.style.data(*values) for values in self.all.values()]
            begins = np.cumsum([0, *map(len, arrays)]).tolist()
            self.data = np.concatenate(arrays)
            rows = {pair: (*row, begin) for (pair, row), begin in zip(rows.items(), begins, strict=False)}
        self.table = np.zeros((size, size, len(next(iter(rows.values()), ()))))
        for (i, j), row in rows.items():
            self.table[i, j] = self.table[j, i] = row
            self.cut[i, j] = self.cut[j, i] = self.style.reach(*self.all[i, j])

    def renew(self) -> None:
        """After given changed during a run: the same table holds what follows, but for the reach, with which a row ends."""
        table, cut = self.table, self.cut
        self.complete(self.mine, len(cut) - 1)
        table[..., :-1] = self.table[..., :-1]
        self.table, self.cut = table, cut

    def tails(self, sim: Simulation, pair: Types, counts: Ints) -> tuple[float, float]:
        """Corrections (energy, pressure) for a pair of types before division by V and V*V. counts: atoms by type."""
        if not self.settings.tail or self.style.tail is None:
            return 0.0, 0.0
        i, j = pair
        return self.style.tail(*self.all[pair], float(counts[i]), float(counts[j]))


class Pair:
    """name: the style, "hybrid" or "hybrid/overlay". parts: the styles at work, one unless hybrid.

    acting    (i, j), i <= j -> parts that act on these types, in the order pair_coeff named them; none for `pair_coeff I J none`
    settings  as pair_modify said of all parts
    born      number of the pair_style command that first chose it
    cut       (nt+1, nt+1) the largest cutoff of any part (after init)
    """

    def __init__(self, name: str, parts: list[PairPart], types: int) -> None:
        self.name = name
        self.parts = parts
        self.types = types
        self.settings = PairSettings() if self.hybrid else parts[0].settings
        self.acting: dict[Types, list[PairPart]] = {}
        self.born = next(BIRTHS)
        self.cut = np.zeros((types + 1, types + 1))

    @property
    def hybrid(self) -> bool:
        return self.name.startswith("hybrid")

    @property
    def tail(self) -> bool:
        return self.settings.tail

    @property
    def working(self) -> list[PairPart]:
        """The parts that have a law."""
        return [part for part in self.parts if part.law is not None]

    @property
    def acts(self) -> bool:
        """Not all parts were told `pair_modify compute no`."""
        return any(part.settings.compute for part in self.parts)

    def alone(self) -> Alone | None:
        """What bond_style quartic takes out; None if nothing has a law. Raises Unsupported where its order of rounding is lost."""
        return compose(in_order(self.working, self.acting.values())) if self.working else None

    def single(
        self, r2: Floats, dot: Floats, first: Ints, second: Ints, factor: Floats | float = 1.0
    ) -> tuple[Floats, Floats]:
        """(force over r, energy) of pairs of atoms of types first and second, each alone; factor: their special weights."""
        return evaluate(self.working, r2, dot, first, second, factor)

    def coeff(self, sim: Simulation, args: Args) -> None:
        """pair_coeff: two type ranges, under hybrid the style's name, then the style's words."""
        if all(word.text.isdigit() for word in args.words[:2]) and int(args.words[0].text) > int(args.words[1].text):
            args.words[:2] = args.words[1::-1]
        first, second = args.types(self.types), args.types(self.types)
        part = self._named(args) if self.hybrid else self.parts[0]
        values = part.read(sim, args) if part else ((), 0.0)
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
        if word.text == "none":
            if len(args):
                args.fail("Incorrect args for pair coefficients", args.peek(), hint="nothing after none")
            return None
        same = [part for part in self.parts if part.style.name == word.text]
        if len(same) > 1:
            if not len(args):
                args.fail("Incorrect args for pair coefficients", word, hint=f"{word.text} 1, {word.text} 2, ...")
            number = args.integer()
            same = [part for part in same if part.number == number]
        if not same:
            hint = " ".join(dict.fromkeys(part.called for part in self.parts)) + " none"
            args.fail(f"Expected hybrid sub-style instead of {word.text} in pair_coeff command", word, hint=hint)
        return same[0]

    def init(self, sim: Simulation) -> None:
        """Mix what was not given, check, fill the tables. Raises ScriptError for unset or broken restrictions."""
        settings = self.settings
        if settings.shift and settings.tail:
            raise ScriptError("Cannot have both pair_modify shift and tail set to yes", hint="one of the two, or neither")
        if settings.tail and sim.dimension == 2:
            raise ScriptError("Cannot use pair tail corrections with 2d simulations", hint="pair_modify tail no")
        if settings.tail and not all(sim.box.periodic):
            sim.console.warning("Using pair tail corrections with non-periodic system")
        if not self.acts and settings.tail:
            sim.console.warning("Using pair tail corrections with pair_modify compute no")
        if not self.acts and settings.shift:
            sim.console.warning("Using pair potential shift with pair_modify compute no")
        if not self.acting:
            self._complain("\nPair style not yet initialized")
        if not all((kind, kind) in self.acting for kind in range(1, self.types + 1)):
            self._complain(self._status())
        for part in self.parts:
            if self.hybrid and not any(part in acting for acting in self.acting.values()):
                raise ScriptError(f"Pair hybrid sub-style {part.style.name} is not used", manual="pair_hybrid.html")
        for part in self.parts:
            part.check_weights(sim)
        for part in self.parts:
            for restriction in part.style.restrictions:
                restriction.check(sim, part.options, part.style.manual)
        chosen = {pair: self._acting(pair) for pair in self._pairs()}
        for part in self.parts:
            part.complete([pair for pair, acting in chosen.items() if part in acting], self.types)
        self.cut = np.max([part.cut for part in self.parts], axis=0)
        unlike = self.types * (self.types - 1) // 2
        sim.console.both(
            f"Generated {self._mixed(chosen)} of {unlike} mixed pair_coeff terms from {settings.mix} mixing rule\n"
        )

    def _mixed(self, chosen: dict[Types, list[PairPart]]) -> int:
        """How many pairs of types LAMMPS says that it mixed: under hybrid, every one after the first of its style, for ever."""
        count = 0
        for pair, acting in chosen.items():
            for part in acting:
                part.mixes = pair in part.mixed or (self.hybrid and part.mixes)
            count += pair[0] != pair[1] and any(part.mixes for part in acting)
        return count

    def _acting(self, pair: Types) -> list[PairPart]:
        """The parts that act on a pair of types; where nothing was said, the one whose coefficients can be mixed."""
        if pair not in self.acting:
            first, second = (self.acting[kind, kind] for kind in pair)
            if len(first) != 1 or first != second or first[0].style.mix is None:
                self._complain(self._status())
            return first
        return self.acting[pair]

    def _complain(self, status: str) -> NoReturn:
        raise ScriptError(
            f"All pair coeffs are not set. Status:{status}", hint="pair_coeff * * ... sets all", manual="pair_coeff.html"
        )

    def _status(self) -> str:
        return "".join(f"\n{i:6d} {j:6d}: is {'set' if (i, j) in self.acting else 'not set'}" for i, j in self._pairs())

    def write_coeffs(self, whole: bool) -> list[tuple[tuple[int, ...], list[float]]]:
        """Lines of a data file: (I,) and numbers (Pair Coeffs), or whole: (I, J) and numbers (PairIJ Coeffs).

        None of styles that LAMMPS does not write there.
        """
        part = self.parts[0]
        if self.hybrid or part.style.write is None:
            return []
        if whole:
            return [(pair, part.style.write(*part.all[pair], True, part.options)) for pair in self._pairs()]
        return [((i,), part.style.write(*part.given[i, i], False, part.options)) for i in range(1, self.types + 1)]

    def tails(self, sim: Simulation) -> tuple[float, float]:
        """Long-range corrections (energy, pressure) before division by V and V*V; zero unless pair_modify tail yes."""
        energy = pressure = 0.0
        if self.settings.tail:
            counts = np.bincount(sim.atoms.type[: sim.atoms.n], minlength=sim.atom_types + 1)
            for i, j in self._pairs():
                e = p = 0.0
                for part in self._acting((i, j)):
                    more_e, more_p = part.tails(sim, (i, j), counts)
                    e += more_e
                    p += more_p
                for _ in range(1 if i == j else 2):
                    energy += e
                    pressure += p
        return energy, pressure

    def _pairs(self) -> list[Types]:
        """All (i, j) with i <= j."""
        return [(i, j) for i in range(1, self.types + 1) for j in range(i, self.types + 1)]
