"""Lists of the fast engine: coefficients of few and of many types, rows listed share by share, too many neighbors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pylmp.engines import fast_list
from pylmp.engines.fast import Fast
from pylmp.kernels.simd import LANES
from pylmp.text.diagnostic import ScriptError
from tests.engines.scenes import script
from tests.engines.test_fast import bonds, both, rows
from tests.support import simulate


def of_types(types: int, count: int) -> str:
    """A gas in which every pair of types has its own coefficients, and so has every type of bonds."""
    pairs = "".join(
        f"pair_coeff {a} {b} {0.6 + 0.1 * a * b:.2f} {0.7 + 0.03 * (a + b):.2f} {1.6 + 0.1 * abs(a - b):.2f}\n"
        for a in range(1, types + 1) for b in range(a, types + 1)
    )  # fmt: skip
    made = "".join(f"group g type {a}\ncreate_bonds many g g {a} 0.5 1.5\ngroup g delete\n" for a in range(1, types + 1))
    coeffs = "".join(f"bond_coeff {a} {30 + 10 * a} {1.0 + 0.02 * a:.2f}\n" for a in range(1, types + 1))
    atoms = "".join(f"create_atoms {k % types + 1} random 1 {400 + k} NULL overlap 0.8 maxtry 500\n" for k in range(count))
    return (
        f"units lj\natom_style bond\nregion b block 0 6 0 6 0 6\ncreate_box {types} b bond/types {types} extra/bond/per/atom 20 extra/special/per/atom 90\n"
        f"{atoms}mass * 1.0\npair_style lj/cut 2.0\npair_modify shift yes\n{pairs}special_bonds lj/coul 0 1 1\n{made}special_bonds lj/coul 1 1 1\nbond_style harmonic\n{coeffs}"
        "velocity all create 1.0 99 loop geom\nfix 1 all nve\ntimestep 0.001\nthermo 10\n"
    )  # fmt: skip


@pytest.mark.parametrize(("types", "count"), [(1, 70), (2, 33), (3, 70), (4, 69), (5, 70)])
def test_any_number_of_types(types: int, count: int, tmp_path: Path) -> None:
    """Up to four are chosen, more are gathered."""
    exact, fast = both(of_types(types, count) + "run 30\n", tmp_path)
    assert set(rows(fast, "type")) == set(range(1, types + 1))
    for name, limit in (("x", 1e-11), ("v", 1e-10)):
        assert np.abs(rows(fast, name) - rows(exact, name)).max() <= limit
    f = rows(exact, "f")
    assert np.abs(rows(fast, "f") - f).max() <= 1e-9 * np.sqrt((f * f).mean())
    assert abs(fast.tally.pair - exact.tally.pair) <= 1e-10 * abs(exact.tally.pair)
    assert bonds(fast) == bonds(exact) != set()


@pytest.mark.parametrize("bond", ["plastic", "quartic"])
def test_shares_make_the_same_list(bond: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rows listed and woven a few at a time are those of one go, to the last bit."""
    text = script("lj", bond, newton="on on" if bond == "quartic" else "on off", heat=2.0) + "run 40\nrun 40\n"
    whole, _ = simulate(text, tmp_path / "whole", Fast())
    monkeypatch.setattr(fast_list, "SHARE", 5 * LANES)
    shares, _ = simulate(text, tmp_path / "shares", Fast())
    assert whole.atoms.n > 10 * LANES
    assert whole.report.builds == shares.report.builds > 1
    for name in ("x", "v", "f"):
        assert rows(whole, name).tobytes() == rows(shares, name).tobytes()


def test_too_many_neighbors(tmp_path: Path) -> None:
    """A row that has more than neigh_modify one ends the run as LAMMPS says it, before it fills the memory."""
    text = script("lj", "harmonic") + "neigh_modify one 8 page 100\nrun 1\n"
    with pytest.raises(ScriptError, match="Neighbor list overflow, boost neigh_modify one"):
        simulate(text, tmp_path, Fast())
