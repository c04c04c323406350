"""Short runs of every mixture of styles against LAMMPS: thermo table and dumps, every digit."""

from __future__ import annotations

import numpy as np
import pytest

from tests.styles.test_store_local import thermo
from tests.support import frames, lammps, simulate

CELL = """units lj
atom_style bond
newton {newton}
comm_modify vel yes cutoff 2.8
special_bonds lj/coul 0 1 1
lattice sc 1.0
region cell block 0 6 0 5 0 6
create_box 2 cell bond/types 3 extra/bond/per/atom 8 extra/special/per/atom 40
create_atoms 1 box
displace_atoms all random 0.05 0.05 0.05 4711
set group all type/fraction 2 0.4 777
mass 1 1.0
mass 2 1.7
{pair}
group a type 1
group b type 2
create_bonds many a a 1 0.7 1.3
create_bonds many a b 2 0.7 1.3
create_bonds many b b 3 0.7 1.3
special_bonds {weights}
{bond}
velocity all create 2.0 87287 loop geom
fix 1 all nve
timestep 0.003
thermo 25
thermo_style custom step temp epair ebond etotal press pxx pyy pzz pxy pxz pyz bonds
thermo_modify format float "%.17g"
dump 1 all custom 50 atoms id type x y z vx vy vz fx fy fz
dump_modify 1 format float "%.17g"
{after}
"""
WCA = "pair_style lj/cut 1.2\npair_modify shift yes mix arithmetic\npair_coeff 1 1 1.0 1.0 1.1224620483093730\npair_coeff 2 2 1.3 0.95"
SPRING = "pair_style bpm/spring{}\npair_coeff * * 40 1.05 0.7{}"
Q = "1200 -0.55 0.25 1.3 34.6878"
P = "60.0 0.2 0.5 0.03"
HARMONIC = "bond_style harmonic\nbond_coeff * 50 1.0\nbond_coeff 3 70 0.95"
ONES, WEIGHTS = "lj/coul 1 1 1", "lj 0 1 1 coul 1 1 1"
LOCAL = (
    "compute b all bond/local dist engpot force fx fy fz dx dy dz\ncompute p all property/local btype batom1 batom2\n"
    'dump 2 all local 50 bonds index c_p[1] c_p[2] c_p[3] c_b[*]\ndump_modify 2 format float "%.17g"\n'
)

