"""The page of the language: it and the commands are the same set, and its tables say what they should."""

from __future__ import annotations

import pytest

from pylmp.model.registry import COMMANDS
from pylmp.text import grammar
from pylmp.text.grammar import Rejection


def test_the_page_and_the_commands_are_the_same_set() -> None:
    assert sorted(grammar.rules()) == sorted(COMMANDS.names())


@pytest.mark.parametrize("name", grammar.rules())
def test_every_rule_builds_a_table_of_its_own(name: str) -> None:
    rejected = grammar.shape(name).check(["nonsense"])
    assert rejected == Rejection(0, (name,))


@pytest.mark.parametrize(
    "line",
    [
        "mass * 1.0", "mass 1 1e-3", "bond_coeff 1 10 0.3 0.5 0.02", "fix file all nve", "print text file f append g screen no",
        "run 100 upto", "run 100 every 10 cmd cmd", "if c then x elif d y z else w", "special_bonds lj 0 1 1 coul 1 1 1",
        "special_bonds lj/coul 0 1 1 angle yes", "delete_bonds all bond 1*3 undo remove special", "newton on off", "newton 1 0",
        "boundary p s fm", "create_box 2 b bond/types 2 extra/special/per/atom 10", "lattice sq2 0.8 origin 0 0.5 0", "quit", "clear",
    ],
)  # fmt: skip
def test_right_lines(line: str) -> None:
    words = line.split()
    assert grammar.shape(words[0]).check(words) is None


@pytest.mark.parametrize(
    ("line", "at", "expected"),
    [
        ("newton on off on", 3, ()),
        ("newton maybe", 1, ("no", "yes")),
        ("timestep a", 1, ("integer", "number")),
        ("timestep", None, ("integer", "number")),
        ("special_bonds lj 0 1", None, ("integer", "number")),
        ("run 5 pre maybe", 3, ("no", "yes")),
        ("boundary p p q", 3, ("edge",)),
        ("clear all", 1, ()),
        ("neighbor 0.3 bins", 2, ("bin", "multi", "multi/old", "nsq")),
    ],
)
def test_wrong_lines_name_the_word_and_what_may_stand_there(
    line: str, at: int | None, expected: tuple[str, ...]
) -> None:
    words = line.split()
    assert grammar.shape(words[0]).check(words) == Rejection(at, expected)


def test_a_word_in_quotes_is_the_same_word() -> None:
    assert grammar.shape("print").check(["print", "", "screen", "no"]) is None
    assert grammar.shape("print").check(["print", "two words", "file", "a file"]) is None


def test_tables_survive_a_store_that_lies(monkeypatch: pytest.MonkeyPatch) -> None:
    """A kept table that cannot be read is built again; one that can is used."""
    kept: dict[str, bytes] = {}

    class Store:
        def find(self, name: str) -> bytes | None:
            return kept.get(name)

        def keep(self, name: str, code: bytes) -> None:
            kept[name] = code

    monkeypatch.setattr(grammar, "store", Store())
    line = ["newton", "on", "off"]
    assert grammar.Shape("newton").check(line) is None
    (name,) = kept
    assert grammar.Shape("newton").check(line) is None
    kept[name] = b"\x80rubbish"
    assert grammar.Shape("newton").check(line) is None
    assert kept[name] != b"\x80rubbish"
