"""The force field section: what each style's own description (model/blob.py) says stands there.

    bond angle ...   settings, then one array over types for each coefficient
    pair             settings, then for i <= j: a flag whether the pair was given coefficients, and those if it was
    hybrid           the number of styles, then the name and the settings of each; never coefficients
"""

from __future__ import annotations

import itertools
from typing import Any

from pylmp.io.restart.content import Force
from pylmp.io.restart.stream import Packer, Unpacker
from pylmp.model.blob import FLAG, MIXING, NUMBER, UNLESS, Blob
from pylmp.model.registry import ANGLES, BONDS, DIHEDRALS, IMPROPERS, PAIRS, Registry
from pylmp.model.unknown import unknown_style
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

HYBRID = {"bond": ("hybrid",), "pair": ("hybrid", "hybrid/overlay")}
_CODES = {FLAG: (0, 1), UNLESS: (0, 1), MIXING: (0, 1, 2)}
REGISTRIES: dict[str, Registry[Any]] = {
    "pair": PAIRS, "bond": BONDS, "angle": ANGLES, "dihedral": DIHEDRALS, "improper": IMPROPERS,
}  # fmt: skip


def blob_of(kind: str, name: str) -> Blob:
    """What a style says of itself. Raises ScriptError for one that LAMMPS does not have either, Unsupported else."""
    registry = REGISTRIES[kind]
    style = registry.find(name)
    if style is None or style.restart is None:
        what = Args(f"{kind}_style", [Word(name)], manual="read_restart.html")
        unknown_style(what, Word(name), kind, registry)
    blob: Blob = style.restart
    return blob


def pairs_of(types: int) -> list[tuple[int, int]]:
    return list(itertools.combinations_with_replacement(range(1, types + 1), 2))


def pack_force(to: Packer, kind: str, force: Force, types: int) -> None:
    to.text(force.style)
    if force.style in HYBRID.get(kind, ()):
        to.integer(len(force.parts))
        if kind == "pair":
            for _ in force.parts:
                to.integer(1)  # it is computed
        for part in force.parts:
            to.text(part.style)
            _pack_settings(to, part, blob_of(kind, part.style).in_hybrid)
            if kind == "pair":
                to.integer(0)  # no special weights of its own
                to.integer(0)
        return
    blob = blob_of(kind, force.style)
    _pack_settings(to, force, blob)
    if kind == "pair" and blob.kept:
        for pair in pairs_of(types):
            to.integer(int(pair in force.pairs))
            for value in force.pairs.get(pair, ()):
                to.number(value)
    for column in force.columns:
        for value in column:
            to.number(value)


def _pack_settings(to: Packer, force: Force, blob: Blob) -> None:
    for name, how in blob.settings:
        if how == NUMBER:
            to.number(force.settings[name])
        else:
            to.integer(int(force.settings[name]))


def unpack_force(source: Unpacker, kind: str, types: int) -> Force:
    force = Force(source.text())
    source.part = f"{kind} style {force.style}"
    if force.style in HYBRID.get(kind, ()):
        _unpack_hybrid(source, kind, force)
        return force
    blob = blob_of(kind, force.style)
    _unpack_settings(source, force, blob)
    if not blob.kept:
        return force
    if kind == "pair":
        for pair in pairs_of(types):
            if _flag(source):
                force.pairs[pair] = [source.number() for _ in blob.coeffs]
    else:
        force.columns = [source.array(types).tolist() for _ in blob.coeffs]
    return force


def _unpack_hybrid(source: Unpacker, kind: str, force: Force) -> None:
    count = source.integer()
    if not 0 < count <= 1000:
        source.fail(why=f"{count} styles")
    computed = [_flag(source) for _ in range(count)] if kind == "pair" else []
    if not all(computed):
        raise Unsupported("LAMMPS has pair_modify compute no, pylmp's native engines do not", hint=f"{source.name} holds it")
    for _ in range(count):
        part = Force(source.text())
        source.part = f"{kind} style {force.style} {part.style}"
        _unpack_settings(source, part, blob_of(kind, part.style).in_hybrid)
        if kind == "pair" and (_flag(source) or _flag(source)):
            says = "LAMMPS has pair_modify special of one pair style, pylmp's native engines do not"
            raise Unsupported(says, hint=f"{source.name} holds it")
        force.parts.append(part)


def _unpack_settings(source: Unpacker, force: Force, blob: Blob) -> None:
    for name, how in blob.settings:
        value = source.number() if how == NUMBER else source.integer()
        if how in _CODES and value not in _CODES[how]:
            source.fail(why=f"{name} is {value}")
        force.settings[name] = value


def _flag(source: Unpacker) -> bool:
    value = source.integer()
    if value not in (0, 1):
        source.fail(why=f"{value} where 0 or 1 should be")
    return bool(value)
