"""The text of a data file: numbered lines, the header, section by section. It knows no simulation.

Source: LAMMPS manual, read_data.html; what is accepted and every sentence as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.span import Span
from pylmp.text.words import Word

_INTEGER = re.compile(r"[-+]?\d+", re.ASCII)
_FLOAT = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", re.ASCII)
_WORD = re.compile(r"\S+")
_LARGEST = 2**31 - 1
_KINDS = "bond", "angle", "dihedral", "improper"
_COUNTS = (
    "atoms", "ellipsoids", "lines", "triangles", "bodies", "bonds", "angles", "dihedrals", "impropers", "atom types",
    *(f"{kind} types" for kind in _KINDS), *(f"extra {kind} per atom" for kind in _KINDS), "extra special per atom",
)  # fmt: skip
_COUNT = re.compile(r"\s*(\d+)\s+(" + "|".join(name.replace(" ", r"\s+") for name in _COUNTS) + r")(\s.*)?", re.ASCII)
_BOUND = re.compile(r"\s*([-+.\deE]+)\s+([-+.\deE]+)\s+([xyz])lo\s+\3hi(\s.*)?", re.ASCII)
_TILTED = re.compile(r"\s*([-+.\deE]+)\s+([-+.\deE]+)\s+([-+.\deE]+)\s+xy\s+xz\s+yz(\s.*)?", re.ASCII)
_GENERAL = re.compile(r"\s*(?:[-+.\deE]+\s+){3}([abc]vec|abc\s+origin)(\s.*)?", re.ASCII)
SECTIONS = (
    "Masses", "Atoms", "Velocities", "Bonds", "Angles", "Dihedrals", "Impropers", "Ellipsoids", "Lines", "Triangles",
    "Bodies", "Pair Coeffs", "PairIJ Coeffs", "Bond Coeffs", "Angle Coeffs", "Dihedral Coeffs", "Improper Coeffs",
    "BondBond Coeffs", "BondAngle Coeffs", "MiddleBondTorsion Coeffs", "EndBondTorsion Coeffs", "AngleTorsion Coeffs",
    "AngleAngleTorsion Coeffs", "BondBond13 Coeffs", "AngleAngle Coeffs", "Atom Type Labels", "Bond Type Labels",
    "Angle Type Labels", "Dihedral Type Labels", "Improper Type Labels",
)  # fmt: skip


@dataclass
class Header:
    """counts: by the words of the file ("atoms", "bond types", ...); lines: where each stands; units: "" if not said.
    lo, hi: faces of the box, -0.5 and 0.5 where the file is silent, as in LAMMPS. tilt: xy xz yz, None if not said; tilted: its line."""

    counts: dict[str, int] = field(default_factory=dict)
    lines: dict[str, int] = field(default_factory=dict)
    lo: list[float] = field(default_factory=lambda: [-0.5] * 3)
    hi: list[float] = field(default_factory=lambda: [0.5] * 3)
    units: str = ""
    tilt: list[float] | None = None
    tilted: int = 0

    def count(self, name: str) -> int:
        return self.counts.get(name, 0)

    def other_tilt(self, tilt: list[float] | None) -> str:
        """What LAMMPS says of a file that is added to a box with tilt (None: orthogonal), where its own differs; else ""."""
        if self.tilt is not None and tilt is None:
            return "Read_data subsequent file cannot switch to restricted triclinic"
        if self.tilt is None and tilt is not None:
            return "Read_data subsequent file cannot switch to orthogonal"
        return "Read_data subsequent file tilt factors must be same as first file" if self.tilt != tilt else ""


class DataFile:
    """lines: the physical lines; at: the next one to read. Errors name file, line and column."""

    def __init__(self, path: Path, text: str) -> None:
        self.name = str(path)
        self.lines = text.split("\n")
        if self.lines and not self.lines[-1]:
            self.lines.pop()
        self.at = 0

    def span(self, line: int, word: str = "") -> Span:
        """The first place of word in a line, or the whole line."""
        text = self.lines[line] if line < len(self.lines) else ""
        found = re.search(r"(?<!\S)" + re.escape(word) + r"(?!\S)", text) if word else None
        begin, end = found.span() if found else (len(text) - len(text.lstrip()), len(text.rstrip()))
        return Span(self.name, line + 1, begin + 1, max(1, end - begin))

    def fail(self, message: str, line: int, word: str = "", *, hint: str = "") -> NoReturn:
        raise ScriptError(message, self.span(line, word), hint=hint, manual="read_data.html")

    # ---- words and numbers ------------------------------------------------------------------------------------

    def words(self, line: int) -> list[str]:
        """The words of a line. A comment begins at a word that begins with #."""
        text = self.lines[line]
        return (re.split(r"(?:^|(?<=\s))#", text)[0] if "#" in text else text).split()

    def spanned(self, line: int) -> list[Word]:
        """The words of a line with their places; a comment begins at any #."""
        text = self.lines[line].split("#")[0]
        return [Word(m[0], Span(self.name, line + 1, m.start() + 1, len(m[0]))) for m in _WORD.finditer(text)]

    def number(self, word: str, line: int) -> float:
        if not _FLOAT.fullmatch(word):
            self.fail(f"Expected floating point parameter instead of '{word}' in input script or data file", line, word)
        value = float(word)
        if math.isinf(value):
            self.fail(f"Floating point number {word} in input script or data file is out of range", line, word)
        return value

    def integer(self, word: str, line: int) -> int:
        if not _INTEGER.fullmatch(word):
            self.fail(f"Expected integer parameter instead of '{word}' in input script or data file", line, word)
        value = int(word) if len(word) < 20 else _LARGEST + 1
        if abs(value) > _LARGEST:
            self.fail(f"Integer {word} in input script or data file is out of range", line, word)
        return value

    # ---- header and sections ------------------------------------------------------------------------------------

    def header(self) -> Header:
        """Read up to the first line that is no header line."""
        result = Header()
        if self.lines and (said := re.search(r"units = (\w+)", self.lines[0])):
            result.units = said[1]
        self.at = 1  # the first line is a title
        while self.at < len(self.lines):
            text = self.lines[self.at].split("#")[0]
            if found := _COUNT.fullmatch(text):
                name = " ".join(found[2].split())
                result.counts[name], result.lines[name] = self.integer(found[1], self.at), self.at
            elif found := _BOUND.fullmatch(text):
                d = "xyz".index(found[3])
                result.lo[d], result.hi[d] = self.number(found[1], self.at), self.number(found[2], self.at)
                result.lines[f"{found[3]}lo"] = self.at
            elif found := _TILTED.fullmatch(text):
                result.tilt, result.tilted = [self.number(found[k], self.at) for k in (1, 2, 3)], self.at
            elif _GENERAL.fullmatch(text):
                raise Unsupported(
                    "LAMMPS has general triclinic boxes, pylmp's native engines do not", self.span(self.at),
                    hint="xlo xhi, ylo yhi, zlo zhi and xy xz yz", manual="Howto_triclinic.html",
                )  # fmt: skip
            elif text.strip():
                self._check_section(self.at)
                break
            self.at += 1
        return result

    def sections(self) -> Iterator[tuple[str, str, int]]:
        """(name, word after #, line) of each section; self.at is then its first line of data.

        The word after # of the first section is not looked at: LAMMPS loses it.
        """
        first = True
        while True:
            while self.at < len(self.lines) and not self.lines[self.at].split("#")[0].strip():
                self.at += 1
            if self.at >= len(self.lines):
                return
            line = self.at
            name = self._check_section(line)
            style = self.lines[line].partition("#")[2].split()
            self.at += 2  # the line after a section's name is skipped, whatever it holds
            yield name, style[0] if style and not first else "", line
            first = False

    def _check_section(self, line: int) -> str:
        name = " ".join(self.lines[line].split("#")[0].split())
        if name not in SECTIONS:
            self.fail(
                f"Unknown identifier in data file: {self.lines[line].split('#')[0].strip()}", line,
                hint="a count, a box face, or the name of a section with an empty line after it",
            )  # fmt: skip
        return name

    def take(self, count: int, hint: str) -> range:
        """The next count lines."""
        first = self.at
        if first + count > len(self.lines):
            self.fail("Unexpected end of data file", max(0, len(self.lines) - 1), hint=hint)
        self.at = first + count
        return range(first, self.at)
