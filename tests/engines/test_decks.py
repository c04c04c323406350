"""Decks of tests/decks and of inputs/ on the fast engine: what docs/engines.md says runs there does, and to round-off as on the exact one.

Each deck is a scene of its own with kernels of its own to compile, which takes minutes in all: ``pytest -m long`` carries them out.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.engines.decks import DECKS, apart, lacking, name, three
from tests.engines.page import PAGE, row

DEPARTS = {  # and why
    "tests/decks/command/write_restart.in": "LAMMPS forgets what bonds across a face went through since the last rebuild when it makes ghosts anew",
}


@pytest.mark.long
@pytest.mark.parametrize("deck", DECKS, ids=[name(deck) for deck in DECKS])
def test_as_on_the_exact_engine(deck: Path, tmp_path: Path) -> None:
    """Atoms part no more than they do on the exact engine when they are moved by 1e-15 before each run."""
    exact, fast, nudged = three(deck, tmp_path)
    assert row(deck, lacking(fast)) in PAGE.read_text().splitlines()
    assert fast.step == exact.step
    if not exact.has_box:
        return
    assert fast.atoms.n == exact.atoms.n
    distance = apart(exact, fast)
    if name(deck) in DEPARTS:
        assert distance > 1e-9, "this is not so any longer"
        return
    limit = 1e-11 + (10.0 * apart(exact, nudged) if nudged and nudged.atoms.n == exact.atoms.n else 0.0)
    assert distance <= limit or np.isnan(distance)
    assert fast.bonds == exact.bonds or limit > 1e-3


def test_the_page_has_no_other_decks() -> None:
    told = [line.split("`")[1] for line in PAGE.read_text().splitlines() if line.startswith("| `")]
    assert told == [name(deck) for deck in DECKS]
