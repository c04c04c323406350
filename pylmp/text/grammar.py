"""The grammar files, read by Lark: one table for lines, one for formulas, one for each command on first use."""

from __future__ import annotations

import hashlib
import io
import re
import sys
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple, Protocol

import lark
from lark import Lark, Token, UnexpectedInput
from lark.lexer import Lexer
from lark.load_grammar import load_grammar

from pylmp.text.words import Word

_MOST = 4096  # shapes of lines remembered for each command


class Rejection(NamedTuple):
    """A line of the wrong shape: the word that does not fit (None: the line ends too early), and what would."""

    at: int | None
    expected: tuple[str, ...]


def folder() -> Path:
    """Where the grammar files are: inside an installed package, or at the top of a checkout."""
    package = Path(__file__).parents[1]
    inside = package / "grammar"
    return inside if inside.is_dir() else package.parent / "grammar"


class Store(Protocol):
    """Keeps bytes between runs, or does not: nothing depends on it but time."""

    def find(self, name: str) -> bytes | None: ...
    def keep(self, name: str, code: bytes) -> None: ...


store: Store | None = None  # the interpreter puts one here


@cache
def _page(name: str) -> str:
    return (folder() / f"{name}.lark").read_text()


@cache
def _grammar() -> Any:
    """The page of commands, read once for all tables."""
    return load_grammar(_page("commands"), str(folder() / "commands.lark"), [str(folder())], False)[0]


def _table(page: str, start: str, **options: Any) -> Lark:
    """The LALR table of one start rule, from the store if it is there."""
    said = (lark.__version__, sys.version, _page(page), _page("terms"), start, repr(sorted(options)))
    name = "grammar-" + hashlib.blake2b("\0".join(said).encode(), digest_size=20).hexdigest()
    kept = store.find(name) if store else None
    if kept is not None:
        try:
            return Lark.load(io.BytesIO(kept))
        except Exception:  # an entry of another make is no entry
            pass
    table = Lark(_grammar() if page == "commands" else _page(page), start=start, parser="lalr", **options)
    if store:
        data = io.BytesIO()
        table.save(data)
        store.keep(name, data.getvalue())
    return table


@cache
def line_table(start: str) -> Lark:
    """The parser of lines ("line") or of words whose quotes are gone ("inner")."""
    return _table("line", start, propagate_positions=True)


@cache
def parser(name: str) -> Lark:
    """The parser of formulas or of conditions."""
    return _table(name, "start")


@cache
def rules() -> tuple[str, ...]:
    """The commands of the page."""
    heads = re.findall(r'^(\w+):\s+"(\w+)"', _page("commands"), re.MULTILINE)
    return tuple(rule for rule, word in heads if rule == word)


class _NoLexer(Lexer):
    """Words come from the line reader; the parser is fed with them."""

    def __init__(self, conf: Any) -> None:
        pass

    def lex(self, lexer_state: Any, parser_state: Any = None) -> Iterator[Token]:
        return iter(())


class Shape:
    """The LALR table of one command, and which terminal a word is in each of its states."""

    def __init__(self, name: str) -> None:
        self._lark = _table("commands", name, lexer=_NoLexer)
        fixed = {t.pattern.value: t.name for t in self._lark.terminals if t.pattern.type == "str"}
        loose = sorted((t for t in self._lark.terminals if t.pattern.type == "re"), key=lambda t: -t.priority)
        self._fixed: dict[str, str] = fixed
        self._known: dict[tuple[str | int, ...], Rejection | None] = {}
        self._loose = [(t.name, re.compile(t.pattern.to_regexp())) for t in loose]
        self._names = {t.name: t.pattern.value if t.pattern.type == "str" else t.name.lower() for t in loose} | {
            name: text for text, name in fixed.items()
        }

    def checked(self, texts: tuple[str, ...]) -> Rejection | None:
        """As check. Words that no terminal tells apart are the same word, so that a loop's lines are looked at once."""
        key = tuple(text if text in self._fixed else self._kinds(text) for text in texts)
        if key not in self._known:
            if len(self._known) > _MOST:
                self._known.clear()
            self._known[key] = self.check(texts)
        return self._known[key]

    def _kinds(self, text: str) -> int:
        """Which loose terminals a word may be, as bits."""
        return sum(1 << k for k, (_, pattern) in enumerate(self._loose) if pattern.fullmatch(text))

    def check(self, texts: Sequence[str]) -> Rejection | None:
        """Nothing if the words have the command's shape."""
        parser = self._lark.parse_interactive()
        fed: list[Token] = []
        for at, text in enumerate(texts):
            terminal = self._terminal(text, parser.choices())
            if terminal is None:
                return Rejection(at, self._expected(fed))
            token = Token(terminal, text)
            try:
                parser.feed_token(token)
            except UnexpectedInput:
                return Rejection(at, self._expected(fed))
            fed.append(token)
        try:
            parser.feed_eof()
        except UnexpectedInput:
            return Rejection(None, self._expected(fed))
        return None

    def _terminal(self, text: str, choices: dict[str, Any]) -> str | None:
        fixed = self._fixed.get(text)
        if fixed in choices:
            return fixed
        return next((name for name, pattern in self._loose if name in choices and pattern.fullmatch(text)), None)

    def _expected(self, fed: list[Token]) -> tuple[str, ...]:
        """What may follow these words. A state of the table alone would name too much: LALR merges look-aheads."""
        parser = self._lark.parse_interactive()
        for token in fed:
            parser.feed_token(token)
        return tuple(sorted(self._names[name] for name in parser.accepts() if name in self._names))


@cache
def shape(name: str) -> Shape:
    return Shape(name)


def check(words: Sequence[Word]) -> Rejection | None:
    """Whether the words of a command, its name first, have the shape that the page gives it."""
    return shape(words[0].text).checked(tuple(word.text for word in words))
