"""Comparing two runs: cell by cell, as numbers where both are numbers, else as text. Nothing is rounded."""

from __future__ import annotations

import math
import struct
from dataclasses import asdict, dataclass, field
from itertools import zip_longest
from pathlib import Path
from typing import Any

from pylmp.io.data_write import Contents, data_text
from pylmp.io.restart.files import read_restart
from pylmp.io.restart.restore import restore
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.tools.diff import read
from pylmp.tools.diff.instrument import COPY

IGNORED = {"log.lammps", COPY, "screen.txt", "tmp.lammps.variable"}  # the last: partitions' notes on universe variables


ANSWERS = "answers of commands"
LISTS = "neighbor lists"  # the part that says how a program works


@dataclass(frozen=True)
class Difference:
    """The first difference of one part: where, and both values. ulps: units in the last place, None for text."""

    part: str
    place: str
    pylmp: str
    lammps: str
    ulps: int | None = None


@dataclass
class Part:
    """One thing compared: how many cells, how many differ, the first that does.

    largest: of the differences between numbers; scale: the largest number that differs. words: differing cells that are no numbers, or missing.
    """

    name: str
    cells: int = 0
    differing: int = 0
    largest_ulps: int = 0
    largest: float = 0.0
    scale: float = 0.0
    words: int = 0
    first: Difference | None = None


@dataclass
class Comparison:
    parts: list[Part] = field(default_factory=list)

    @property
    def identical(self) -> bool:
        return all(part.first is None for part in self.parts)

    def as_dict(self) -> dict[str, Any]:
        return {"identical": self.identical, "parts": [asdict(part) for part in self.parts]}


def ulps(a: float, b: float) -> int:
    """How many doubles lie between a and b."""

    def key(value: float) -> int:
        (bits,) = struct.unpack("<q", struct.pack("<d", value))
        return bits if bits >= 0 else -(bits & 0x7FFF_FFFF_FFFF_FFFF)

    return abs(key(a) - key(b))


def runs(native: Path, reference: Path, inputs: set[str]) -> Comparison:
    """Compare what two runs left in their folders; inputs are files that were there before."""
    result = Comparison()
    logs = [(folder / "log.lammps").read_text() for folder in (native, reference)]
    result.parts.append(_tables(*(read.tables(log) for log in logs)))
    result.parts.append(_lines(ANSWERS, *(read.answers(log) for log in logs)))
    result.parts.append(_lines(LISTS, *(read.lists(log) for log in logs)))
    names = [
        {str(p.relative_to(f)) for p in f.rglob("*") if p.is_file()} - IGNORED - inputs for f in (native, reference)
    ]
    for name in sorted(names[0] | names[1]):
        if name in names[0] and name in names[1]:
            result.parts.append(_file(name, native / name, reference / name))
        else:
            part = Part(f"file {name}", 1, 1, words=1)
            there = ("written", "not written") if name in names[0] else ("not written", "written")
            part.first = Difference(part.name, "the file itself", *there)
            result.parts.append(part)
    return result


def _cell(part: Part, place: str, a: str, b: str) -> None:
    """Count one cell; remember the first that differs. Equal numbers in other words are equal."""
    part.cells += 1
    if a == b:
        return
    values = reals(a, b)
    apart = None
    if values is None:
        part.words += 1
    else:
        x, y = values
        if x == y or (x != x and y != y):
            return
        apart = ulps(x, y)
        part.largest_ulps = max(part.largest_ulps, apart)
        part.largest = max(part.largest, abs(x - y) if abs(x - y) < math.inf else math.inf)
        part.scale = max(part.scale, abs(x), abs(y))
    part.differing += 1
    if part.first is None:
        part.first = Difference(part.name, place, a, b, apart)


def reals(a: str, b: str) -> tuple[float, float] | None:
    """Both as numbers, or None."""
    try:
        return float(a), float(b)
    except ValueError:
        return None


def _count(part: Part, what: str, a: int, b: int) -> None:
    if a != b:
        _cell(part, f"number of {what}", str(a), str(b))
        part.words += 1


def _tables(mine: list[read.Table], theirs: list[read.Table]) -> Part:
    part = Part("thermo")
    _count(part, "thermo tables", len(mine), len(theirs))
    for number, (a, b) in enumerate(zip(mine, theirs, strict=False), 1):
        _cell(part, f"run {number}, header", " ".join(a.columns), " ".join(b.columns))
        for row, other in zip(a.rows, b.rows, strict=False):
            for name, x, y in zip(a.columns, row, other, strict=False):
                if name not in read.CLOCKS:
                    _cell(part, f"run {number}, step {row[0]}, column {name}", x, y)
        _count(part, f"thermo lines of run {number}", len(a.rows), len(b.rows))
    return part


