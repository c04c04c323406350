"""The bond force field of a simulation: one style, or several side by side under bond_style hybrid."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.model import bond_memory
from pylmp.model.atoms import AnyInts, Floats, Ints
from pylmp.model.fix import BIRTHS
from pylmp.model.style import BondStyle, Options
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args


class BondPart:
    """One style at work.

    table (nbt+1, width): coefficients by bond type; of a style with tables also where each type's begin in data.
    mine (nbt+1,) uint8: types of this style.
    recorder: the fix that keeps records of broken bonds, or None.
    """

    def __init__(self, style: BondStyle, options: Options, types: int) -> None:
        self.style = style
        self.options = options
        self.tabled = style.read is not None
        self.table = np.zeros((types + 1, len(style.coeffs) + self.tabled))
        self.data = np.zeros(0 if self.tabled else 1)
        self.mine = np.zeros(types + 1, np.uint8)
        self.law = style.law(options)
        self.watch = style.watch(options) if style.watch else None
        self.can_break = style.can_break(options)
        self.updates_special = style.updates_special(options)
        self.recorder: Any = None
        self.stored = not style.reference  # r0 of every bond is known
        self.longest_reference = 0.0  # largest r0 seen at the first init, for the communication cutoff
        self.stretch = 1.0
        self.born = next(BIRTHS)  # in the order of what keeps something in restart files
        self.memory_born = next(BIRTHS)
        self.waits = False  # it came from a restart file, and takes what its bonds remember at the first init
        self.shifts = True  # when a bond is removed, what the bonds in other slots remember moves with them

    @property
    def memory(self) -> int:
        return len(self.style.history)

    def set(self, types: range, values: tuple[float, ...]) -> None:
        for kind in types:
            self.table[kind] = values
            self.mine[kind] = 1

    def columns(self, kinds: Ints) -> tuple[Any, ...]:
        """What the law receives of many bonds at once."""
        columns = tuple(self.style.freeze(tuple(self.table[kinds].T)))
        return (*columns, self.data) if self.tabled else columns

    def evaluate(self, kinds: Ints, r2: Floats, dot: Floats, history: Floats, own: Floats | None = None) -> tuple[Floats, Floats]:
        """Force over r and energy of many bonds by the law itself. history: (bonds, memory); own: a number of each, if the law needs it."""
        force, energy = np.zeros(len(r2)), np.zeros(len(r2))
        columns = (*self.columns(kinds), *(() if own is None else (own,)))
        with np.errstate(all="ignore"):
            result = self.law(r2, dot, tuple(history.T), columns)
        force[:], energy[:] = result[0], result[1]
        return force, energy


class Bond:
    """name: the style, or "hybrid". parts: the styles at work, one unless hybrid."""

    def __init__(self, name: str, parts: list[BondPart], types: int) -> None:
        self.name = name
        self.parts = parts
        self.types = types
        self.given: set[int] = set()  # types that bond_coeff named
        self.restored = False  # it came from a restart file

    @property
    def memory(self) -> int:
        """Numbers a bond slot remembers: the most any part wants."""
        return max((part.memory for part in self.parts), default=0)

    def coeff(self, sim: Simulation, args: Args) -> None:
        """bond_coeff: a type range, under hybrid the style's name, then its coefficients."""
        kinds = args.types(self.types)
        part: BondPart | None = self.parts[0]
        if self.name == "hybrid":
            word = args.word()
            name = word.text.removesuffix("/omp")
            part = next((p for p in self.parts if p.style.name == name), None)
            if part is None and word.text != "none":
                hint = " ".join(p.style.name for p in self.parts) + " none"
                args.fail(f"Expected hybrid sub-style instead of {word.text} in bond_coeff command", word, hint=hint)
        values = _coefficients(sim, args, part) if part else ()
        for other in self.parts:
            other.mine[kinds.start : kinds.stop] = 0
        self.given.update(kinds)
        if part is not None:
            part.set(kinds, values)
            if part.style.reference:
                part.stretch = max(part.stretch, 1.0 + values[1])

    def init(self, sim: Simulation) -> None:
        """Check coefficients and every restriction, in LAMMPS's order."""
        hint, manual = "bond_coeff * ... sets all", "bond_coeff.html"
        if not self.given and not self.restored:
            says = "Bond coeffs are not set. Status:\nBond style not yet initialized"
            raise ScriptError(says, hint=hint, manual=manual)
        if len(self.given) < self.types:
            status = "".join(
                f"\n{kind:6d}: is {'set' if kind in self.given else 'not set'}" for kind in range(1, self.types + 1)
            )
            raise ScriptError(f"All bond coeffs are not set. Status:{status}", hint=hint, manual=manual)
        for part in self.parts:
            if not part.mine.any():
                raise ScriptError(f"Bond hybrid sub-style {part.style.name} is not used", hint=hint, manual=manual)
        for part in self.parts:
            for restriction in part.style.restrictions:
                restriction.check(sim, part.options, part.style.manual)
            for caution in part.style.cautions(sim, part.options):
                sim.console.warning(caution)
            bond_memory.take_breaks(sim, part)
            part.shifts = not part.waits  # LAMMPS forgets to until the set-up after the first one
            if part.waits:
                part.waits, part.memory_born = False, next(BIRTHS)
                bond_memory.take(sim, part)
            if part.style.volumes(part.options):
                bond_memory.take_volumes(sim)
            if part.style.reference and part.longest_reference == 0.0:
                stored = bond_memory.longest_reference(sim) if part.stored else 0.0
                part.longest_reference = stored or longest_bond(sim)
        if any(all(part.mine[kind] == 0 for part in self.parts) for kind in self.given):
            says, hint = "Invoked bond equil distance on bond style none", "every bond type needs a style"
            raise ScriptError(says, hint=hint, manual="bond_hybrid.html")

    def write_coeffs(self) -> list[tuple[int, tuple[float, ...]]]:
        """(type, coefficients) of the Bond Coeffs section of a data file; empty where LAMMPS writes no such section."""
        (part, *others) = self.parts
        if others or self.name == "hybrid" or not part.style.writes:
            return []
        return [(kind, tuple(part.table[kind].tolist())) for kind in range(1, self.types + 1)]

    def longest(self) -> float:
        """The longest equilibrium length."""
        longest = 0.0
        for part in self.parts:
            if part.style.reference:
                length = part.longest_reference * (part.stretch / 1.5 if part.can_break else 1.0)
                longest = max(longest, length)
            else:
                for kind in np.flatnonzero(part.mine):
                    longest = max(longest, part.style.length(tuple(part.table[kind]), part.options))
        return longest


