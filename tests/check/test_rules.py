"""The examples in a rule's docstring are its tests; docs/rules.md says what the docstrings say."""

from __future__ import annotations

import inspect
import re
import runpy
import textwrap
from pathlib import Path

import pytest

from pylmp.tools.check.look import look
from pylmp.tools.check.rule import Rule, rules

RULES = rules()


def examples(rule: type[Rule], title: str) -> list[str]:
    text = inspect.getdoc(rule) or ""
    return [textwrap.dedent(found) for found in re.findall(rf"^{title}:\n((?:    .*\n?)+)", text, re.MULTILINE)]


@pytest.mark.parametrize("rule", RULES, ids=[rule.code for rule in RULES])
def test_its_examples(rule: type[Rule], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    script = tmp_path / "in.example"
    good, bad = examples(rule, "Okay"), examples(rule, "Bad")
    assert good and bad
    for text in [*good, *bad]:
        script.write_text(text)
        found = look(Path("in.example"), [])[1]
        assert not [one for one in found if one.severity == "error"]
        assert (rule.code in [one.code for one in found]) == (text in bad), text
    script.write_text("\n".join(f"{line}  # pylmp: ignore[{rule.code}]" for line in bad[0].splitlines()) + "\n")
    assert rule.code not in [one.code for one in look(Path("in.example"), [])[1]]


def test_codes_are_unique() -> None:
    assert len({rule.code for rule in RULES}) == len(RULES) >= 4


def test_the_page_is_current() -> None:
    folder = Path(__file__).parents[2] / "docs"
    names = runpy.run_path(str(folder / "rules.py"))
    assert (folder / "rules.md").read_text() == names["page"]()
