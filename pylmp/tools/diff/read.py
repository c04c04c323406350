"""Reading what a run left: thermo tables and commands' answers in a log, frames in a dump, words in any other file."""

from __future__ import annotations

import gzip
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pylmp.tools.diff.instrument import MARK

CLOCKS = {"CPU", "T/CPU", "S/CPU", "CPULeft", "TimeoutLeft", "Part"}  # they measure the machine
_ANSWERS = re.compile(
    r"^\s*(\d+ total (bonds|angles)|Added \d+ bonds|Deleted \d+|\d+ = max # of|special bond factors|Created \d+ atoms"
    r"|\d+ atoms in group|\d+ settings made|WARNING: (?!.*deprecated|\[D))"
)
_LISTS = re.compile(r"^\s*(Total # of neighbors|Ave (special )?neighs/atom|Neighbor list builds|Dangerous builds|Nlocal:|Nghost:|Neighs:)")
_GZIP = b"\x1f\x8b"
_CELL = re.compile(r"(\S+)\s+=\s+(\S+)")


@dataclass
class Table:
    """One thermo table: column names and rows of numbers, cells kept as printed."""

    columns: list[str]
    rows: list[list[str]]
    run: int = 0


def tables(log: str) -> list[Table]:
    """Every thermo table of a log, styles one and custom, multi, and yaml. run: the number of the run command, if the log was marked."""
    found: list[Table] = []
    reading = False
    run = tabled = 0
    for line in log.splitlines():
        words = line.split()
        if len(found) > tabled:
            found[-1].run, run, tabled = run, 0, len(found)
        if line.startswith(MARK) and words[-1].isdigit():
            run = int(words[-1])
        if words[:1] == ["Step"] and "=" not in words:
            found.append(Table(words, []))
            reading = True
        elif line.startswith("keywords: ["):
            found.append(Table([w.strip(" '") for w in line[11:].rstrip("], ").split(",")], []))
            reading = True
        elif line.startswith("------------ Step"):
            if not (reading and found and found[-1].columns[:1] == ["Step*"]):
                found.append(Table(["Step*"], []))
            found[-1].rows.append([words[2]])
            reading = True
        elif line.startswith("Loop time"):
            reading = False
        elif reading and line.startswith("  - ["):
            found[-1].rows.append([w.strip() for w in line[5:].rstrip("], ").split(",")])
        elif reading and found[-1].columns[0] == "Step*":
            cells = _CELL.findall(line)
            if len(found[-1].rows) == 1:
                found[-1].columns += [name for name, _ in cells]
            found[-1].rows[-1] += [value for _, value in cells]
        elif reading and len(words) == len(found[-1].columns) and _is_number(words[0]):
            found[-1].rows.append(words)
    if len(found) > tabled:
        found[-1].run = run
    return found


def lists(log: str) -> list[str]:
    """The lines on neighbor lists and ghost atoms at the end of each run: how a program works, not what it computes."""
    return [line.strip() for line in log.splitlines() if _LISTS.match(line)]


def answers(log: str) -> list[str]:
    """The lines in which commands tell what they did, without LAMMPS's notes of its own source lines.

    A warning counts once: where the box changes, LAMMPS repeats some at every rebuild.
    """
    lines = (re.sub(r" \(src/.*\)$", "", line).strip() for line in log.splitlines() if _ANSWERS.match(line))
    warned: set[str] = set()
    result = []
    for line in lines:
        if line.startswith("WARNING"):
            if line in warned:
                continue
            warned.add(line)
        result.append(line)
    return result


@dataclass
class Frame:
    """One dump frame: its header lines, and its rows as printed."""

    step: str
    header: list[str]
    columns: list[str]
    rows: list[list[str]]


def dump_frames(path: Path) -> list[Frame]:
    """Frames of a dump: LAMMPS's own text format, XYZ, YAML, each also compressed; any other text is one frame."""
    data = path.read_bytes()
    text = (gzip.decompress(data) if data[:2] == _GZIP else data).decode()
    if "ITEM: TIMESTEP" in text:
        return _native(text)
    if text.startswith("---\ncreator: LAMMPS"):
        return [_document(piece) for piece in text.split("---\n")[1:]]
    if re.match(r"\d+\n Atoms\. Timestep: ", text):
        return _xyz(text.splitlines())
    rows = [line.split() for line in text.splitlines() if not line.startswith("Printed on ")]  # info's date
    return [Frame("", [], [], rows)]


@dataclass
class Numbers:
    """One frame whose cells are all numbers. box: (3, 2 or 3) as in the header. values: a row an atom or entry."""

    step: int
    box: NDArray[np.float64]
    columns: list[str]
    values: NDArray[np.float64]

    def __getitem__(self, names: str) -> NDArray[np.float64]:
        """The columns of these names, (rows, names)."""
        return self.values[:, [self.columns.index(name) for name in names.split()]]


def numbers(path: Path) -> list[Numbers]:
    """Frames of a dump in LAMMPS's text format; none if there is no such file."""
    if not path.is_file():
        return []
    result = []
    for piece in path.read_text().split("ITEM: TIMESTEP\n")[1:]:
        header, _, rest = piece.partition("ITEM: BOX BOUNDS")
        bounds = rest.split("\n", 4)
        columns = bounds[4].partition("\n")[0].split()[2:]
        values = np.array(bounds[4].partition("\n")[2].split(), dtype=float).reshape(-1, max(1, len(columns)))
        box = np.array([line.split() for line in bounds[1:4]], dtype=float)
        result.append(Numbers(int(header.split()[0]), box, columns, values))
    return result


def _native(text: str) -> list[Frame]:
    result = []
    for piece in text.split("ITEM: TIMESTEP\n")[1:]:
        lines = piece.splitlines()
        start = max(k for k, line in enumerate(lines) if line.startswith("ITEM: "))
        rows = [line.split() for line in lines[start + 1 :]]
        result.append(Frame(lines[0], lines[1 : start + 1], lines[start].split()[2:], rows))
    return result


def _document(text: str) -> Frame:
    """One document of a YAML dump. Numbers of the header are compared as rows, words as text."""
    head, _, body = text.partition("data:\n")
    lines = head.splitlines()
    step = next((line.split()[1] for line in lines if line.startswith("timestep: ")), "")
    columns = _cells(lines[-1].partition(":")[2])
    above = [_cells(line.partition("[")[2]) for line in lines if line.startswith(("  - [ ", "  - data"))]
    rows = [_cells(line) for line in body.splitlines() if line.startswith("  - [")]
    texts = [line for line in lines if not line.startswith("  - [ ") and not line.startswith("  - data")]
    return Frame(step, texts, columns, above + rows)


def _cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip(" -[]").split(",") if cell.strip()]


def _xyz(lines: list[str]) -> list[Frame]:
    result = []
    at = 0
    while at + 1 < len(lines):
        count = int(lines[at])
        rows = [line.split() for line in lines[at + 2 : at + 2 + count]]
        result.append(Frame(lines[at + 1].split()[2], [lines[at + 1]], ["name", "x", "y", "z"], rows))
        at += 2 + count
    return result


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True
