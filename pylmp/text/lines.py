"""A script's text as logical lines, every character of which knows where it stands.

LAMMPS joins a line that ends in ``&`` with the next one, and lines while a triple quote is open.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from typing import NamedTuple

from pylmp.text.diagnostic import ScriptError
from pylmp.text.span import Span

LONGEST = 1_000_000  # characters of a logical line
_BLANK = " \t\n\v\f\r"
# What LAMMPS puts in place of typographic characters; one for one, so columns stay.
_ASCII = str.maketrans(
    dict.fromkeys("\u2018\u2019\u201b\u02bc\u02b9\u2032", "'")
    | dict.fromkeys("\u201c\u201d\u201f\u2033", '"')
    | dict.fromkeys("\u2010\u2011\u2012\u2013\u2014\u2212\uff0d", "-")
    | dict.fromkeys("\u00a0\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u202f\u205f", " ")
)


class Place(NamedTuple):
    """Where a piece of text comes from; width is None, or the source characters one replaced piece stands for."""

    row: int
    column: int
    width: int | None = None


@dataclass(frozen=True, slots=True)
class Text:
    """Text in pieces: piece k begins at offset starts[k] and comes from places[k]."""

    file: str
    text: str
    starts: tuple[int, ...]
    places: tuple[Place, ...]

    def span(self, start: int, stop: int) -> Span:
        """The source of text[start:stop]; the part on the first physical line if it goes over several."""
        first, begin = self._at(start)
        last, end = self._at(max(start, stop - 1))
        if first.row != last.row:
            return Span(self.file, first.row, begin, max(1, self._line_end(start, stop)))
        end += last.width if last.width is not None else 1
        return Span(self.file, first.row, begin, max(1, end - begin))

    def tail(self, start: int) -> Text:
        """What follows from an offset on."""
        place, column = self._at(start)
        later = [(at - start, one) for at, one in zip(self.starts, self.places, strict=True) if at > start]
        starts, places = (0, *(at for at, _ in later)), (Place(place.row, column, place.width), *(one for _, one in later))
        return Text(self.file, self.text[start:], starts, places)

    def _at(self, offset: int) -> tuple[Place, int]:
        k = max(0, bisect_right(self.starts, offset) - 1)
        place = self.places[k]
        return place, place.column + (0 if place.width is not None else offset - self.starts[k])

    def _line_end(self, start: int, stop: int) -> int:
        """Characters from start up to the next piece that is on another physical line."""
        first, _ = self._at(start)
        for offset, place in zip(self.starts, self.places, strict=True):
            if offset > start and place.row != first.row:
                return min(offset, stop) - start
        return stop - start


def plain(text: str, span: Span | None = None) -> Text:
    """Text that stands at span in one piece."""
    span = span or Span("", 1, 1)
    return Text(span.file, text, (0,), (Place(span.line, span.column),))


def logical_lines(source: str, file: str) -> list[Text]:
    """All logical lines, as LAMMPS echoes them."""
    lines: list[Text] = []
    text, starts, places = "", [], []
    open_line = False
    rows = source.split("\n")
    if rows[-1] == "":
        rows.pop()
    for row, physical in enumerate(rows, 1):
        starts.append(len(text))
        places.append(Place(row, 1))
        text = (text + physical).rstrip(_BLANK)
        if len(text) > LONGEST:
            check_length(len(text), Span(file, row, 1))
        if text.endswith("&"):
            text, open_line = text[:-1], True
            continue
        if text.count('"""') % 2:
            text, open_line = text + "\n", True
            continue
        lines.append(Text(file, text, tuple(starts), tuple(places)))
        text, starts, places, open_line = "", [], [], False
    if open_line:
        if not text.endswith("\n"):
            text += "&"  # nothing to join: the sign is a word
        lines.append(Text(file, text, tuple(starts), tuple(places)))
    return lines


def check_length(length: int, span: Span | None) -> None:
    """Raise ScriptError for a line that is too long."""
    if length > LONGEST:
        raise ScriptError(f"A line is longer than {LONGEST} characters", span, hint="several lines, or a file", code="S105")


def as_ascii(text: Text) -> Text:
    """Typographic quotes, dashes and blanks replaced by the characters LAMMPS reads them as."""
    return Text(text.file, text.text.translate(_ASCII), text.starts, text.places)


def decode(data: bytes, file: str) -> str:
    """The text of a script. Raises ScriptError if data is not text."""
    kinds = ((b"{\\rtf", "a word processor's file (RTF)"), (b"\x1f\x8b", "compressed (gzip)"), (b"PK\x03\x04", "a zip archive"),
             (b"\x89PNG", "an image"), (b"%PDF", "a PDF file"), (b"\x7fELF", "a program"), (b"\xff\xfe", "UTF-16"), (b"\xfe\xff", "UTF-16"))  # fmt: skip
    for magic, kind in kinds:
        if data.startswith(magic):
            raise ScriptError(
                f"Input script {file} is not a text file: it is {kind}", Span(file, 1, 1), hint="plain text, UTF-8"
            )
    at = data.find(b"\0")
    if at >= 0:
        line, column = data.count(b"\n", 0, at) + 1, at - data.rfind(b"\n", 0, at)
        raise ScriptError(
            f"Input script {file} is not a text file: it holds a NUL byte",
            Span(file, line, column),
            hint="plain text, UTF-8",
        )
    return data.decode("utf-8-sig", "surrogateescape")
