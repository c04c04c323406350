"""Logical lines: what is joined, and where each word stands."""

from __future__ import annotations

import pytest

from pylmp.text.diagnostic import ScriptError
from pylmp.text.lines import decode, logical_lines
from pylmp.text.substitute import split, substitute

VALUES = {"a": "alpha", "n": "1 2 3", "x": "y"}


def words(script: str) -> list[tuple[str, str]]:
    """(text, file:line:column+length) of all words of a script, variables replaced."""
    found = []
    for line in logical_lines(script, "in.x"):
        for word in split(substitute(line, lambda key, is_formula: "7" if is_formula else VALUES[key])):
            assert word.span is not None
            found.append((word.text, f"{word.span}+{word.span.length}"))
    return found


@pytest.mark.parametrize(
    ("script", "expected"),
    [
        (
            "fix 1 all nve\n",
            [("fix", "in.x:1:1+3"), ("1", "in.x:1:5+1"), ("all", "in.x:1:7+3"), ("nve", "in.x:1:11+3")],
        ),
        ("\n\n  units\tlj # comment", [("units", "in.x:3:3+5"), ("lj", "in.x:3:9+2")]),
        ("run &\n  100 &\nupto", [("run", "in.x:1:1+3"), ("100", "in.x:2:3+3"), ("upto", "in.x:3:1+4")]),
        ("ru&\nn 5", [("run", "in.x:1:1+2"), ("5", "in.x:2:3+1")]),
        ("print \"a b\"  'c'", [("print", "in.x:1:1+5"), ("a b", "in.x:1:7+5"), ("c", "in.x:1:14+3")]),
        ("mass $a 1.0", [("mass", "in.x:1:1+4"), ("alpha", "in.x:1:6+2"), ("1.0", "in.x:1:9+3")]),
        ("mass k${a}z end", [("mass", "in.x:1:1+4"), ("kalphaz", "in.x:1:6+6"), ("end", "in.x:1:13+3")]),
        ("set ${n} x", [("set", "in.x:1:1+3"), *[(v, "in.x:1:5+4") for v in "123"], ("x", "in.x:1:10+1")]),
        ("a $(2*(3+4)) b", [("a", "in.x:1:1+1"), ("7", "in.x:1:3+10"), ("b", "in.x:1:14+1")]),
        ("a &\n  ${x} c", [("a", "in.x:1:1+1"), ("y", "in.x:2:3+4"), ("c", "in.x:2:8+1")]),
        ('p """one\ntwo""" q', [("p", "in.x:1:1+1"), ("one\ntwo", "in.x:1:3+7"), ("q", "in.x:2:8+1")]),
        ('print "$a # not a comment"', [("print", "in.x:1:1+5"), ("$a # not a comment", "in.x:1:7+20")]),
    ],
)
def test_words_know_where_they_stand(script: str, expected: list[tuple[str, str]]) -> None:
    assert words(script) == expected


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"units lj\nrun\x00 1\n", "NUL"),
        (b"{\\rtf1\\ansi units lj}", "RTF"),
        (b"\x1f\x8b\x08\x00", "gzip"),
        (b"%PDF-1.4", "PDF"),
        (b"PK\x03\x04", "zip"),
        ("units lj\n".encode("utf-16"), "UTF-16"),
    ],
)
def test_what_is_not_text_is_named(data: bytes, reason: str) -> None:
    with pytest.raises(ScriptError, match="is not a text file") as caught:
        decode(data, "in.x")
    assert reason in str(caught.value)
    assert caught.value.diagnostic.span is not None


def test_the_place_of_a_nul_byte() -> None:
    with pytest.raises(ScriptError) as caught:
        decode(b"units lj\nrun\x00 1\n", "in.x")
    assert str(caught.value.diagnostic.span) == "in.x:2:4"


def test_a_byte_order_mark_and_windows_line_ends_do_no_harm() -> None:
    assert [w for w, _ in words(decode(b"\xef\xbb\xbfunits lj\r\nrun 1\r\n", "in.x"))] == ["units", "lj", "run", "1"]


def test_the_place_of_an_open_quote() -> None:
    with pytest.raises(ScriptError, match="Unmatched double quote in command") as caught:
        words("print 'fine' &\n  \"open")
    assert str(caught.value.diagnostic.span) == "in.x:2:3"
