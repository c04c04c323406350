"""A restart file's content to bytes."""

from __future__ import annotations

from typing import Any

from pylmp.io.restart import layout
from pylmp.io.restart.atoms import pack_atoms
from pylmp.io.restart.blobs import pack_force
from pylmp.io.restart.content import Content
from pylmp.io.restart.stream import Packer


def encode(content: Content) -> list[bytes]:
    """One file, or, where content.files says so, the base file and the one that holds the atoms."""
    base = Packer()
    base.raw(layout.MAGIC)
    base.integer(layout.ORDER)
    base.integer(layout.REVISION)
    _header(base, content.header)
    _groups(base, content.groups)
    _types(base, content)
    for kind, force in content.forces.items():
        base.integer(layout.FORCES[kind])
        pack_force(base, kind, force, content.header[f"{'atom' if kind == 'pair' else kind} types"])
    base.integer(layout.END)
    _fixes(base, content)
    base.integer(layout.FILES)
    base.integer(content.files)
    base.integer(layout.END)
    if not content.files:
        _atoms(base, content)
        return [base.whole()]
    base.raw(layout.MAGIC)
    piece = Packer()
    piece.integer(layout.PIECES)
    piece.integer(1)
    _atoms(piece, content)
    return [base.whole(), piece.whole()]


def _header(to: Packer, header: dict[str, Any]) -> None:
    for name, value in header.items():
        flag, kind = layout.HEADER[name]
        to.integer(flag)
        if kind == "style":
            style, words = value
            to.text(style)
            to.integer(len(words))
            for word in words:
                to.text(word)
        else:
            getattr(to, kind)(value)
    to.integer(layout.END)


def _groups(to: Packer, groups: dict[str, int]) -> None:
    """Slot by slot; 0 is an empty one."""
    to.integer(len(groups))
    by_slot = {slot: name for name, slot in groups.items()}
    for slot in range(max(by_slot) + 1):
        if slot in by_slot:
            to.text(by_slot[slot])
        else:
            to.integer(0)


def _types(to: Packer, content: Content) -> None:
    if content.mass:
        to.integer(layout.MASS)
        to.numbers(content.mass)
    if content.labels is not None:
        to.integer(layout.LABELS)
        to.integer(1)
        for label in content.labels:
            to.text(label)
    to.integer(layout.END)


def _fixes(to: Packer, content: Content) -> None:
    to.integer(len(content.fixes))
    for identity, style, state in content.fixes:
        to.text(identity)
        to.text(style)
        to.integer(len(state))
        to.raw(state)
    to.integer(len(content.kept))
    for kept in content.kept:
        to.text(kept.identity)
        to.text(kept.style)
        to.integer(1 + kept.width)


def _atoms(to: Packer, content: Content) -> None:
    records = pack_atoms(content)
    to.integer(layout.PROCESS)
    to.integer(len(records))
    to.raw(records.tobytes())
    to.raw(layout.MAGIC)
