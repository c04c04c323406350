"""Ten million quiet steps of two beads and a plastic bond on the fast engine: nothing creeps.

Seen to fail: with fix viscous 1e-14 (swinging), with a plastic strain that grows by 1e-16 of the strain a step (swinging, damped).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pylmp.engines.fast import Fast
from tests.hard.pair import PAIR
from tests.support import simulate

STEPS = 10_000_000
M, K, DT = 2.0, 100.0, 0.01
SPEED = 0.05  # swings by 0.01, half of what would yield
DECK = PAIR + """bond_style bpm/spring/plastic
bond_coeff 1 100 0.3 {gamma} 0.02
fix 1 all nve
timestep 0.01
thermo 100000000
run 0
variable u atom {speed}*(2*id-3)
velocity all set v_u NULL NULL
run {steps}
"""


def after(steps: int, folder: Path, speed: float, gamma: float) -> tuple[float, float]:
    """(length, energy that velocity Verlet keeps of a spring); r0 and the plastic strain have kept their bits, the middle its place.

    Of a spring that swings with omega, velocity Verlet keeps the kinetic energy and 1 - (omega dt)^2/4 times the elastic one (k = mu omega^2, mu = 1).
    """
    sim, _ = simulate(DECK.format(speed=speed, gamma=gamma, steps=steps), folder, Fast())
    atoms: Any = sim.atoms
    order = np.argsort(atoms.tag[:2])
    x, v = atoms.x[:2][order], atoms.v[:2][order]
    used = atoms.bond_history[:2].reshape(-1, 2)
    assert sorted(map(tuple, used[used[:, 0] != 0.0].tolist())) == [(1.0, 0.0)] * len(used[used[:, 0] != 0.0]) != []
    assert np.abs(x.sum(axis=0)).max() == np.abs(v.sum(axis=0)).max() == np.abs(x[:, 1:]).max() == 0.0
    r = float(x[1, 0] - x[0, 0])
    return r, 0.5 * M * float((v**2).sum()) + 0.5 * K * (r - 1.0) ** 2 * (1.0 - 0.25 * K * DT**2)


def test_at_rest(tmp_path: Path) -> None:
    """To the bit."""
    assert after(STEPS, tmp_path, 0.0, 0.5) == (1.0, 0.0)


def test_swinging(tmp_path: Path) -> None:
    """Round-off alone: of a swing of 0.01 about 1, an ulp of the length is 2e-14; ten million steps that err at random, 7e-11."""
    _, first = after(1, tmp_path, SPEED, 0.0)
    r, last = after(STEPS, tmp_path, SPEED, 0.0)
    assert first == pytest.approx(M * SPEED**2, rel=1e-12)
    assert abs(last / first - 1.0) < 7e-11
    assert abs(r - 1.0) <= 0.0101


def test_damped(tmp_path: Path) -> None:
    """It comes to rest at its own length, and stays there to the bit."""
    assert after(STEPS, tmp_path, SPEED, 0.5) == (1.0, 0.0)
