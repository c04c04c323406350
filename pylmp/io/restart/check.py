"""What must be true of a restart file before anybody uses it: no number is believed that the rest of the file contradicts."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pylmp.io.restart import layout
from pylmp.io.restart.content import Content
from pylmp.io.restart.stream import Unpacker
from pylmp.model.atom_style import ATOM_STYLES
from pylmp.text.diagnostic import Unsupported

_MOST_TYPES = 1_000_000
_MOST_SLOTS = 500_000_000
_FARTHEST = 1.0e6  # box lengths: nobody means an atom farther out
_SIZES = {"smallint": 4, "imageint": 4, "tagint": 4, "bigint": 8}
_LENGTHS = {
    "process grid": 3, "boundary": 6, "least": 6, "lo": 3, "hi": 3, "special lj": 3, "special coul": 3,
}  # fmt: skip
_FLAGS = ("newton pair", "newton bond", "periodic x", "periodic y", "periodic z", "triclinic", "comm velocity", "atom id")
_LARGEST_ID = 20_000_000  # tables by ID are kept


def check_header(source: Unpacker, content: Content) -> None:
    """Raise ScriptError for what cannot be, Unsupported for what pylmp does not have."""
    header = content.header
    missing = [name for name in layout.HEADER if name not in header and name not in layout.OPTIONAL]
    if missing:
        source.fail(why=f"the header says nothing of {', '.join(missing)}")
    for name, size in _SIZES.items():
        if header[name] != size:
            _unsupported(source, f"restart files of programs built with other integer sizes ({name} of {header[name]} bytes)")
    for name, length in _LENGTHS.items():
        if len(header[name]) != length:
            source.fail(why=f"{len(header[name])} numbers for {name}")
    for name in _FLAGS:
        if header[name] not in (0, 1):
            source.fail(why=f"{name} is {header[name]}")
    _check_kinds(source, header)
    _check_box(source, header)
    style, words = header["atom style"]
    if style not in ATOM_STYLES or words:
        _unsupported(source, f"atom_style {' '.join([style, *words])}")
    if not header["atom id"]:
        _unsupported(source, "atom_modify id no")
    if header["comm mode"]:
        _unsupported(source, "comm_modify mode multi")
    for name in ("ellipsoids", "lines", "triangles", "bodies"):
        if header[name]:
            _unsupported(source, name)


def _unsupported(source: Unpacker, what: str) -> None:
    raise Unsupported(
        f"LAMMPS has {what}, pylmp's native engines do not", hint=f"{source.name} holds it", manual="read_restart.html"
    )


def _check_kinds(source: Unpacker, header: dict[str, Any]) -> None:
    """Words and counts."""
    if header["units"] not in layout.UNITS:
        source.fail(why=f"units {header['units'][:20]!r}")
    if header["dimension"] not in (2, 3):
        source.fail(why=f"dimension {header['dimension']}")
    if not 0 <= header["step"] < 2**62 or not 0 <= header["time step"] <= header["step"]:
        source.fail(why=f"step {header['step']}, time booked at step {header['time step']}")
    for name in ("timestep", "time"):
        if not math.isfinite(header[name]):
            source.fail(why=f"{name} {header[name]}")
    for kind in ("atom", *layout.KINDS):
        if not 0 <= header[f"{kind} types"] <= _MOST_TYPES or header[f"{kind}s"] < 0:
            source.fail(why=f"{header[f'{kind} types']} {kind} types, {header[f'{kind}s']} {kind}s")
    for name in (*(f"{kind} per atom" for kind in layout.KINDS), "special per atom", "sort every"):
        if header[name] < 0 or (name != "sort every" and header[name] * header["atoms"] > _MOST_SLOTS):
            source.fail(why=f"{name} {header[name]}")
    if header["record growth"] != sum(header[f"{kind} per atom"] * (1 + ids) for kind, ids in layout.KINDS.items()):
        source.fail(why="bonds, angles, dihedrals and impropers per atom that do not fit together")
    for name in ("comm cutoff", "sort bin"):
        if not (math.isfinite(header[name]) and header[name] >= 0.0):
            source.fail(why=f"{name} {header[name]}")


def _check_box(source: Unpacker, header: dict[str, Any]) -> None:
    numbers = [*header["lo"], *header["hi"], *header["least"], header["xy"], header["xz"], header["yz"]]
    if not all(math.isfinite(number) for number in numbers):
        source.fail(why="a box without end")
    if any(lo >= hi for lo, hi in zip(header["lo"], header["hi"], strict=True)):
        source.fail(why="a box whose low face is not below its high face")
    if not all(0 <= face < len(layout.FACES) for face in header["boundary"]):
        source.fail("Illegal or unset periodicity in restart", f"boundary codes {header['boundary']}")
    for axis, d in zip("xyz", range(3), strict=True):
        low, high = header["boundary"][2 * d : 2 * d + 2]
        if (low == 0) != (high == 0) or (low == 0) != bool(header[f"periodic {axis}"]):
            source.fail("Illegal or unset periodicity in restart", f"boundary codes {header['boundary']}")


def check_atoms(source: Unpacker, content: Content) -> None:
    """The atoms against the header and against each other."""
    header, atoms = content.header, content.atoms

    def wrong(why: str) -> None:
        source.fail("Did not assign all restart atoms correctly", why)

    if content.n != header["atoms"]:
        wrong(f"{content.n} atoms in the file, the header says {header['atoms']}")
    if not content.n:
        return
    if ((atoms["type"] < 1) | (atoms["type"] > header["atom types"])).any():
        wrong(f"an atom type outside 1 to {header['atom types']}")
    lengths = np.subtract(header["hi"], header["lo"])
    if not (np.abs(atoms["x"] - header["lo"]) <= _FARTHEST * lengths).all():
        wrong("an atom without a place near the box")
    if (atoms["id"] < 1).any() or len(np.unique(atoms["id"])) != content.n:
        wrong("atom IDs that are not positive or occur twice")
    largest = int(atoms["id"].max())
    if largest > _LARGEST_ID:
        _unsupported(source, f"atom IDs above {_LARGEST_ID}")
    if ((atoms["mask"] < -(2**31)) | (atoms["mask"] >= 2**31) | (atoms["mask"] & 1 == 0)).any():
        wrong("an atom outside group all")
    for kind in layout.KINDS:
        if f"num_{kind}" not in atoms:
            continue
        used = np.arange(atoms[f"{kind}_type"].shape[1]) < atoms[f"num_{kind}"][:, None]
        types, ends = atoms[f"{kind}_type"][used], atoms[f"{kind}_atom"][used]
        if ((types < 0) | (types > header[f"{kind} types"])).any():
            wrong(f"a {kind} type outside 0 to {header[f'{kind} types']}")
        if (ends < 1).any():
            wrong(f"a {kind} to an atom whose ID is not positive")
