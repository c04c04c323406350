"""Masses and coefficients of a data file."""

from __future__ import annotations

from dataclasses import dataclass, replace

from pylmp.io.data_file import DataFile
from pylmp.io.data_types import TypeMap
from pylmp.model.labels import is_label
from pylmp.model.simulation import Simulation
from pylmp.model.topology import BOND, KIND, Kind
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_CLASS2 = {
    "BondBond": "angle", "BondAngle": "angle", "MiddleBondTorsion": "dihedral", "EndBondTorsion": "dihedral",
    "AngleTorsion": "dihedral", "AngleAngleTorsion": "dihedral", "BondBond13": "dihedral", "AngleAngle": "improper",
}  # fmt: skip
_SUFFIXES = "", "/omp", "/opt", "/gpu", "/kk", "/intel", "/coul/cut", "/coul/long", "/coul/msm", "/coul/dsf", "/coul/debye"


@dataclass(frozen=True)
class Section:
    """A section of coefficients: its name, the style its header names, the line of the header.

    set: give them to the force field. With read_data nocoeff they are only looked at; LAMMPS swaps in style zero
    meanwhile, and says so.
    """

    sim: Simulation
    file: DataFile
    name: str
    style: str
    line: int
    set: bool
    types: TypeMap

    def rows(self, count: int, kind: Kind | None = None) -> list[list[Word]]:
        """The words of the next count lines."""
        result = []
        for line in self.file.take(count, f"{count} lines of {self.name}"):
            words = self.file.spanned(line)
            if not words:
                many = kind is not None and kind is not BOND
                section = f"{kind.name.capitalize()}Coeffs" if kind and many else self.name.replace(" ", "")
                told = "" if many else f". Expected {count} lines."
                self.file.fail(f"Unexpected empty line in {section} section{told}", line, hint=f"{count} lines")
            result.append(words)
        return result

    def kind(self, kind: str, word: Word) -> Word:
        """The word of a type, labels are not allowed here, as the number of that type in the simulation."""
        assert word.span is not None
        number = self.file.integer(word.text, word.span.line - 1)
        return replace(word, text=str(self.types.coefficient(kind, number)))


def read_masses(sim: Simulation, file: DataFile, count: int, types: TypeMap) -> None:
    """Lines ``type mass``."""
    for line in file.take(count, f"one mass for each of {count} atom types"):
        words, text = file.words(line), file.lines[line].strip()
        if len(words) != 2:
            file.fail(f"Invalid format in Masses section of data file: {text}", line, hint="type mass")
        kind = types.number("atom", words[0])
        if kind is None and sim.labels.in_use and is_label(words[0]):
            file.fail(f"Unknown atom type {words[0]} in Masses section of data file: {text}", line, words[0])
        kind, mass = file.integer(words[0], line) if kind is None else kind, file.number(words[1], line)
        if not 1 <= kind <= sim.atom_types:
            file.fail(f"Invalid atom type {kind} in Masses section of data file: {text}", line, words[0])
        if mass <= 0.0:
            file.fail(f"Invalid mass value {words[1]} in Masses section of data file: {text}", line, words[1])
        sim.mass[kind] = mass


def read_pair_coeffs(section: Section, types: int) -> None:
    """Lines ``type values`` (Pair Coeffs) or ``type type values`` (PairIJ Coeffs)."""
    sim, name = section.sim, section.name
    if section.set and sim.pair is None:
        section.file.fail(f"Must define pair_style before {name}", section.line, hint="pair_style before read_data")
    warn_style(sim, "Pair", section.style, sim.pair.name if section.set else "zero")
    unlike = name == "PairIJ Coeffs"
    for words in section.rows(types * (types + 1) // 2 if unlike else types):
        kinds = [section.kind("atom", word) for word in words[: 2 if unlike else 1]]
        if not section.set:
            continue
        if int(kinds[0].text) > int(kinds[-1].text):
            hint = "the smaller type comes first"
            raise ScriptError("Incorrect args for pair coefficients", words[1].span, hint=hint)
        words = [kinds[0], kinds[-1], *words[len(kinds) :]]
        sim.pair.coeff(sim, Args("pair_coeff", words, words[0], "pair_coeff.html"))


def read_bonded_coeffs(section: Section, kind: Kind, count: int) -> None:
    """Lines ``type values`` of Bond Coeffs, Angle Coeffs, ...; of those for class2 styles only the type is let pass, as by style zero."""
    sim, name, style = section.sim, kind.name, kind.style(section.sim)
    if section.set and style is None:
        section.file.fail(f"Must define {name}_style before {section.name}", section.line, hint=f"{name}_style before read_data")
    warn_style(sim, name.capitalize(), section.style, style.name if section.set else "zero")
    own = section.name == f"{name.capitalize()} Coeffs"
    for words in section.rows(count, kind):
        type_word = section.kind(name, words[0])
        if section.set and not own and len(words) > 1:
            raise ScriptError(f"Incorrect args for {name} coefficients", words[1].span, hint=f"{name}_style {style.name} has none")
        if section.set and own:
            style.coeff(sim, Args(f"{name}_coeff", [type_word, *words[1:]], words[0], f"{name}_coeff.html"))


def coefficients_of(name: str) -> Kind | None:
    """The kind that a section of coefficients is about."""
    first = name.split()[0]
    return KIND.get(_CLASS2.get(first, first.lower()))


def warn_style(sim: Simulation, kind: str, said: str, current: str) -> None:
    """Warn if a section is of another style. Like LAMMPS it looks at a shorter name's letters, but of a longer one only at what follows
    the length of the current one: nothing, or a suffix."""
    if current.startswith(said) or (len(said) >= len(current) and said[len(current) :] in _SUFFIXES):
        return
    where = f"in data file {said}" if kind == "Atom" else f"{said} in data file"
    sim.console.warning(f"{kind} style {where} differs from currently defined {kind.lower()} style {current}")
