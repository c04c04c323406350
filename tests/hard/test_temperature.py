"""fix langevin: kinetic energies of single degrees of freedom against the closed form, by chi-square.

The recursion of velocity Verlet with this fix is linear for free atoms, so that the variance of a velocity is known at every step, not only for small
timesteps: with q = dt/damp the full-step temperature at rest in the bath is T itself. Bonds change that by about (omega dt)^2/4.
Seen to fail: with damp 20 % longer in drag and noise (warming up), with 25 for the 24 in the noise (both).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from pylmp.engines.exact import Exact
from pylmp.engines.fast import Fast
from pylmp.interpreter import run_text
from tests.support import simulate

T, DAMP, DT = 1.7, 0.25, 0.0025
MASS = np.array([0.0, 1.0, 3.0])
BINS = 21  # equally likely: 20 degrees of freedom
CONTRACT = 0.01  # chance of a distribution as far away or farther
WARM = 50  # steps: half of damp
APART, TIMES = 300, 12  # three times damp: velocities are new
BOND = "create_bonds many left right 1 0.9 1.1\nbond_style harmonic\nbond_coeff 1 20 1.0"
DECK = """units lj
atom_style bond
region cell block 0 64 0 64 0 64
lattice sc 0.015625
create_box 2 cell bond/types 1 extra/bond/per/atom 1 extra/special/per/atom 2
region here block 0 64 0 64 0 64 units box
create_atoms 1 region here
group left type 1
create_atoms 2 region here
group right type 2
displace_atoms right move 1.0 0 0 units box
mass 1 1.0
mass 2 3.0
pair_style zero 2.0
pair_coeff * *
{bond}
fix 1 all nve
fix 2 all langevin {T} {T} {damp} 4711
timestep {dt}
thermo 100000
"""


def warm(steps: int, damp: float) -> float:
    """<m v^2> after so many steps from rest, in closed form: each half step keeps 1 - q and adds 2 q T; what is printed is half way between."""
    q = DT / damp
    keep = (1.0 - q) ** 2
    half = 0.5 * q * T  # after the first half kick
    half = half * keep ** (steps - 1) + 2.0 * q * T * (1.0 - keep ** (steps - 1)) / (1.0 - keep)
    return (1.0 - 0.5 * q) ** 2 * half + 0.5 * q * T


def chance(energy: np.ndarray, expected: float) -> float:
    """Of a chi-square as large or larger, if twice the energy over the expected one is chi-square with one degree of freedom."""
    u = [math.erf(math.sqrt(0.5 * w)) for w in (energy / expected).ravel().tolist()]
    found, likely = np.histogram(u, BINS, (0.0, 1.0))[0], len(u) / BINS
    half = 0.5 * float(((found - likely) ** 2 / likely).sum())
    return math.exp(-half) * sum(half**k / math.factorial(k) for k in range((BINS - 1) // 2))


def energies(sim: Any) -> np.ndarray:
    """m v^2 of every degree of freedom."""
    n = sim.atoms.n
    return MASS[sim.atoms.type[:n], None] * sim.atoms.v[:n] ** 2


@pytest.fixture(scope="module", params=[(Exact, ""), (Exact, BOND), (Fast, ""), (Fast, BOND)], ids=["exact", "exact, bonds", "fast", "fast, bonds"])
def found(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[bool, np.ndarray, np.ndarray]:
    """(free atoms?, warming up, at rest in the bath)."""
    engine, bond = request.param
    sim, _ = simulate(DECK.format(bond=bond, T=T, damp=DAMP, dt=DT) + f"run {WARM}\n", tmp_path_factory.mktemp("bath"), engine())
    soon, late = energies(sim), []
    run_text(sim, f"run {2 * APART}\n")
    for _ in range(TIMES):
        run_text(sim, f"run {APART}\n")
        late.append(energies(sim))
    return not bond, soon, np.array(late)


def test_at_rest_in_the_bath(found: tuple[bool, np.ndarray, np.ndarray]) -> None:
    """Also of each direction and type."""
    _, _, late = found
    assert chance(late, T) > CONTRACT
    for part in (*np.moveaxis(late, 2, 0), late[:, ::2], late[:, 1::2]):
        assert chance(part, T) > CONTRACT / 5
    assert chance(late, 1.03 * T) < 1e-6  # a bath 3 % too hot would be seen


def test_warming_up(found: tuple[bool, np.ndarray, np.ndarray]) -> None:
    free, soon, _ = found
    if free:
        assert chance(soon, warm(WARM, DAMP)) > CONTRACT
        assert chance(soon, warm(WARM, 1.2 * DAMP)) < 1e-6  # so would a friction a sixth too small
