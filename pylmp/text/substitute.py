"""Quotes, comments and ``$`` of one logical line."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple, NoReturn

from lark import Token, UnexpectedInput

from pylmp.text.diagnostic import ScriptError
from pylmp.text.grammar import line_table
from pylmp.text.lines import Place, Text, check_length
from pylmp.text.span import Span
from pylmp.text.words import Word

_SPECIAL = re.compile("[#\"'$]")
_WORD = re.compile(r'"""((?s:.)*?)"""|"(?!"")([^"]*)"|\'([^\']*)\'|(\S+)')
_QUOTES = {"'": "single", '"': "double", '"""': "triple"}


class Piece(NamedTuple):
    """A stretch of a line: plain text, or a variable with its name, or an immediate one with its formula."""

    start: int
    stop: int
    kind: str = "text"
    key: str = ""


class PlacedWord(Word):
    """A word of a line, which finds out where it stands when somebody asks."""

    __slots__ = ("_end", "_line", "_start")

    def __init__(self, text: str, span: Text | Span | None = None, quoted: bool = False, start: int = 0, stop: int = 0) -> None:
        put = object.__setattr__
        put(self, "text", text)
        put(self, "quoted", quoted)
        put(self, "_line", span)
        put(self, "_start", start)
        put(self, "_end", stop)

    @property
    def span(self) -> Span | None:
        line: Text | Span | None = self._line  # type: ignore[attr-defined]
        return line.span(self._start, self._end) if isinstance(line, Text) else line  # type: ignore[attr-defined]


Lookup = Callable[[str, bool], str]


def substitute(line: Text, lookup: Lookup, echo: Callable[[str], None] | None = None, start: str = "line") -> Text:
    """The line without its comment, every ``$`` outside quotes replaced by lookup(name or formula, immediate).

    start is "inner" for the text of a quoted word, in which # begins no comment. echo receives the line as it stands after each replacement, as LAMMPS prints it.
    """
    if not _SPECIAL.search(line.text):
        return line
    trouble = None
    try:
        pieces = _pieces(line, start)
    except ScriptError as error:  # LAMMPS replaces what comes before it finds out
        trouble, pieces = error, _before(line.text, start)
    if trouble is None and len(pieces) == 1 and pieces[0].kind == "text" and pieces[0].stop == len(line.text):
        return line
    end = len(line.text) if trouble else pieces[-1].stop if pieces else 0
    out, starts, places = "", [], []
    for piece in pieces:
        if piece.kind != "text":
            value = _value(line, piece, lookup)
            span = line.span(piece.start, piece.stop)
            starts.append(len(out))
            places.append(Place(span.line, span.column, span.length))
            out += value
            check_length(len(out), span)
            if echo:
                echo(out + line.text[piece.stop : end])
        else:
            cuts = [piece.start, *(s for s in line.starts if piece.start < s < piece.stop)]
            for cut in cuts:
                place, column = line._at(cut)
                starts.append(len(out) + cut - piece.start)
                places.append(Place(place.row, column, place.width))
            out += line.text[piece.start : piece.stop]
    if trouble is not None:
        raise trouble
    return Text(line.file, out, tuple(starts) or (0,), tuple(places) or line.places[:1])


def _value(line: Text, piece: Piece, lookup: Lookup) -> str:
    try:
        return lookup(piece.key, piece.kind == "immediate")
    except ScriptError as error:
        raise error.at(line.span(piece.start, piece.stop)) from None


def _before(text: str, start: str) -> tuple[Piece, ...]:
    """What comes before the part that is wrong. A quote without end is found at once, but within a word."""
    at = _trouble(text, start)
    if text[at] in _QUOTES and start == "line":
        return ()
    try:
        return _read(text[:at], start)
    except UnexpectedInput:
        return ()


def varies(line: Text) -> bool:
    """A variable is to be replaced in it, or it is wrong."""
    try:
        return "$" in line.text and any(piece.kind != "text" for piece in _read(line.text, "line"))
    except UnexpectedInput:
        return True


