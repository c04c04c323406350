"""Dumps of LAMMPS in its own text format, read snapshot by snapshot. They know no simulation.

Source: LAMMPS manual, dump.html, read_dump.html; sentences as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from pylmp.io.packed import Unpackable, read_packed
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.span import Span

MANUAL = "read_dump.html"
_LONGEST = 10_000_000  # a number of atoms beyond this is a garbled one, unless the file is as long
Floats = NDArray[np.float64]


@dataclass
class Snapshot:
    """One frame.

    step      of the simulation; lo hi: (3,) faces; tilt: (3,) xy xz yz, or None; boundary: ("pp", "fs", ...), () if not said
    columns   names of the columns; first, count: its rows are lines first .. first + count - 1 of the file
    """

    file: DumpFile
    step: int
    count: int
    lo: Floats
    hi: Floats
    tilt: Floats | None
    boundary: tuple[str, ...]
    columns: list[str]
    first: int

    def table(self, columns: list[int]) -> Floats:
        """(count, len(columns)) the numbers of some columns. Raises ScriptError at the line that lacks one."""
        rows = []
        for line in range(self.first, self.first + self.count):
            words = self.file.lines[line].split()
            if len(words) < len(self.columns):
                self.file.fail("Insufficient columns in dump file", line, f"{len(self.columns)} columns")
            try:
                rows.append([float(words[column]) for column in columns])
            except ValueError:
                bad = next(words[c] for c in columns if not _is_number(words[c]))
                self.file.fail("Dump file is incorrectly formatted", line, f"{bad[:20]!r} is no number")
        return np.array(rows).reshape(self.count, len(columns))


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


class DumpFile:
    """lines: those of the text; errors name file and line."""

    def __init__(self, name: str) -> None:
        self.name = name
        try:
            text = read_packed(Path(name))
        except OSError as error:
            raise ScriptError(f"Cannot open file {name}: {error.strerror}", manual=MANUAL) from None
        except Unpackable as error:
            raise ScriptError(f"Cannot read file {name}: {error}", manual=MANUAL) from None
        self.lines = text.split("\n")
        if self.lines and not self.lines[-1]:
            self.lines.pop()

    def fail(self, message: str, line: int, hint: str = "") -> NoReturn:
        text = self.lines[line] if line < len(self.lines) else ""
        raise ScriptError(message, Span(self.name, min(line, len(self.lines)) + 1, 1, max(1, len(text))), hint=hint, manual=MANUAL)

    def snapshots(self) -> Iterator[Snapshot]:
        """All of them, in order; the rows are not looked at."""
        at = 0
        while at < len(self.lines):
            at, snapshot = self._snapshot(at)
            yield snapshot

    def _snapshot(self, at: int) -> tuple[int, Snapshot]:
        for item, after in (("UNITS", 2), ("TIME\n", 2)):
            if at < len(self.lines) and (self.lines[at] + "\n").startswith(f"ITEM: {item}"):
                at += after
        self._expect(at, "ITEM: TIMESTEP")
        step = self._integer(at + 1)
        self._expect(at + 2, "ITEM: NUMBER OF ATOMS")
        count = self._integer(at + 3)
        if not 0 <= count <= max(len(self.lines), _LONGEST):
            self.fail("Dump file is incorrectly formatted", at + 3, f"{count} atoms")
        self._expect(at + 4, "ITEM: BOX BOUNDS")
        lo, hi, tilt, boundary = self._box(at + 4)
        self._expect(at + 8, "ITEM: ATOMS")
        columns = self.lines[at + 8].split()[2:]
        first = at + 9
        if first + count > len(self.lines):
            self.fail("Unexpected end of dump file", len(self.lines), f"{count} atoms should follow line {first}")
        return first + count, Snapshot(self, step, count, lo, hi, tilt, boundary, columns, first)

    def _expect(self, at: int, words: str) -> None:
        if at >= len(self.lines):
            self.fail("Unexpected end of dump file", at, f"{words} should stand here")
        if not self.lines[at].startswith(words):
            self.fail("Dump file is incorrectly formatted", at, f"{words} should stand here")

    def _integer(self, at: int) -> int:
        if at >= len(self.lines):
            self.fail("Unexpected end of dump file", at)
        if not re.fullmatch(r"\s*-?\d{1,18}\s*", self.lines[at], re.ASCII):
            self.fail("Dump file is incorrectly formatted", at, "a whole number should stand here")
        return int(self.lines[at])

    def _box(self, at: int) -> tuple[Floats, Floats, Floats | None, tuple[str, ...]]:
        words = self.lines[at].split()[3:]
        if words[:1] == ["abc"]:
            raise Unsupported("LAMMPS has general triclinic boxes, pylmp's native engines do not", Span(self.name, at + 1, 1, 1))
        tilted = words[:3] == ["xy", "xz", "yz"]
        rows = []
        for line in range(at + 1, at + 4):
            if line >= len(self.lines):
                self.fail("Unexpected end of dump file", line)
            numbers = [float(word) for word in self.lines[line].split() if _is_number(word)]
            if len(numbers) < 2 + tilted or not all(math.isfinite(number) for number in numbers):
                self.fail("Dump file is incorrectly formatted", line, "the faces of the box should stand here")
            rows.append(numbers)
        lo, hi = np.array([row[0] for row in rows]), np.array([row[1] for row in rows])
        boundary = tuple(words[3 * tilted :])
        if not tilted:
            return lo, hi, None, boundary
        xy, xz, yz = (row[2] for row in rows)
        lo[0] -= min(min(min(0.0, xy), xz), xy + xz)
        hi[0] -= max(max(max(0.0, xy), xz), xy + xz)
        lo[1] -= min(0.0, yz)
        hi[1] -= max(0.0, yz)
        return lo, hi, np.array([xy, xz, yz]), boundary