def _coefficients(sim: Simulation, args: Args, part: BondPart) -> tuple[float, ...]:
    """The numbers after the type range (and style name)."""
    if part.style.read is not None:
        numbers, data = part.style.read(sim, args, part.options)
        begin = float(len(part.data))
        part.data = np.concatenate([part.data, data])
        return (*numbers, begin)
    wanted = len(part.style.coeffs)
    if part.options.get("nocoeff"):
        args.rest()
        return (0.0,) * wanted
    given = len(args)
    if not wanted - part.style.optional_coeffs <= given <= wanted:
        at = args.words[args.at + wanted] if given > wanted else args.words[-1]
        names = " ".join(c.name for c in part.style.coeffs)
        args.fail("Incorrect args for bond coefficients", at, hint=f"bond_coeff TYPE {names}")
    values = tuple([args.number() for _ in range(given)] + [0.0] * (wanted - given))
    part.style.check(part.options, args, values)
    return values


def bond_pairs(sim: Simulation, wanted: Callable[[AnyInts], Any]) -> tuple[Ints, Ints, Ints]:
    """(rows, slots, partner rows) of owned atoms' bonds whose type satisfies wanted, in row and slot order; partner -1: unknown."""
    return pairs_of_rows(sim, wanted, 0, sim.atoms.n, sim.atoms.rows_by_tag())


def pairs_of_rows(sim: Simulation, wanted: Callable[[AnyInts], Any], begin: int, end: int, by_tag: Ints) -> tuple[Ints, Ints, Ints]:
    """The same of rows begin to end. by_tag: as rows_by_tag gives it."""
    atoms = sim.atoms
    slots = np.arange(atoms.bond_per_atom)
    rows, cols = np.nonzero((slots < atoms.num_bond[begin:end, None]) & wanted(atoms.bond_type[begin:end]))
    rows += begin
    partner = atoms.bond_atom[rows, cols]
    unknown = partner >= len(by_tag)
    partner[unknown] = 0
    found = by_tag[partner]
    found[unknown] = -1
    return rows, cols, found


def longest_bond(sim: Simulation) -> float:
    """The longest bond by minimum image."""
    rows, _, partners = bond_pairs(sim, lambda kinds: kinds > 0)
    keep = partners >= 0
    if not keep.any():
        return 0.0
    x = sim.atoms.x
    d = sim.box.minimum_image(x[rows[keep]] - x[partners[keep]])
    return float(np.sqrt(d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]).max())


def beside(sim: Simulation, i: int, j: int) -> Floats:
    """(3,) where row j is, seen from row i: where no ghosts are kept, its nearest periodic image."""
    x = sim.atoms.x
    if sim.atoms.ghosts:
        return x[j]
    d = x[i] - x[j]
    return np.asarray(x[j] + (d - sim.box.minimum_image(d[None])[0]))