def substitute_word(text: str, lookup: Lookup, placed: Callable[[], Text]) -> str:
    """The text of a quoted word with its variables replaced. placed gives that text with its place, for an error."""
    if not _SPECIAL.search(text):
        return text
    try:
        pieces = _read(text, "inner")
    except UnexpectedInput:
        substitute(placed(), lookup, start="inner")
        raise
    out = []
    for start, stop, kind, key in pieces:
        if kind == "text":
            out.append(text[start:stop])
        else:
            try:
                out.append(lookup(key, kind == "immediate"))
            except ScriptError as error:
                raise error.at(placed().span(start, stop)) from None
    check_length(sum(map(len, out)), None)
    return "".join(out)


def _pieces(line: Text, start: str) -> tuple[Piece, ...]:
    try:
        return _read(line.text, start)
    except UnexpectedInput:
        _complain(line, _trouble(line.text, start))


def _trouble(text: str, start: str) -> int:
    """Where a text is wrong."""
    try:
        _read(text, start)
    except UnexpectedInput as error:
        at = error.pos_in_stream
        if at is not None and 0 <= at < len(text) and (text[at] in _QUOTES or _opening(text) < 0):
            return at
    return max(_opening(text), 0)


@lru_cache(4096)
def _read(text: str, start: str) -> tuple[Piece, ...]:
    pieces: list[Piece] = []
    for node in line_table(start).parse(text).children:
        if isinstance(node, Token):
            if node.type == "COMMENT":
                break
            first, stop = node.start_pos or 0, node.end_pos or 0
            if pieces and pieces[-1].kind == "text":
                pieces[-1] = Piece(pieces[-1].start, stop)
            else:
                pieces.append(Piece(first, stop))
            continue
        first, stop = node.meta.start_pos, node.meta.end_pos
        key = text[first + 1 : stop] if node.data == "letter" else text[first + 2 : stop - 1]
        pieces.append(Piece(first, stop, str(node.data), key))
    return tuple(pieces)


def _opening(text: str) -> int:
    """Where the first variable begins that the end of the line leaves open; -1: there is none."""
    at = text.find("$")
    while at >= 0:
        if text.startswith("${", at) and "}" not in text[at:]:
            return at
        if text.startswith("$(", at):
            depth, stop = 1, at + 2
            while depth and stop < len(text):
                depth += (text[stop] == "(") - (text[stop] == ")")
                stop += 1
            if depth:
                return at
        at = text.find("$", at + 1)
    return -1


def _complain(line: Text, at: int) -> NoReturn:
    text = line.text
    span = line.span(at, at + 1)
    quote = '"""' if text.startswith('"""', at) else text[at]
    if quote in _QUOTES:
        raise ScriptError(f"Unmatched {_QUOTES[quote]} quote in command", span, hint=f"a second {quote} ends the text")
    begin = max(_opening(text[: at + 1]), 0) if not text.startswith("$", at) else at
    span = line.span(begin, max(begin + 2, at))
    if text.startswith("$(", begin):
        raise ScriptError("Invalid immediate variable", span, hint="a closing )")
    raise ScriptError(f"Invalid variable name {text[begin + 2 :]}", span, hint="${name} or $x")


def split(line: Text) -> list[Word]:
    """The words of a line whose variables are replaced."""
    words: list[Word] = []
    text, at = line.text, 0
    while True:
        while at < len(text) and text[at].isspace():
            at += 1
        if at == len(text):
            return words
        found = _WORD.match(text, at)
        assert found is not None
        stop = found.end()
        if found[4] is None:
            if stop < len(text) and not text[stop].isspace():
                raise ScriptError(
                    "Input line quote not followed by white-space",
                    line.span(stop - 1, stop),
                    hint="a blank after the quote",
                )
            words.append(PlacedWord(found[found.lastindex or 0], line, True, at, stop))
        else:
            if text[at] in _QUOTES:
                quote = '"""' if text.startswith('"""', at) else text[at]
                raise ScriptError(
                    "Unbalanced quotes in input line", line.span(at, at + 1), hint=f"a second {quote} ends the text"
                )
            words.append(PlacedWord(found[4], line, False, at, stop))
        at = stop
