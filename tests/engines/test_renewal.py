"""Neighbor lists made anew by one compiled call: the same bits, lists and losses as by a rebuild in full."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pylmp.engines.fast import Fast, FastRun
from pylmp.engines.leap import Leap
from pylmp.engines.renewal import Renewal
from pylmp.kernels.fast.renewal import gridding, look_out
from tests.engines.scenes import script
from tests.engines.test_leap import outcome, table
from tests.support import simulate

SCENES = {
    "periodic": script("spring", "plastic", heat=3.0, seed=5),
    "flat": script("spring", "plastic", flat=True, heat=3.0, seed=6),
    "open": script("lj", "plastic", boundary="f f f", heat=3.0, seed=7),
    "in part": script("spring", "plastic", boundary="p f p", heat=3.0, seed=8),
    "shrinking": script("lj", "quartic", newton="on on", boundary="s s p", heat=3.0, seed=9),
    "leaving": script("lj", "plastic", boundary="f f f", heat=60.0, seed=10) + "thermo_modify lost ignore lost/bond ignore\n",
}
SORTS = "atom_modify sort {} 0.0\nthermo 10\nrun 60\nrun 40 pre no\nrun 60\n"


def rebuilds(text: str, folder: Path, monkeypatch, renewing: bool, leaping: bool) -> tuple[tuple[Any, ...], list[str], int]:
    """What a run leaves and writes, and how many rebuilds were in full."""
    full = []
    with monkeypatch.context() as patch:
        whole, bind = FastRun._rebuild, Renewal.bind
        patch.setattr(FastRun, "_rebuild", lambda self, **words: (full.append(self.sim.step), whole(self, **words))[1])
        if not renewing:
            patch.setattr(Renewal, "bind", lambda self, run: (bind(self, run), setattr(self, "call", None))[0])
        if not leaping:
            patch.setattr(Leap, "go", lambda self, run, end: False)
        sim, screen = simulate(text, folder, Fast())
    assert "Engine exact" not in screen
    return outcome(sim, folder), table(screen), len(full)


@pytest.mark.parametrize("sort", [1000, 25, 0])
@pytest.mark.parametrize("scene", SCENES)
def test_same_as_in_full(scene: str, sort: int, tmp_path: Path, monkeypatch) -> None:
    text = SCENES[scene] + SORTS.format(sort)
    kept, lines, all_in_full = rebuilds(text, tmp_path / "full", monkeypatch, renewing=False, leaping=False)
    assert all_in_full > 5
    for leaping in (False, True):
        same, printed, in_full = rebuilds(text, tmp_path / f"renewed{leaping}", monkeypatch, renewing=True, leaping=leaping)
        assert (same, printed) == (kept, lines)
        assert in_full == all_in_full if scene == "shrinking" else in_full < all_in_full


def test_who_may_be_lost() -> None:
    lo, hi = np.zeros(3), np.array([4.0, 4.0, 4.0])
    beyond = look_out((True, False, True))

    def count(least: tuple[float, ...], most: tuple[float, ...]) -> float:
        found: float = beyond(np.array(least), np.array(most), lo, hi)
        return found

    assert count((-2.0, 0.0, 0.0), (5.9, 3.9, 3.9)) == 0
    assert count((0.0, -1e-9, 0.0), (3.0, 3.0, 3.0)) == count((0.0, 0.0, 0.0), (3.0, 4.0, 3.0)) == 1
    assert count((-2.1, 0.0, 0.0), (3.0, 3.0, 6.0)) == 2
    assert count((0.0, 0.0, float("nan")), (3.0, 3.0, 3.0)) == 1
    assert count((0.0, 0.0, 0.0), (3.0, float("inf"), 3.0)) == 1


def test_cells() -> None:
    """Periodic directions from face to face, others from atom to atom; as many cells as fit and no more than allowed."""
    lo, hi, least, most = np.zeros(3), np.array([4.0, 4.0, 4.0]), np.array([1.0, 1.0, -5.0]), np.array([2.0, 3.0, 25.0])
    corner, inverse, lengths, limit2, counts = np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(1), np.zeros(3, np.int64)
    grid = gridding((True, False, False), False)
    assert grid(lo, hi, least, most, 0.9, 0.001, 1000, 1000, corner, inverse, lengths, counts, limit2) == 0
    assert (counts.tolist(), corner.tolist(), lengths.tolist()) == ([4, 2, 33], [0.0, 1.0, -5.0], [4.0, 4.0, 4.0])
    assert inverse.tolist() == [1.0, 1.0, 1.0 / 30.0 * 33]
    assert limit2[0] == (0.9 + 0.03) ** 2
    assert grid(lo, hi, least, most, 0.9, 0.001, 100, 60, corner, inverse, lengths, counts, limit2) == 4
    assert counts.tolist() == [4, 2, 8]
    flat = gridding((True, True, True), True)
    assert flat(lo, hi, least, most, 0.9, 0.001, 1000, 1000, corner, inverse, lengths, counts, limit2) == 0
    assert counts.tolist() == [4, 4, 1]
