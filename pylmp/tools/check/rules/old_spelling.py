"""P113."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.text.words import Word
from pylmp.tools.check.rule import Rule

if TYPE_CHECKING:
    from pylmp.tools.check.look import Look

_NOW = {"reset_ids": "reset_atoms id", "reset_atom_ids": "reset_atoms id", "reset_mol_ids": "reset_atoms mol"}


class OldSpelling(Rule):
    """A command has a new name, and its old one will go.

    LAMMPS still takes it; a later release will not.

    Okay:
        region cell block 0 9 0 9 0 9
        create_box 1 cell
        mass 1 1.0
        reset_atoms id

    Bad:
        region cell block 0 9 0 9 0 9
        create_box 1 cell
        mass 1 1.0
        reset_ids
    """

    code = "P113"
    name = "old-spelling"
    manual = "reset_atoms.html"

    def after(self, look: Look, words: list[Word]) -> None:
        now = _NOW.get(words[0].text)
        if now:
            look.warn(self, words[0].span, f"{words[0].text} is an old name", now)
