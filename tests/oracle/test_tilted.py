"""Decks of styles that look at the box, run in a tilted one: `pylmp diff` says identical there too."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from tests.oracle.test_decks import diff, failures

DECKS = Path(__file__).parents[1] / "decks"
NAMES = (
    "bond/fene", "command/delete_atoms", "command/displace_atoms", "command/minimize", "command/replicate", "command/reset_atoms",
    "command/velocity", "compute/msd", "compute/rdf", "compute/stress_atom", "dump/custom", "fix/store_state", "region/sphere", "variable/atom",
)  # fmt: skip


def tilted(text: str) -> str:
    """The box of each create_box becomes a prism; bonds have room where its corners bring more of them together."""
    tilt = "0.4 0 0" if re.search(r"^dimension\s+2", text, re.M) else "0.4 -0.3 0.25"
    for name in set(re.findall(r"^create_box\s+\S+\s+(\S+)", text, re.M)):
        block = rf"^(region\s+{re.escape(name)}\s+)block((?:\s+\S+){{6}})"
        text, count = re.subn(block, rf"\1prism\2 {tilt}", text, flags=re.M)
        assert count
    return re.sub(r"extra/bond/per/atom \d+", "extra/bond/per/atom 12", text)


@pytest.mark.parametrize("name", NAMES)
def test_identical(name: str, tmp_path: Path) -> None:
    deck = DECKS / f"{name}.in"
    for path in deck.parent.glob(f"{deck.stem}.*"):
        shutil.copy2(path, tmp_path)
    (tmp_path / deck.name).write_text(tilted(deck.read_text()))
    report = diff(tmp_path / deck.name)
    assert report["verdict"] == "identical", failures(report)
