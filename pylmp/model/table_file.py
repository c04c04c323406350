"""Files of tabulated potentials: sections of a keyword, a line of parameters, a line that is skipped, and rows `index r e f`.

Source: LAMMPS manual, pair_table.html and bond_table.html. Blank lines and comments stand anywhere but in place of the skipped line.
Sentences as measured on LAMMPS 22 Jul 2025; every error names file and line.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, NoReturn

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.paths import readable
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.span import Span
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

MOST = 10_000_000  # values of a table
_LONGEST = 1023  # bytes of a line that LAMMPS reads at once
_INTEGER = re.compile(r"[-+]?[0-9]+")
_FLOAT = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)(e[-+]?[0-9]+)?", re.IGNORECASE)
_ODD = re.compile(r"[-+]?(nan(\(\w*\))?|inf(inity)?|0x[0-9a-f.]+(p[-+]?[0-9]+)?)", re.IGNORECASE)  # what C reads too
_KCAL = 23.060549  # kcal/mol in one eV
_CONVERSIONS = {("real", "metal"): 1.0 / _KCAL, ("metal", "real"): _KCAL}  # of energies, from the file's units


@dataclass
class Parameters:
    """What the line behind the keyword says. slopes: of f at both ends; spacing: R, RSQ or BITMAP with its bounds, or nothing."""

    count: int = 0
    slopes: tuple[float, float] | None = None
    rest: float | None = None
    spacing: tuple[str, float, float] | None = None


@dataclass
class Section:
    """One table of a file. line: of its parameters, from 1; r, e, f: its columns, in the units of the simulation."""

    file: TableFile
    keyword: str
    line: int
    parameters: Parameters
    r: Floats
    e: Floats
    f: Floats

    def fail(self, message: str, hint: str) -> NoReturn:
        self.file.fail(message, self.line, hint)

    def end_slopes(self) -> tuple[float, float]:
        """Of f: as the file says, else of the secants at both ends."""
        r, f = self.r, self.f
        with np.errstate(all="ignore"):
            return self.parameters.slopes or ((f[1] - f[0]) / (r[1] - r[0]), (f[-1] - f[-2]) / (r[-1] - r[-2]))


class TableFile:
    """kind: "bond" or "pair". lines: without their ends. factor: from its units of energy to the simulation's."""

    def __init__(self, sim: Simulation, kind: str, word: Word) -> None:
        """Raises ScriptError at word if the file cannot be read, or is of other units."""
        self.kind, self.name = kind, word.text
        try:
            text = readable(sim, word).read_bytes().decode(errors="replace")
        except OSError as error:
            says = f"cannot open {kind} table potential file {self.name}: {error.strerror or 'not readable'}"
            raise ScriptError(says, word.span, hint="a file of tables", manual=f"{kind}_table.html") from None
        self.lines = [line.split("\0")[0] for line in text.split("\n")]
        if not self.lines[-1]:
            self.lines.pop()
        head = self.lines[0].split() if self.lines else []
        said = dict(reversed(list(zip(head, head[1:], strict=False))))
        if "DATE:" in said:
            sim.console.both(f"Reading {kind} table potential file {self.name} with DATE: {said['DATE:']}\n")
        units = said.get("UNITS:", sim.units.name)
        self.factor = _CONVERSIONS.get((units, sim.units.name), 1.0) if kind == "pair" else 1.0
        if self.factor != 1.0:
            sim.console.warning(f"Converting pair table potential in {units} units to {sim.units.name} units")
        elif units != sim.units.name:
            says = (
                f"{kind} table potential file {self.name} requires {units} units but {sim.units.name} units are in use"
            )
            self.fail(says, 1, f"units {units}")

    def fail(self, message: str, line: int, hint: str) -> NoReturn:
        """line: from 1."""
        line = max(1, min(line, len(self.lines)))
        text = self.lines[line - 1] if self.lines else ""
        raise ScriptError(
            message, Span(self.name, line, 1, max(1, len(text))), hint=hint, manual=f"{self.kind}_table.html"
        )

    def section(self, keyword: str) -> Section:
        """The first table of that name."""
        at = self._next(0)
        while at < len(self.lines) and self._words(at)[0] != keyword:
            at = self._next(at + 1)
        if at >= len(self.lines):
            self.fail(f"Did not find keyword {keyword} in table file", len(self.lines), self._known())
        at = self._next(at + 1)
        if at >= len(self.lines):
            self.fail(
                f"{self.kind.capitalize()} table parameters did not set N",
                at,
                "a line N and a number behind the keyword",
            )
        parameters = self._parameters(at)
        if at + 1 >= len(self.lines):
            self.fail(f"Missing line in {self.kind} table potential file!", at + 1, "a blank line, and the rows")
        rows, line = np.zeros((0, 3)), at + 2  # one line is skipped, whatever it holds
        if parameters.count > 0:
            rows = np.array(self._rows(line, keyword, parameters.count))
        return Section(
            self, keyword, at + 1, parameters, rows[:, 0], self.factor * rows[:, 1], self.factor * rows[:, 2]
        )

    def _rows(self, line: int, keyword: str, count: int) -> list[tuple[float, float, float]]:
        rows = []
        for k in range(1, count + 1):
            line = self._next(line)
            if line >= len(self.lines):
                says = f"Data missing when parsing {self.kind} table '{keyword}' line {k} of {count}."
                self.fail(says, line, "the line behind the parameters is skipped")
            rows.append(self._row(line, f"Error parsing {self.kind} table '{keyword}' line {k} of {count}. "))
            line += 1
        return rows

    def _known(self) -> str:
        firsts = [self._words(k)[0] for k in range(len(self.lines)) if self._words(k)]
        names = [name for name in dict.fromkeys(firsts) if name != "N" and not _FLOAT.fullmatch(name)]
        return "first words in the file: " + " ".join(names[:8]) if names else "there is no table in the file"

    def _words(self, line: int) -> list[str]:
        return self.lines[line].split("#")[0].split()

    def _next(self, line: int) -> int:
        """The first line from there on that holds a word; the number of lines if none does."""
        while line < len(self.lines) and not self._words(line):
            line += 1
        return line

    def _parameters(self, line: int) -> Parameters:
        words = iter(self._words(line))
        result = Parameters()

        def number(kind: type = float) -> float:
            word = next(words, None)
            if word is None:
                self.fail("No more tokens", line + 1, "every keyword is followed by its numbers")
            return self._number(word, kind, line, "")

        pair = self.kind == "pair"
        for word in words:
            if word == "N":
                result.count = int(number(int))
            elif word == ("FPRIME" if pair else "FP"):
                result.slopes = number(), number()  # LAMMPS does not convert them
            elif word == "EQ" and not pair:
                result.rest = number()
            elif word in ("R", "RSQ", "BITMAP") and pair:
                result.spacing = word, number(), number()
            else:
                says = (
                    f"Invalid keyword {word} in pair table parameters"
                    if pair
                    else f"Unknown keyword {word} in bond table parameters"
                )
                self.fail(says, line + 1, "N R RSQ BITMAP FPRIME" if pair else "N FP EQ")
        if result.count == 0:
            self.fail(f"{self.kind.capitalize()} table parameters did not set N", line + 1, "N and the number of rows")
        return result

    def _row(self, line: int, says: str) -> tuple[float, float, float]:
        if len(self.lines[line].encode()) > _LONGEST:
            self.fail(
                f"{says}It is longer than {_LONGEST} characters", line + 1, "LAMMPS does not read longer lines whole"
            )
        words = self._words(line)
        self._number(words[0], int, line, says)
        if len(words) < 4:
            self.fail(f"{says}No more tokens", line + 1, "index r energy force")
        r, e, f = (self._number(word, float, line, says) for word in words[1:4])
        return r, e, f

    def _number(self, word: str, kind: type, line: int, says: str) -> float:
        if kind is int:
            if not _INTEGER.fullmatch(word) or not -(2**31) <= int(word) < 2**31:
                self.fail(f"{says}Not a valid integer number: '{word}'", line + 1, "a whole number")
            return int(word)
        odd = _ODD.fullmatch(word)
        value = _FLOAT.fullmatch(word) and float(word)
        if odd:
            value = float.fromhex(word.split("(")[0])
        if value is None or (math.isinf(value) and not odd):
            self.fail(f"{says}Not a valid floating-point number: '{word}'", line + 1, "a number")
        return value


