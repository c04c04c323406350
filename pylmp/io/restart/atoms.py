"""The atoms of a restart file: one record an atom, all in doubles; integers are stored bit by bit in the place of a double.

    length, x y z, ID, type, group bits, image flags, vx vy vz, what the style carries, what fixes keep

An entry of a bond is its type and the partner's ID, of an angle its type and three IDs; a record holds the count, all types, all
first IDs, all second IDs... What a fix keeps stands behind its own length, which counts itself. Measured on LAMMPS's files.
"""

from __future__ import annotations

from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from pylmp.io.restart.content import Content, Floats, Ints, Kept
from pylmp.io.restart.layout import KINDS
from pylmp.io.restart.stream import Unpacker
from pylmp.model.atom_style import ATOM_STYLES

_COMMON = 11  # numbers that every record begins with
_SHIFTS = (0, 10, 20)  # of the three image flags in one integer, ten bits each


def pack_image(image: Ints) -> Ints:
    """(n, 3) image flags as one integer each."""
    bits = (image + 512) & 1023
    return np.asarray(bits[:, 0] | bits[:, 1] << 10 | bits[:, 2] << 20)


def unpack_image(packed: Ints) -> Ints:
    return np.stack([(packed >> shift & 1023) - 512 for shift in _SHIFTS], axis=-1)


def fields(content: Content) -> tuple[str, ...]:
    """What a record holds beside what every atom has, in its order."""
    style = ATOM_STYLES[content.header["atom style"][0]]
    plain = [name for name in ("q", "molecule") if name in style.columns + style.after]
    return (*plain, *(kind.name for kind in style.kinds))


class _Writer:
    """Columns into records that begin at starts."""

    def __init__(self, lengths: Ints) -> None:
        self.cursor = np.cumsum(lengths) - lengths
        self.out = np.zeros(int(lengths.sum()))
        self.bits = self.out.view(np.int64)

    def numbers(self, *columns: NDArray[Any]) -> None:
        for column in columns:
            self.out[self.cursor] = column
            self.cursor = self.cursor + 1

    def integers(self, *columns: NDArray[Any]) -> None:
        for column in columns:
            self.bits[self.cursor] = column
            self.cursor = self.cursor + 1

    def slots(self, counts: Ints, values: NDArray[Any], bits: bool = True) -> None:
        """The first counts[k] values of each row."""
        target = self.bits if bits else self.out
        for k in range(int(counts.max(initial=0))):
            rows = counts > k
            target[self.cursor[rows] + k] = values[rows, k]
        self.cursor = self.cursor + counts


def pack_atoms(content: Content) -> Floats:
    """All records, one after the other."""
    atoms = content.atoms
    lengths = np.full(content.n, _COMMON, np.int64)
    for name in fields(content):
        lengths += 1
        if name in KINDS:
            lengths += atoms[f"num_{name}"] * (1 + KINDS[name])
    for kept in content.kept:
        lengths += 1 + kept.counts
    to = _Writer(lengths)
    to.numbers(lengths, *atoms["x"].T)
    to.integers(atoms["id"], atoms["type"], atoms["mask"], pack_image(atoms["image"]))
    to.numbers(*atoms["v"].T)
    for name in fields(content):
        if name in KINDS:
            counts = atoms[f"num_{name}"]
            to.integers(counts)
            to.slots(counts, atoms[f"{name}_type"])
            for k in range(KINDS[name]):
                to.slots(counts, atoms[f"{name}_atom"][:, :, k])
        elif name == "molecule":
            to.integers(atoms[name])
        else:
            to.numbers(atoms[name])
    for kept in content.kept:
        to.numbers(1 + kept.counts)
        to.slots(kept.counts, kept.values, bits=False)
    return to.out


class _Reader:
    """Columns out of records. Every read is checked against the end of its record."""

    def __init__(self, source: Unpacker, buffer: Floats) -> None:
        self.source = source
        self.buffer = buffer
        self.bits = buffer.view(np.int64)
        starts, at, size = [], 0, len(buffer)
        while at < size:
            length = float(buffer[at])
            if not _COMMON <= length <= size - at or length != int(length):
                self.fail(f"an atom's record of {length:g} numbers")
            starts.append(at)
            at += int(length)
        self.starts = np.array(starts, np.int64)
        self.ends = np.array([*starts[1:], size] if starts else [], np.int64)
        self.cursor = self.starts + 1

    def fail(self, why: str) -> NoReturn:
        self.source.fail("Did not assign all restart atoms correctly", why)

    def _advance(self, counts: Ints | int) -> Ints:
        at, self.cursor = self.cursor, self.cursor + counts
        if (self.cursor > self.ends).any():
            self.fail("an atom's record ends too early")
        return at

    def numbers(self, count: int) -> Floats:
        """(n, count)"""
        return np.stack([self.buffer[self._advance(1)] for _ in range(count)], axis=-1)

    def integers(self) -> Ints:
        return self.bits[self._advance(1)]

    def slots(self, counts: Ints, bits: bool = True) -> NDArray[Any]:
        """(n, most): the next counts[k] values of each row, zeros after them."""
        source = self.bits if bits else self.buffer
        at = self._advance(counts)
        most = int(counts.max(initial=0))
        values = np.zeros((len(at), most), source.dtype)
        for k in range(most):
            rows = counts > k
            values[rows, k] = source[at[rows] + k]
        return values


def unpack_atoms(source: Unpacker, content: Content, buffer: Floats) -> None:
    """Fill content.atoms and content.kept from buffer. Raises ScriptError if the records do not fit together."""
    source.part = "the atoms"
    read = _Reader(source, buffer)
    atoms: dict[str, Any] = {"x": read.numbers(3)}
    for name in ("id", "type", "mask"):
        atoms[name] = read.integers()
    atoms["image"] = unpack_image(read.integers())
    atoms["v"] = read.numbers(3)
    for name in fields(content):
        if name in KINDS:
            counts = atoms[f"num_{name}"] = read.integers()
            most = content.header[f"{name} per atom"]
            if ((counts < 0) | (counts > most)).any():
                read.fail(f"an atom with more than {most} {name}s")
            atoms[f"{name}_type"] = read.slots(counts)
            columns = [read.slots(counts) for _ in range(KINDS[name])]
            atoms[f"{name}_atom"] = np.stack(columns, axis=-1)
        elif name == "molecule":
            atoms[name] = read.integers()
        else:
            atoms[name] = read.numbers(1)[:, 0]
    for kept in content.kept:
        _unpack_kept(read, kept)
    if (read.cursor != read.ends).any():
        read.fail("an atom's record is longer than what it holds")
    content.atoms = atoms


def _unpack_kept(read: _Reader, kept: Kept) -> None:
    length = read.numbers(1)[:, 0]
    if not ((length >= 1) & (length <= kept.width + 1) & (length == np.floor(length))).all():
        read.fail(f"what fix {kept.identity} keeps of an atom has a wrong length")
    kept.counts = length.astype(np.int64) - 1
    kept.values = read.slots(kept.counts, bits=False)