def _lines(name: str, mine: list[str], theirs: list[str]) -> Part:
    part = Part(name)
    for k, (a, b) in enumerate(zip(mine, theirs, strict=False), 1):
        _cell(part, f"line {k}", a, b)
    _count(part, "lines", len(mine), len(theirs))
    return part


def _file(name: str, mine: Path, theirs: Path) -> Part:
    part = Part(f"file {name}")
    try:
        pairs = read.dump_frames(mine), read.dump_frames(theirs)
    except UnicodeDecodeError:
        _binary(part, mine, theirs)
        return part
    _count(part, "frames", len(pairs[0]), len(pairs[1]))
    for a, b in zip(*pairs, strict=False):
        where = f"step {a.step}" if a.step else "text"
        for x, y in zip(a.header, b.header, strict=False):
            for word, its in zip_longest(x.split(), y.split(), fillvalue=""):
                _cell(part, f"{where}, header", word, its)
        _count(part, f"rows at {where}", len(a.rows), len(b.rows))
        ours, others = _ordered(part, where, a, b)
        for k, (row, other) in enumerate(zip(ours, others, strict=False), 1):
            if row == other:
                part.cells += len(row)
                continue
            who = f"atom {row[0]}" if a.columns[:1] == ["id"] else f"row {k}"
            if len(row) != len(other):
                _cell(part, f"{where}, {who}", " ".join(row), " ".join(other))
                continue
            for c, (x, y) in enumerate(zip(row, other, strict=True)):
                column = a.columns[c] if c < len(a.columns) else f"word {c + 1}"
                _cell(part, f"{where}, {who}, column {column}", x, y)
    return part


def _ordered(part: Part, where: str, a: read.Frame, b: read.Frame) -> tuple[list[list[str]], list[list[str]]]:
    """Both frames' rows; rows of a local dump, which has no order of its own, in one order if they differ in theirs."""
    local = not set(a.columns) & {"id", "element", "name"} and bool(a.step) and any(line.startswith("ITEM") for line in a.header)
    if not local or a.rows == b.rows or len(a.rows) != len(b.rows):
        return a.rows, b.rows
    pair = _sorted(a.rows), _sorted(b.rows)
    if pair == (a.rows, b.rows) or _unlike(*pair) >= _unlike(a.rows, b.rows):
        return a.rows, b.rows
    part.differing += 1
    if part.first is None:
        part.first = Difference(part.name, f"{where}, order of rows", "another", "another")
    return pair


def _sorted(rows: list[list[str]]) -> list[list[str]]:
    def key(row: list[str]) -> list[tuple[float, str]]:
        found = ((reals(cell, cell), cell) for cell in row)
        return [(float(f"{values[0]:.6g}"), "") if values else (math.inf, cell) for values, cell in found]

    return sorted(rows, key=key)


def _unlike(mine: list[list[str]], theirs: list[list[str]]) -> float:
    """How far apart rows are: relative differences, each at most 1, summed."""
    total = 0.0
    for row, other in zip(mine, theirs, strict=True):
        for a, b in zip(row, other, strict=False):
            if a != b:
                values = reals(a, b)
                total += min(1.0, abs(values[0] - values[1]) / max(abs(values[0]), abs(values[1]), 1e-300)) if values else 1.0
    return total


def _binary(part: Part, mine: Path, theirs: Path) -> None:
    """Bytes; where they differ and both are restart files, what differs in their atoms and bonds."""
    same = mine.read_bytes() == theirs.read_bytes()
    if not same:
        texts = [_restart(path) for path in (mine, theirs)]
        if all(texts):
            for a, b in zip(*texts, strict=False):
                section = a[0] if a else ""
                for c, (x, y) in enumerate(zip(a, b, strict=False), 1):
                    _cell(part, f"as a data file, line of {section}, word {c}", x, y)
                _count(part, "words of a line", len(a), len(b))
            _count(part, "lines as a data file", len(texts[0]), len(texts[1]))
            if part.differing:
                return
    _cell(part, "bytes", "equal" if same else "other bytes", "equal")


def _restart(path: Path) -> list[list[str]]:
    """The words of a restart file as a data file; none if it is no restart file that can be read here."""
    sim = Simulation(Console())
    try:
        restore(sim, read_restart(str(path)))
        return [line.split() for line in data_text(sim, Contents(coeffs=False)).splitlines()[1:]]
    except (ScriptError, ValueError, KeyError, AttributeError):
        return []