def number_of_values(args: Args, word: Word, kind: str) -> int:
    """N of bond_style or pair_style table."""
    count = args.as_integer(word)
    if not -(2**31) <= count < 2**31:
        args.fail(f"Integer {word.text} in input script or data file is out of range", word, hint="1000 is plenty")
    if count < 2:
        args.fail(f"Illegal number of {kind} table entries: {count}", word, hint="2 or more")
    if count > MOST:
        raise Unsupported(
            f"LAMMPS has {kind} tables of {count} values, pylmp's native engines do not",
            word.span,
            hint=f"{MOST} at most",
        )
    return count


def inconsistent(section: Section) -> int:
    """How many forces inside the table lie outside the two secants of the energy next to them."""
    r, e, f = section.r, section.e, section.f
    with np.errstate(all="ignore"):
        slopes = -(e[1:] - e[:-1]) / (r[1:] - r[:-1])
        low, high = np.minimum(slopes[:-1], slopes[1:]), np.maximum(slopes[:-1], slopes[1:])
        return int(((f[1:-1] < low) | (f[1:-1] > high)).sum())


def warn_of_forces(sim: Simulation, section: Section, name: str) -> None:
    """LAMMPS's warning; name: " KEYWORD", or nothing."""
    if wrong := inconsistent(section):
        sim.console.warning(
            f"{wrong} of {len(section.r)} force values in table{name} are inconsistent with -dE/dr.\n"
            "WARNING:  Should only be flagged at inflection points"
        )
