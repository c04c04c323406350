"""docs/ says what the program is."""

from __future__ import annotations

import importlib.util
from pathlib import Path

ROOT = Path(__file__).parents[2]


def program(name: str):
    """A program of docs/, imported."""
    spec = importlib.util.spec_from_file_location(name, ROOT / "docs" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_list_of_commands_is_current() -> None:
    assert (ROOT / "docs" / "coverage.md").read_text() == program("coverage").coverage(), "python docs/coverage.py"


def test_the_picture_is_what_the_deck_draws() -> None:
    module = program("picture")
    assert (ROOT / "docs" / "hysteresis.svg").read_text() == module.picture(module.loop())


def test_the_readme_is_short_and_its_links_lead_somewhere() -> None:
    text = (ROOT / "README.md").read_text()
    assert 60 <= len(text.splitlines()) <= 100
    targets = [piece.split(")")[0] for piece in text.split("](")[1:]]
    assert targets
    for target in targets:
        assert (ROOT / target).exists(), target


def test_every_deck_has_a_line_in_the_readme() -> None:
    text = (ROOT / "README.md").read_text()
    for folder in (ROOT / "inputs").iterdir():
        if folder.is_dir():
            assert f"`inputs/{folder.name}`" in text
