"""Forces of a whole small system against 4th-order differences of its energy in random directions of all coordinates, for each bond that can break.

The energy is the program's own where it has one; of bonds bpm with smooth yes and of plastic ones (LAMMPS: zero, or without the smoothing factor) it is
the integral of the law, with lengths at rest as the program remembers them.
Seen to fail: with 1.01 times the eighth power in the smoothing factor (smooth), with 2.000001 for the 2 in the force of bond quartic (quartic).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pylmp.engines.exact import Exact
from pylmp.engines.fast import Fast
from pylmp.interpreter import run_text
from tests.support import simulate

H = 2.0**-12
# Of 4th order: what is left is h^4/30 of the fifth derivative, and round-off of the energy over h; 4e-10 was measured.
BOUND = 1e-9  # of the largest force
DIRECTIONS = 12
BLOCK = """units lj
atom_style bond
newton on off
comm_modify vel yes cutoff 3.0
special_bonds lj/coul 0 1 1
lattice sc 1.0 origin 0.25 0.25 0.25
region cell block 0 5 0 5 0 5 units box
region block block 1 4 1 4 1 3 units box
create_box 1 cell bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 40
create_atoms 1 region block
mass 1 1.0
displace_atoms all random 0.03 0.03 0.03 817
pair_style zero 1.5
pair_coeff * *
create_bonds many all all 1 0.7 1.3
special_bonds lj 0 1 1 coul 1 1 1
{bond}
fix 1 all nve
timestep 0.005
velocity all create {heat} 55
run 100
velocity all set 0 0 0
{after}
run 0
"""
K, BREAK = 40.0, 0.5
BPM = "bond_style bpm/spring{} smooth {}\nbond_coeff 1 40 0.5 0.7 {}"
PAIR = "special_bonds lj/coul 1 1 1\npair_style lj/cut 1.58\npair_modify shift yes\npair_coeff * * 1 1\nbond_style quartic"
PAIR += "\nbond_coeff 1 1200 -0.55 0.25 1.3 34.6878"
LAWS = {  # also: a temperature to start from, what to change before forces are compared
    "quartic": (PAIR, 0.05, ""),
    "spring": (BPM.format("", "no", ""), 0.05, ""),
    "smooth spring": (BPM.format("", "yes", ""), 1.0, ""),
    "plastic": (BPM.format("/plastic", "no", "0.002"), 0.2, "bond_coeff 1 40 0.5 0.7 0.2"),  # from here on nothing yields
    "smooth plastic": (BPM.format("/plastic", "yes", "0.002"), 0.2, "bond_coeff 1 40 0.5 0.7 0.2"),
}


class System:
    """At given places (in order of ids): forces, and the energy whose gradient they should be."""

    def __init__(self, engine: Any, folder: Path, law: str) -> None:
        bond, heat, after = LAWS[law]
        self.sim: Any = simulate(BLOCK.format(bond=bond, heat=heat, after=after), folder, engine)[0]
        self.own = law in ("quartic", "spring")
        self.smooth = law.startswith("smooth")
        atoms = self.sim.atoms
        self.many = atoms.n
        tag = atoms.tag[: self.many]
        self.x = atoms.x[: self.many][np.argsort(tag)].copy()
        found = {}
        for i in range(self.many):
            for slot in range(atoms.num_bond[i]):
                if atoms.bond_type[i, slot] > 0:
                    ends = tuple(sorted((int(tag[i]), int(atoms.bond_atom[i, slot]))))
                    found[ends] = [*atoms.bond_history[i, slot].tolist(), 0.0, 0.0][:2]
        self.ends = np.array(list(found)) - 1
        self.r0, self.ep = np.array(list(found.values())).T
        self.memory = {int(t): atoms.bond_history[i].copy() for i, t in enumerate(tag)}

    def at(self, x: np.ndarray) -> tuple[float, np.ndarray]:
        atoms = self.sim.atoms
        rows = atoms.tag[: self.many] - 1
        atoms.x[: self.many] = x[rows]
        for i, t in enumerate(rows + 1):
            atoms.bond_history[i] = self.memory[int(t)]
        run_text(self.sim, "run 0\n")
        rows = atoms.tag[: self.many] - 1
        f = np.empty_like(x)
        f[rows] = atoms.f[: self.many]
        energy = self.sim.tally.pair + self.sim.tally.bond
        return energy if self.own else self.spring(x), f

    def spring(self, x: np.ndarray) -> float:
        """Integral of k (r - r_eq) (1 - ((r - r0)/(r0 eps_c))^8) from r0, with r_eq = (1 + ep) r0."""
        s = np.linalg.norm(x[self.ends[:, 0]] - x[self.ends[:, 1]], axis=1) - self.r0
        d, wide = self.ep * self.r0, self.r0 * BREAK
        extra = wide * wide * ((d / wide) * (s / wide) ** 9 / 9.0 - (s / wide) ** 10 / 10.0) if self.smooth else 0.0
        return float((K * (0.5 * s * s - d * s + extra)).sum())


@pytest.mark.parametrize("engine", [Exact, Fast])
@pytest.mark.parametrize("law", LAWS)
def test_forces_are_the_gradient_of_the_energy(engine: type, law: str, tmp_path: Path) -> None:
    system = System(engine(), tmp_path, law)
    assert len(system.ends) > 30
    assert "plastic" not in law or np.count_nonzero(system.ep) > 10
    f = system.at(system.x)[1]
    size = np.abs(f).max()
    assert size > 0.1
    ways = np.random.default_rng(3).uniform(-1.0, 1.0, (DIRECTIONS, *f.shape))
    for way in ways:
        one, two, back, far = (system.at(system.x + by * way)[0] for by in (H, 2.0 * H, -H, -2.0 * H))
        slope = (8.0 * (one - back) - (two - far)) / (12.0 * H)
        error = abs(slope + float((f * way).sum()))
        assert error < BOUND * size
