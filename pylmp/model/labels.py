"""Type labels: names that stand for the numbers of atom, bond, angle, dihedral and improper types.

Source: LAMMPS manual, labelmap.html, Howto_type_labels.html.
"""

from __future__ import annotations

import re
from dataclasses import replace

from pylmp.text.words import Args, Word

_LABEL = re.compile(r"[^\s\d*#]\S*", re.ASCII)


def is_label(text: str) -> bool:
    """It may be a label: no blanks, and no digit, * or # in front."""
    return _LABEL.fullmatch(text) is not None


class Labels:
    """by_type: kind ("atom", "bond", ...) -> type -> label. in_use: a label was ever given, so that words may be labels."""

    def __init__(self) -> None:
        self.by_type: dict[str, dict[int, str]] = {}
        self.in_use = False

    def of(self, kind: str) -> dict[int, str]:
        return self.by_type.get(kind, {})

    def assign(self, kind: str, number: int, label: str) -> None:
        self.by_type.setdefault(kind, {})[number] = label
        self.in_use = True

    def number(self, kind: str, label: str) -> int:
        """The type of a label, 0 if there is none."""
        return next((number for number, name in self.of(kind).items() if name == label), 0)

    def complete(self, kind: str, types: int) -> bool:
        """Every type has a label."""
        return types > 0 and all(number in self.of(kind) for number in range(1, types + 1))

    def translate(self, args: Args, kind: str) -> None:
        """Replace the next word by its type number if it is a label. Raises ScriptError for unknown labels."""
        word = args.peek()
        if word is not None:
            args.words[args.at] = self.resolved(args, kind, word)

    def resolved(self, args: Args, kind: str, word: Word) -> Word:
        """The word, or the number of the type if it is a label. Raises ScriptError for unknown labels."""
        if not self.in_use or not is_label(word.text):
            return word
        number = self.number(kind, word.text)
        if number == 0:
            known = " ".join(self.of(kind).values())
            args.fail(f"{kind.capitalize()} type string {word.text} not found in labelmap", word, hint=f"labels: {known or 'none'}")
        return replace(word, text=str(number))
