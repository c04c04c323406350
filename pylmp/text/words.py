"""The words of one command and a cursor over them.

`Args` is how every command and style reads its arguments: each method takes the next word, checks it,
and fails with LAMMPS's own sentence at that word's place.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NoReturn

from pylmp.text.diagnostic import ScriptError
from pylmp.text.span import Span

_FLOAT = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
_INTEGER = re.compile(r"[-+]?\d+")
_YES, _NO = ("yes", "on", "true"), ("no", "off", "false")
_MOST = 2**31 - 1  # LAMMPS's types have 32 bits
_IN_SCRIPT = "in input script or data file"


@dataclass(frozen=True, slots=True)
class Word:
    """One argument: its text without quotes, where it stands, whether it was quoted."""

    text: str
    span: Span | None = None
    quoted: bool = False

    def __str__(self) -> str:
        return self.text


class Args:
    """A cursor over the words that follow a command's name.

    what    how LAMMPS names the owner in "Illegal {what} command", e.g. "region" or "fix langevin"
    owner   the word that names the command or style; errors about something missing point at it
    manual  page of the manual, carried into every error
    """

    def __init__(self, what: str, words: Sequence[Word], owner: Word | None = None, manual: str = "") -> None:
        self.what = what
        self.words = list(words)
        self.owner = owner
        self.manual = manual
        self.at = 0

    def __len__(self) -> int:
        """Words not read yet."""
        return len(self.words) - self.at

    def fail(self, message: str, word: Word | None = None, *, hint: str = "", code: str = "") -> NoReturn:
        """Raise `ScriptError` at word (default: the last word read, else the owner)."""
        if word is None:
            word = self.words[self.at - 1] if self.at else self.owner
        raise ScriptError(message, word.span if word else None, hint=hint, code=code, manual=self.manual)

    def illegal(self, word: Word | None = None, *, hint: str = "") -> NoReturn:
        self.fail(f"Illegal {self.what} command", word, hint=hint)

    def missing(self, hint: str = "") -> NoReturn:
        last = self.words[-1] if self.words else self.owner
        self.fail(f"Illegal {self.what} command: missing argument(s)", last, hint=hint)

    def peek(self) -> Word | None:
        """The next word, not taken; None at the end."""
        return self.words[self.at] if self.at < len(self.words) else None

    def word(self) -> Word:
        """Take the next word as it is."""
        if self.at >= len(self.words):
            self.missing()
        self.at += 1
        return self.words[self.at - 1]

    def rest(self) -> list[Word]:
        """Take all remaining words."""
        left, self.at = self.words[self.at :], len(self.words)
        return left

    def expect(self, low: int, high: int, wording: str) -> None:
        """Fail unless the command has low to high words; wording is how LAMMPS states the number."""
        count = len(self.words)
        if not low <= count <= high:
            word = self.words[high] if count > high else self.words[-1] if self.words else self.owner
            self.fail(f"Illegal {self.what} command: expected {wording} but found {count}", word)

    def need(self, count: int, key: str = "") -> None:
        """Fail unless at least count words remain; key: the keyword they belong to."""
        if len(self) < count:
            last = self.words[-1] if self.words else self.owner
            what = f"{self.what} {key}" if key else self.what
            self.fail(f"Illegal {what} command: missing argument(s)", last)

    def take(self, text: str) -> bool:
        """Take the next word if it is text."""
        word = self.peek()
        if word is None or word.text != text:
            return False
        self.at += 1
        return True

    def number(self) -> float:
        return self.as_number(self.word())

    def integer(self, bits: int = 32) -> int:
        return self.as_integer(self.word(), bits)

    def yes(self) -> bool:
        """A yes/no word, as LAMMPS spells them (yes on true 1, no off false 0; lower case)."""
        word = self.peek()
        if word is None or not word.text:
            self.fail(f"Expected boolean parameter instead of NULL or empty string {_IN_SCRIPT}")
        self.at += 1
        if word.text in _YES or word.text == "1":
            return True
        if word.text in _NO or word.text == "0":
            return False
        self.fail(f"Expected boolean parameter instead of '{word.text}' {_IN_SCRIPT}", word, hint="yes or no")

    def types(self, count: int) -> range:
        """A type range ``n``, ``*``, ``*n``, ``n*`` or ``m*n`` within 1..count."""
        return self.as_range(self.word(), 1, count)

    def as_number(self, word: Word) -> float:
        if not _FLOAT.fullmatch(word.text):
            self.fail(f"Expected floating point parameter instead of {_shown(word)} {_IN_SCRIPT}", word, hint="a number")
        value = float(word.text)
        if math.isinf(value):
            self.fail(f"Floating point number {word.text} {_IN_SCRIPT} is out of range", word)
        return value

    def as_integer(self, word: Word, bits: int = 32) -> int:
        """A whole number of so many bits: numbers of steps have 64 in LAMMPS, all others 32."""
        if not _INTEGER.fullmatch(word.text):
            self.fail(f"Expected integer parameter instead of {_shown(word)} {_IN_SCRIPT}", word, hint="a whole number")
        value = int(word.text) if len(word.text) < 100 else 1 << bits
        if not -1 << (bits - 1) <= value < 1 << (bits - 1):
            self.fail(f"Integer {word.text} {_IN_SCRIPT} is out of range", word)
        return value

    def as_range(self, word: Word, low: int, high: int) -> range:
        """LAMMPS's range parser: any bound that is zero or negative is refused, whatever the limits are."""
        text = word.text
        found = re.fullmatch(r"(\d*)(\*?)(\d*)", text)
        if not found or text == "" or (found[2] == "" and found[3]):
            self.fail(f"Invalid range string: {text}", word)
        start = int(found[1]) if found[1] else low
        stop = int(found[3]) if found[3] else (high if found[2] else start)
        if start <= 0 or (found[3] and stop <= 0) or max(start, stop) > _MOST > high:
            self.fail(f"Invalid range string: {text}", word)
        if start > high:
            self.fail(f"Numeric index {start} is out of bounds ({low}-{high})", word)
        if stop > high:
            self.fail(f"Numeric index {stop} is out of bounds ({low}-{high})", word)
        if start > stop:
            self.fail(f"Numeric index {start} is out of bounds ({low}-{stop})", word)
        return range(start, stop + 1)


def _shown(word: Word) -> str:
    return f"'{word.text}'" if word.text else "NULL or empty string"
