"""Bytes to a restart file's content. Everything is read and checked before anybody uses it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from pylmp.io.restart import layout
from pylmp.io.restart.atoms import unpack_atoms
from pylmp.io.restart.blobs import unpack_force
from pylmp.io.restart.check import check_atoms, check_header
from pylmp.io.restart.content import Content, Kept
from pylmp.io.restart.stream import Unpacker
from pylmp.model.groups import MAX_GROUPS

_WIDEST = 1_000_000  # numbers that a fix keeps of one atom


def decode(data: bytes, name: str, piece: Callable[[int], tuple[bytes, str]] | None = None) -> Content:
    """The content of a file called name. piece: the bytes and name of file number k of a set, where name is the base of one.

    Raises ScriptError with LAMMPS's sentence and the place in the file, Unsupported for what pylmp does not have.
    """
    source = _open(Unpacker(data, name))
    content = Content()
    _header(source, content)
    check_header(source, content)
    _groups(source, content)
    _types(source, content)
    _forces(source, content)
    _fixes(source, content)
    content.files = _layout(source, piece is not None)
    sources = [source] if not content.files else [_piece(piece, k, source) for k in range(content.files)]
    buffers = [block for each in sources for block in _blocks(each, content)]
    unpack_atoms(sources[-1], content, np.concatenate(buffers) if buffers else np.zeros(0))
    check_atoms(sources[-1], content)
    return content


def _open(source: Unpacker) -> Unpacker:
    """Past the magic words; the file's end is known to be there."""
    source.part = "the first bytes"
    if source.data[:16] != layout.MAGIC:
        source.fail("Invalid LAMMPS restart file", "it does not begin as one")
    source.at = 16
    order, revision = source.integer(), source.integer()
    if order == layout.SWAPPED:
        source.fail("Restart file byte ordering is swapped")
    if order != layout.ORDER:
        why = "it comes from a machine with the other byte order" if order == 0x01000000 else ""
        source.fail("Restart file byte ordering is not recognized", why)
    if revision != layout.REVISION:
        source.fail(
            "Restart file format revision incompatible with current LAMMPS version",
            f"revision {revision}, not {layout.REVISION}",
        )
    return _closed(source)


def _closed(source: Unpacker) -> Unpacker:
    if source.data[-16:] != layout.MAGIC:
        source.at, source.part = len(source.data), "the last bytes"
        source.fail("Incomplete or corrupted LAMMPS restart file", "it does not end as one; the writing was cut short")
    source.data = source.data[:-16]
    return source


def _header(source: Unpacker, content: Content) -> None:
    source.part = "the header"
    while (flag := source.integer()) != layout.END:
        if flag not in layout.BY_FLAG:
            source.fail("Invalid flag in header section of restart file", f"flag {flag}")
        name, kind = layout.BY_FLAG[flag]
        if name in content.header:
            source.fail("Invalid flag in header section of restart file", f"{name} for the second time")
        content.header[name] = _style(source) if kind == "style" else getattr(source, kind)()


def _style(source: Unpacker) -> tuple[str, list[str]]:
    name, count = source.text(), source.integer()
    if not 0 <= count < 1000:
        source.fail(why=f"atom style {name} with {count} words")
    return name, [source.text() for _ in range(count)]


def _groups(source: Unpacker, content: Content) -> None:
    source.part = "the groups"
    count = source.integer()
    if not 0 < count <= MAX_GROUPS:
        source.fail(why=f"{count} groups")
    for slot in range(MAX_GROUPS):
        if len(content.groups) == count:
            break
        size = source.integer()
        if size:
            source.at -= 4
            content.groups[source.text()] = slot
    if len(content.groups) != count or content.groups.get("all") != 0:
        source.fail(why="group names that are no such list")


def _types(source: Unpacker, content: Content) -> None:
    source.part = "the masses"
    header = content.header
    while (flag := source.integer()) != layout.END:
        if flag == layout.MASS:
            content.mass = source.numbers()
            if len(content.mass) != header["atom types"]:
                source.fail(why=f"{len(content.mass)} masses for {header['atom types']} atom types")
        elif flag == layout.LABELS:
            source.integer()
            kinds = ("atom", *layout.KINDS)
            content.labels = [source.text() for kind in kinds for _ in range(header[f"{kind} types"])]
        else:
            source.fail("Invalid flag in type arrays section of restart file", f"flag {flag}")


def _forces(source: Unpacker, content: Content) -> None:
    kinds = {flag: kind for kind, flag in layout.FORCES.items()}
    source.part = "the force fields"
    while (flag := source.integer()) != layout.END:
        kind = kinds.get(flag)
        if kind is None or kind in content.forces:
            source.fail("Invalid flag in force field section of restart file", f"flag {flag}")
        types = content.header[f"{'atom' if kind == 'pair' else kind} types"]
        content.forces[kind] = unpack_force(source, kind, types)
        source.part = "the force fields"


def _fixes(source: Unpacker, content: Content) -> None:
    source.part = "what fixes keep"
    for _ in range(_count(source)):
        identity, style = source.text(), source.text()
        content.fixes.append((identity, style, source.raw(source.integer())))
    for _ in range(_count(source)):
        identity, style, width = source.text(), source.text(), source.integer()
        if not 0 < width <= _WIDEST:
            source.fail(why=f"fix {identity} keeps {width} numbers an atom")
        content.kept.append(Kept(identity, style, width - 1))


def _count(source: Unpacker) -> int:
    count = source.integer()
    if not 0 <= count <= 10000:
        source.fail(why=f"{count} fixes")
    return count


def _layout(source: Unpacker, in_pieces: bool) -> int:
    """How many files hold the atoms; 0: this one does."""
    source.part = "the file layout"
    files = 0
    while (flag := source.integer()) != layout.END:
        if flag != layout.FILES:
            source.fail("Invalid flag in layout section of restart file", f"flag {flag}")
        files = source.integer()
    # LAMMPS has these two sentences the wrong way round.
    if files and not in_pieces:
        source.fail("Restart file is not a multi-proc file", "it is one of a set: its name has a % where this one has base")
    if in_pieces and not files:
        source.fail("Restart file is a multi-proc file", "it stands alone: its name has no %")
    if not 0 <= files <= 1_000_000:
        source.fail(why=f"{files} files")
    return files


def _piece(piece: Any, number: int, base: Unpacker) -> Unpacker:
    data, name = piece(number)
    source = _closed(Unpacker(data, name))
    source.part = "the file layout"
    if source.integer() != layout.PIECES:
        source.fail("Invalid flag in layout section of restart file")
    if source.integer() < 1:
        source.fail("Invalid flag in layout section of restart file")
    return source


def _blocks(source: Unpacker, content: Content) -> list[Any]:
    """The atoms of each process that wrote the file."""
    source.part = "the atoms"
    blocks = []
    while source.at < len(source.data):
        if (flag := source.integer()) != layout.PROCESS:
            source.fail("Invalid flag in peratom section of restart file", f"flag {flag}")
        count = source.integer()
        if count < 0:
            source.fail(why=f"{count} numbers")
        blocks.append(source.array(count))
    return blocks
