"""Comparing two runs: cell by cell, as numbers where both are numbers, else as text. Nothing is rounded."""

from __future__ import annotations

import struct
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from pylmp.tools.diff import read

IGNORED = {"log.lammps", "in.diff", "screen.txt", "tmp.lammps.variable"}  # the last: partitions' notes on universe variables


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
    """One thing compared: how many cells, how many differ, the first that does."""

    name: str
    cells: int = 0
    differing: int = 0
    largest_ulps: int = 0
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
    result.parts.append(_lines("answers of commands", *(read.answers(log) for log in logs)))
    names = [
        {str(p.relative_to(f)) for p in f.rglob("*") if p.is_file()} - IGNORED - inputs for f in (native, reference)
    ]
    for name in sorted(names[0] | names[1]):
        if name in names[0] and name in names[1]:
            result.parts.append(_file(name, native / name, reference / name))
        else:
            part = Part(f"file {name}", 1, 1)
            there = ("written", "not written") if name in names[0] else ("not written", "written")
            part.first = Difference(part.name, "the file itself", *there)
            result.parts.append(part)
    return result


def _cell(part: Part, place: str, a: str, b: str) -> None:
    """Count one cell; remember the first that differs. Equal numbers in other words are equal."""
    part.cells += 1
    if a == b:
        return
    try:
        x, y = float(a), float(b)
    except ValueError:
        apart = None
    else:
        if x == y or (x != x and y != y):
            return
        apart = ulps(x, y)
        part.largest_ulps = max(part.largest_ulps, apart)
    part.differing += 1
    if part.first is None:
        part.first = Difference(part.name, place, a, b, apart)


def _count(part: Part, what: str, a: int, b: int) -> None:
    if a != b:
        _cell(part, f"number of {what}", str(a), str(b))


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
        _cell(part, "bytes", str(mine.read_bytes() == theirs.read_bytes()), "True")
        return part
    _count(part, "frames", len(pairs[0]), len(pairs[1]))
    for a, b in zip(*pairs, strict=False):
        where = f"step {a.step}" if a.step else "text"
        for x, y in zip(a.header, b.header, strict=False):
            _cell(part, f"{where}, header", x, y)
        _count(part, f"rows at {where}", len(a.rows), len(b.rows))
        for k, (row, other) in enumerate(zip(a.rows, b.rows, strict=False), 1):
            who = f"atom {row[0]}" if a.columns[:1] == ["id"] else f"row {k}"
            if len(row) != len(other):
                _cell(part, f"{where}, {who}", " ".join(row), " ".join(other))
                continue
            for c, (x, y) in enumerate(zip(row, other, strict=True)):
                column = a.columns[c] if c < len(a.columns) else f"word {c + 1}"
                _cell(part, f"{where}, {who}, column {column}", x, y)
    return part
