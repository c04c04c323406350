"""What central forces and velocity Verlet keep, on both engines: momenta to round-off per step, and the way back.

Seen to fail: with fix addforce 1e-14 (momenta), with fix viscous 1e-9 (the way back).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pylmp.engines.exact import Exact
from pylmp.engines.fast import Fast
from tests.support import simulate

STEPS = 200
BLOCK = """units lj
atom_style bond
boundary f f f
newton on off
comm_modify vel yes cutoff 3.0
special_bonds lj 0 1 1 coul 0 1 1
lattice sc 1.0 origin 0.5 0.5 0.5
region cell block -8 16 -8 16 -8 16 units box
region block block 0 5 0 5 0 5 units box
create_box 1 cell bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 40
create_atoms 1 region block
mass 1 1.0
displace_atoms all random 0.0625 0.0625 0.0625 817
pair_style zero 1.5
pair_coeff * *
create_bonds many all all 1 0.7 1.3
special_bonds lj 0 1 1 coul 1 1 1
{bond}
velocity all create 0.02 55 loop geom mom yes rot yes
fix 1 all nve
timestep 0.005
neigh_modify every 1 delay 0
thermo 1000
"""
PLASTIC = "bond_style bpm/spring/plastic\nbond_coeff 1 40 0.5 0.5 0.01"
HARMONIC = "special_bonds lj/coul 0 1 1\nbond_style harmonic\nbond_coeff 1 20 1.0"
ENGINES = pytest.mark.parametrize("engine", [Exact, Fast])


def block(bond: str) -> str:
    return BLOCK.format(bond=bond)


def by_tag(sim: object, name: str) -> np.ndarray:
    atoms = sim.atoms
    return getattr(atoms, name)[: atoms.n][np.argsort(atoms.tag[: atoms.n])].copy()


@ENGINES
@pytest.mark.parametrize("bond", [PLASTIC, HARMONIC], ids=["plastic", "harmonic"])
def test_momenta_and_the_sum_of_forces(engine: type, bond: str, tmp_path: Path) -> None:
    """Each step may lose half an ulp of every number that is added."""
    sim, _ = simulate(block(bond) + f"run {STEPS}\n", tmp_path, engine())
    x, v, f = (by_tag(sim, name) for name in "xvf")
    assert np.abs(f).max() > 0.1
    assert (np.abs(f.sum(axis=0)) <= 2.0**-52 * np.abs(f).sum(axis=0)).all()
    assert (np.abs(v.sum(axis=0)) <= 2.0**-53 * STEPS * np.abs(v).sum(axis=0)).all()
    arm = np.cross(x, v)
    assert (np.abs(arm.sum(axis=0)) <= 2.0**-53 * STEPS * np.abs(arm).sum(axis=0)).all()


@ENGINES
def test_the_way_back(engine: type, tmp_path: Path) -> None:
    """Velocity Verlet runs backwards: only round-off is left of it after as many steps with velocities turned around."""
    start, _ = simulate(block(HARMONIC) + "run 0\n", tmp_path, engine())
    turn = "".join(f"variable {d} atom -v{d}\n" for d in ("x", "y", "z")) + "velocity all set v_x v_y v_z\n"
    end, _ = simulate(block(HARMONIC) + f"run {STEPS}\n{turn}run {STEPS}\n", tmp_path, engine())
    assert np.abs(by_tag(end, "x") - by_tag(start, "x")).max() < 1e-12
    assert np.abs(by_tag(end, "v") + by_tag(start, "v")).max() < 1e-12
