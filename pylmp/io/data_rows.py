"""The rows of a data file's Atoms and Velocities sections, checked in LAMMPS's order."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pylmp.io.data_file import DataFile
from pylmp.io.data_types import TypeMap
from pylmp.model.atom_style import AtomStyle
from pylmp.model.atoms import Floats, Ints

INTEGER = r"([-+]?\d{1,9})"  # what needs no further check
NUMBER = r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,2})?)"
TYPE = r"(\d{1,9}|[^\s\d*#]\S*)"
END = r"(?:\s+#.*|\s*)"
_WORDS = {"tag": ("id", INTEGER), "molecule": ("molecule", INTEGER), "type": ("type", TYPE), "q": ("q", NUMBER)}


@dataclass
class AtomRows:
    """columns: (k,) arrays by their names in model/atoms.py; x (k, 3) float64; image (k, 3) int64; line: where each row stands."""

    columns: dict[str, NDArray[np.generic]]
    x: Floats
    image: Ints
    line: Ints

    @property
    def tag(self) -> Ints:
        return np.asarray(self.columns["tag"], np.int64)


def read_atoms(file: DataFile, lines: range, style: AtomStyle, types: TypeMap, flat: bool) -> AtomRows:
    """Rows of the style's columns, x y z and maybe ix iy iz; blank lines are passed over. flat: z and iz must be 0."""
    return _AtomReader(file, lines, style, types, flat).read()


class _AtomReader:
    def __init__(self, file: DataFile, lines: range, style: AtomStyle, types: TypeMap, flat: bool) -> None:
        self.file, self.lines, self.types, self.flat = file, lines, types, flat
        self.names = [*style.columns, "x", "y", "z", *style.after]
        self.x = len(style.columns)
        self.width = len(self.names)
        self.known = types.sim.atom_types

    def read(self) -> AtomRows:
        file, lines, width = self.file, self.lines, self.width
        wanted = len(file.words(lines[0])) if len(lines) else width
        if wanted not in (width, width + 3):
            columns = " ".join(_WORDS[name][0] if name in _WORDS else name for name in self.names)
            wrong_format(file, "Atoms", lines[0], f"{columns} [ix iy iz], {width} or {width + 3} words")
        forms = [_WORDS[name][1] if name in _WORDS else NUMBER for name in self.names] + [INTEGER] * (wanted - width)
        good = re.compile(r"\s*" + r"\s+".join(forms) + END, re.ASCII)
        table: list[list[float]] = []
        images: list[list[int]] = []
        kept: list[int] = []
        for line in lines:
            found = good.fullmatch(file.lines[line])
            words = list(found.groups()) if found else file.words(line)
            if not words:
                continue
            if len(words) != wanted:
                wrong_format(file, "Atoms", line, f"{wanted} words as in the section's first line")
            table.append(self._row(line, words, found is not None))
            images.append([int(word) for word in words[width:]] or [0, 0, 0])
            kept.append(line)
        numbers = np.array(table, float).reshape(len(kept), width)
        whole = {name for name in self.names if name in _WORDS and name != "q"}
        arrays: dict[str, NDArray[np.generic]] = {
            name: numbers[:, k].astype(np.int64) if name in whole else numbers[:, k]
            for k, name in enumerate(self.names)
            if name in _WORDS
        }
        x = np.ascontiguousarray(numbers[:, self.x : self.x + 3])
        return AtomRows(arrays, x, np.array(images, np.int64).reshape(-1, 3), np.array(kept, np.int64))

    def _row(self, line: int, words: list[str], plain: bool) -> list[float]:
        """The numbers of a row; complains of the first word that is wrong, in the order in which LAMMPS reads them."""
        file, place = self.file, self.names.index("type")
        text = file.lines[line].strip()
        if not plain:
            for word in words[self.width :]:
                file.integer(word, line)
            for word in words[self.x : self.x + 3]:
                file.number(word, line)
        if self.flat:
            self._check_flat(line, words)
        kind = self.types.number("atom", words[place])
        if kind is None:
            hint = f"atom types are 1 to {self.known}"
            file.fail(f"Invalid line in Atoms section of data file: {text}", line, words[place], hint=hint)
        if not plain:
            for name, word in zip(self.names, words, strict=False):
                if name in _WORDS and name != "type":
                    (file.number if name == "q" else file.integer)(word, line)
        if not 1 <= kind <= self.known:
            hint = f"atom types are 1 to {self.known}"
            file.fail(f"Invalid atom type {kind} in Atoms section of data file: {text}", line, words[place], hint=hint)
        if int(words[0]) <= 0:
            first = self.lines[0]
            file.fail(f"Invalid atom ID {int(words[0])} in line {line - first + 1} of Atoms section of data file", line, words[0])
        return [float(kind) if name == "type" else float(word) for name, word in zip(self.names, words, strict=False)]

    def _check_flat(self, line: int, words: list[str]) -> None:
        if len(words) > self.width and int(words[-1]) != 0:
            self.file.fail("Z-direction image flag must be 0 for 2d-systems", line, words[-1], hint="dimension 2")
        z = words[self.x + 2]
        if float(z) != 0.0:
            self.file.fail("Read_data atom z coord is non-zero for 2d simulation", line, z, hint="dimension 2")


def wrong_format(file: DataFile, section: str, line: int, hint: str) -> None:
    text = file.lines[line].strip()
    file.fail(f"Incorrect format in {section} section of data file: {text}", line, hint=hint)


def read_velocities(file: DataFile, lines: range, rows_by_tag: Ints) -> tuple[Ints, Floats]:
    """(rows, (k, 3) velocities) of the lines ``id vx vy vz``."""
    good = re.compile(r"\s*" + r"\s+".join([INTEGER, NUMBER, NUMBER, NUMBER]) + END, re.ASCII)
    rows, values = [], []
    for line in lines:
        found = good.fullmatch(file.lines[line])
        words = list(found.groups()) if found else file.words(line)
        if not words:
            continue
        if len(words) != 4:
            wrong_format(file, "Velocities", line, "id vx vy vz")
        tag = file.integer(words[0], line)
        row = int(rows_by_tag[tag]) if 0 < tag < len(rows_by_tag) else -1
        if row < 0:
            text = file.lines[line].strip()
            file.fail(f"Invalid atom ID {tag} in Velocities section of data file: {text}", line, words[0])
        rows.append(row)
        values.append([float(w) if found else file.number(w, line) for w in words[1:]])
    return np.array(rows, np.int64), np.array(values, float).reshape(-1, 3)
