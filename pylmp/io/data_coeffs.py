"""Masses and coefficients of a data file."""

from __future__ import annotations

from dataclasses import dataclass

from pylmp.io.data_file import DataFile
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_SUFFIXES = "/omp", "/opt", "/gpu", "/kk", "/intel", "/coul/cut", "/coul/long", "/coul/msm", "/coul/dsf", "/coul/debye"


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

    def rows(self, count: int) -> list[list[Word]]:
        """The words of the next count lines."""
        result = []
        for line in self.file.take(count, f"{count} lines of {self.name}"):
            words = self.file.spanned(line)
            if not words:
                section = self.name.replace(" ", "")
                self.file.fail(f"Unexpected empty line in {section} section. Expected {count} lines.", line)
            result.append(words)
        return result

    def kind(self, word: Word) -> int:
        assert word.span is not None
        return self.file.integer(word.text, word.span.line - 1)


def read_masses(sim: Simulation, file: DataFile, types: int) -> None:
    """Lines ``type mass``."""
    for line in file.take(types, f"one mass for each of {types} atom types"):
        words, text = file.words(line), file.lines[line].strip()
        if len(words) != 2:
            file.fail(f"Invalid format in Masses section of data file: {text}", line, hint="type mass")
        kind, mass = file.integer(words[0], line), file.number(words[1], line)
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
        kinds = [section.kind(word) for word in words[: 2 if unlike else 1]]
        if not section.set:
            continue
        if kinds != sorted(kinds):
            hint = "the smaller type comes first"
            raise ScriptError("Incorrect args for pair coefficients", words[1].span, hint=hint)
        words = words if unlike else [words[0], *words]
        sim.pair.coeff(Args("pair_coeff", words, words[0], "pair_coeff.html"))


def read_bond_coeffs(section: Section, types: int) -> None:
    """Lines ``type values``."""
    sim = section.sim
    if section.set and sim.bond is None:
        section.file.fail("Must define bond_style before Bond Coeffs", section.line, hint="bond_style before read_data")
    warn_style(sim, "Bond", section.style, sim.bond.name if section.set else "zero")
    for words in section.rows(types):
        section.kind(words[0])
        if section.set:
            sim.bond.coeff(Args("bond_coeff", words, words[0], "bond_coeff.html"))


def warn_style(sim: Simulation, kind: str, said: str, current: str) -> None:
    """Warn if a section is of another style; a shorter name and the suffixes LAMMPS knows pass."""
    longer = said.removeprefix(current)
    if current.startswith(said) or (longer != said and longer in _SUFFIXES):
        return
    where = f"in data file {said}" if kind == "Atom" else f"{said} in data file"
    sim.console.warning(f"{kind} style {where} differs from currently defined {kind.lower()} style {current}")
