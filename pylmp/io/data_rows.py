"""The rows of a data file's Atoms, Velocities and Bonds sections, checked in LAMMPS's order."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from pylmp.io.data_file import DataFile
from pylmp.model.atoms import Floats, Ints

_I, _F = r"([-+]?\d{1,9})", r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,2})?)"  # what needs no further check
_TYPE = r"(\d{1,9})"
_END = r"(?:\s+#.*|\s*)"


@dataclass
class AtomRows:
    """tag type molecule line (k,) int64; x (k, 3) float64; image (k, 3) int64. line: where each row stands in the file."""

    tag: Ints
    type: Ints
    molecule: Ints
    x: Floats
    image: Ints
    line: Ints


def read_atoms(file: DataFile, lines: range, types: int, molecular: bool, flat: bool) -> AtomRows:
    """Rows ``id [molecule] type x y z [ix iy iz]``; blank lines are passed over. flat: z and iz must be 0."""
    width = 6 if molecular else 5
    wanted = len(file.words(lines[0])) if len(lines) else width
    if wanted not in (width, width + 3):
        columns = "id molecule type x y z" if molecular else "id type x y z"
        _wrong_format(file, "Atoms", lines[0], f"{columns} [ix iy iz], {width} or {width + 3} words")
    images = wanted > width
    good = re.compile(
        r"\s*" + r"\s+".join([_I] * (width - 4) + [_TYPE] + [_F] * 3 + [_I] * 3 * images) + _END, re.ASCII
    )
    integers: list[list[int]] = []
    floats: list[list[float]] = []
    kept: list[int] = []
    for line in lines:
        found = good.fullmatch(file.lines[line])
        words = list(found.groups()) if found else file.words(line)
        if not words:
            continue
        if len(words) != wanted:
            _wrong_format(file, "Atoms", line, f"{wanted} words as in the section's first line")
        if found is None:
            _explain(file, line, words, width, types)
        row = [int(word) for word in words[: width - 3]]
        x = [float(word) for word in words[width - 3 : width]]
        image = [int(word) for word in words[width:]] or [0, 0, 0]
        if flat:
            _check_flat(file, line, words, x, image, width)
        if not 1 <= row[-1] <= types:
            file.fail(
                f"Invalid atom type {row[-1]} in Atoms section of data file: {file.lines[line].strip()}", line,
                words[width - 4], hint=f"atom types are 1 to {types}",
            )  # fmt: skip
        if row[0] <= 0:
            file.fail(
                f"Invalid atom ID {row[0]} in line {line - lines[0] + 1} of Atoms section of data file", line, words[0]
            )
        integers.append(row + image)
        floats.append(x)
        kept.append(line)
    table = np.array(integers, np.int64).reshape(len(kept), width)
    molecule = table[:, 1] if molecular else np.zeros(len(kept), np.int64)
    x_table = np.array(floats, float).reshape(len(kept), 3)
    return AtomRows(
        table[:, 0], table[:, width - 4], molecule, x_table, table[:, width - 3 :], np.array(kept, np.int64)
    )


def _wrong_format(file: DataFile, section: str, line: int, hint: str) -> None:
    text = file.lines[line].strip()
    file.fail(f"Incorrect format in {section} section of data file: {text}", line, hint=hint)


def _explain(file: DataFile, line: int, words: list[str], width: int, types: int) -> None:
    """Complain of the first unreadable word, in the order in which LAMMPS reads them; numbers of unusual form pass."""
    for word in words[width:]:
        file.integer(word, line)
    for word in words[width - 3 : width]:
        file.number(word, line)
    if not re.fullmatch(r"\d+", words[width - 4], re.ASCII):
        file.fail(
            f"Invalid line in Atoms section of data file: {file.lines[line].strip()}", line, words[width - 4],
            hint=f"atom types are 1 to {types}",
        )  # fmt: skip
    for word in words[: width - 3]:
        file.integer(word, line)


def _check_flat(file: DataFile, line: int, words: list[str], x: list[float], image: list[int], width: int) -> None:
    if image[2] != 0:
        file.fail("Z-direction image flag must be 0 for 2d-systems", line, words[-1], hint="dimension 2")
    if x[2] != 0.0:
        file.fail("Read_data atom z coord is non-zero for 2d simulation", line, words[width - 1], hint="dimension 2")


def read_velocities(file: DataFile, lines: range, rows_by_tag: Ints) -> tuple[Ints, Floats]:
    """(rows, (k, 3) velocities) of the lines ``id vx vy vz``."""
    good = re.compile(r"\s*" + r"\s+".join([_I, _F, _F, _F]) + _END, re.ASCII)
    rows, values = [], []
    for line in lines:
        found = good.fullmatch(file.lines[line])
        words = list(found.groups()) if found else file.words(line)
        if not words:
            continue
        if len(words) != 4:
            _wrong_format(file, "Velocities", line, "id vx vy vz")
        tag = file.integer(words[0], line)
        row = int(rows_by_tag[tag]) if 0 < tag < len(rows_by_tag) else -1
        if row < 0:
            text = file.lines[line].strip()
            file.fail(f"Invalid atom ID {tag} in Velocities section of data file: {text}", line, words[0])
        rows.append(row)
        values.append([float(w) if found else file.number(w, line) for w in words[1:]])
    return np.array(rows, np.int64), np.array(values, float).reshape(-1, 3)


def read_bonds(file: DataFile, lines: range, types: int, rows_by_tag: Ints, offset: int) -> tuple[Ints, Ints]:
    """((k,) types, (k, 2) atom IDs plus offset) of the lines ``number type atom1 atom2``; the number is not read."""
    good = re.compile(r"\s*[^\s#]\S*\s+" + r"\s+".join([_TYPE, _I, _I]) + _END, re.ASCII)
    kinds, pairs = [], []
    for line in lines:
        found = good.fullmatch(file.lines[line])
        words = ["", *found.groups()] if found else file.words(line)
        if not words:
            continue
        text = file.lines[line].strip()
        if len(words) != 4:
            _wrong_format(file, "Bonds", line, "number type atom1 atom2")
        one, two = (file.integer(word, line) + offset for word in words[2:])
        if not found and not re.fullmatch(r"\d+", words[1], re.ASCII):
            file.fail(
                f"Invalid Bonds section of data file: {text}", line, words[1], hint=f"bond types are 1 to {types}"
            )
        kind = file.integer(words[1], line)
        if not 1 <= kind <= types:
            file.fail(
                f"Invalid bond type {kind} in Bonds section of data file: {text}", line, hint=f"types are 1 to {types}"
            )
        known = all(0 < tag < len(rows_by_tag) and rows_by_tag[tag] >= 0 for tag in (one, two))
        if not known or one == two:
            file.fail(
                f"Invalid atom ID in Bonds section of data file: {text}", line, hint="two different atoms of the file"
            )
        kinds.append(kind)
        pairs.append((one, two))
    return np.array(kinds, np.int64), np.array(pairs, np.int64).reshape(-1, 2)