CASES = {
    "harmonic": ("on on", WCA, "lj/coul 0 1 1", HARMONIC, LOCAL + "run 150"),
    "harmonic off": ("off off", WCA, "lj/coul 0.5 1 1", HARMONIC, LOCAL + "run 150"),
    "zero": ("on off", WCA, "lj/coul 0 0.3 0.7", "bond_style zero nocoeff\nbond_coeff *", "run 100"),
    "no bond style": ("on on", WCA, ONES, "bond_style none", "run 100"),
    "harmonic and zero": (
        "on on", WCA, "lj/coul 0 1 1",
        "bond_style hybrid harmonic zero\nbond_coeff 1*2 harmonic 50 1.0\nbond_coeff 3 zero 1.0", "run 120\nrun 60",
    ),
    "plastic and quartic": (
        "on off", WCA, ONES,
        "bond_style hybrid bpm/spring/plastic overlay/pair yes smooth no quartic\n"
        f"bond_coeff 1 quartic {Q}\nbond_coeff 2*3 bpm/spring/plastic {P}", "run 120\nrun 80",
    ),
    "plastic and quartic, unbroken": (
        "on on", WCA, ONES,
        "bond_style hybrid quartic bpm/spring/plastic break no smooth no normalize yes\n"
        f"bond_coeff 1 quartic {Q}\nbond_coeff 2*3 bpm/spring/plastic {P}", "run 150",
    ),
    "quartic over nothing": ("off on", "pair_style zero 1.5\npair_coeff * *", ONES, f"bond_style quartic\nbond_coeff * {Q}", LOCAL + "run 150"),
    "quartic over springs": (
        "on on", SPRING.format("", ""), ONES, f"bond_style quartic\nbond_coeff * {Q}", LOCAL + "run 150",
    ),
    "quartic, tail": (
        "on on", "pair_style lj/cut 1.5\npair_modify tail yes\npair_coeff * * 1.0 1.0", ONES,
        f"bond_style quartic\nbond_coeff * {Q}", LOCAL + "run 100",
    ),
    "plastic over cubic springs": (
        "on off", SPRING.format(" anharmonic yes", " 90"), WEIGHTS, f"bond_style bpm/spring/plastic\nbond_coeff * {P}",
        LOCAL + "run 100\nbond_coeff 2 55 0.18 0.4 0.02\nrun 100",
    ),
    "plastic alone": (
        "on off", "pair_style none", WEIGHTS, f"bond_style bpm/spring/plastic\nbond_coeff * {P}", LOCAL + "run 100",
    ),
    "plastic declared again": (
        "off off", WCA, WEIGHTS, f"bond_style bpm/spring/plastic\nbond_coeff * {P}",
        f"velocity all scale 0.1\nrun 70\nbond_style bpm/spring/plastic normalize yes smooth no\nbond_coeff * {P}\nrun 70",
    ),
    "plastic, bonds counted between runs": (
        "off off", WCA, WEIGHTS, f"bond_style bpm/spring/plastic\nbond_coeff * {P}",
        "run 77\ndelete_bonds all stats\nrun 50\nwrite_data x.data\nrun 30\ndelete_bonds all bond 2 remove special\nrun 30",
    ),
    "unbroken without weights": (
        "on on", WCA, "lj/coul 0 0 0.5", f"bond_style bpm/spring/plastic break no smooth no\nbond_coeff * {P}", LOCAL + "run 100",
    ),
    "style and pair changed between runs": (
        "on on", WCA, ONES, f"bond_style quartic\nbond_coeff * {Q}",
        "run 60\nbond_style harmonic\nbond_coeff * 40 1.0\npair_style lj/cut 1.4\npair_coeff * * 1 1\nrun 60\npair_style lj/cut 1.3\nrun 40",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_same_run(name: str, tmp_path) -> None:
    newton, pair, weights, bond, after = CASES[name]
    first = WCA if pair == "pair_style none" else pair
    if first != pair:
        bond = pair + "\n" + bond
    script = CELL.format(newton=newton, pair=first, weights=weights, bond=bond, after=after)
    there = lammps(script, tmp_path / "lammps")
    assert there.code == 0, there.screen[-500:]
    _, screen = simulate(script, tmp_path / "pylmp")
    assert thermo(screen) == thermo(there.screen)
    for dump in ("atoms", "bonds"):
        if (tmp_path / "lammps" / dump).exists():
            assert (tmp_path / "pylmp" / dump).read_text() == (tmp_path / "lammps" / dump).read_text()


@pytest.mark.parametrize("name", ["quartic/breakable", "quartic/omp", "quartic/breakable/omp"])
def test_names_of_one_law(name: str, tmp_path) -> None:
    for folder, style in (("one", "quartic"), ("other", name)):
        bond = f"bond_style {style}\nbond_coeff * {Q}"
        simulate(CELL.format(newton="on on", pair=WCA, weights=ONES, bond=bond, after="run 50"), tmp_path / folder)
    assert (tmp_path / "one" / "atoms").read_text() == (tmp_path / "other" / "atoms").read_text()


def test_unbreakable_follows_lepton(tmp_path) -> None:
    """A pulled network whose bonds pass Rc and come back: trajectories part only by rounding. Beyond Rc the energy is U0."""
    k, b1, b2, rc, u0 = 100.0, -0.55, 0.25, 1.15, 3.0
    text = (
        f"({k}*(r-{rc})^2*(r-{rc}+{-b1})*(r-{rc}-{b2})*step({rc}-r)+{u0})"
        "+step(1.122462048309373-r)*(4*(1/r^12-1/r^6)+1)"
    )
    bonds = {
        "lammps": f'bond_style lepton no_offset\nbond_coeff * 0.0 "{text}"',
        "pylmp": f"bond_style quartic/unbreakable\nbond_coeff * {k} {b1} {b2} {rc} {u0}",
    }
    for folder, run in (("lammps", lammps), ("pylmp", simulate)):
        after = LOCAL + "run 60"
        run(
            CELL.format(newton="on on", pair=WCA, weights="lj/coul 0 1 1", bond=bonds[folder], after=after),
            tmp_path / folder,
        )
    for dump, least in (("atoms", 1e-9), ("bonds", 1e-9)):
        pairs = zip(frames(tmp_path / "lammps" / dump), frames(tmp_path / "pylmp" / dump), strict=True)
        for (step, names, there), (same, columns, here) in pairs:
            assert (step, names) == (same, columns)
            assert np.abs(here - there).max() <= least * np.abs(there).max()
    last = frames(tmp_path / "pylmp" / "bonds")[-1]
    dist, energy = last[2][:, 4], last[2][:, 5]
    assert (dist > rc).sum() > 10
    assert (energy[dist > rc] >= u0).all()
