"""Records of broken bonds: the rows LAMMPS writes, in its order, over several runs and intervals."""

from __future__ import annotations

import pytest

from tests.support import lammps, simulate

BLOCK = """units lj
atom_style bond
newton on off
comm_modify vel yes cutoff 2.6
special_bonds lj/coul 0 1 1
lattice fcc 1.0
region cell block 0 3 0 3 0 3
create_box 2 cell bond/types 2 extra/bond/per/atom 20 extra/special/per/atom 60
create_atoms 1 box
displace_atoms all random 0.06 0.06 0.06 4711
mass * 1.0
pair_style bpm/spring
pair_coeff * * 30.0 1.1 0.5
create_bonds many all all 1 0.8 1.3
special_bonds {weights}
{before}
bond_style bpm/spring/plastic {options}
bond_coeff * 60.0 0.12 0.5 0.03
velocity all create 1.5 87287 loop geom
fix 1 all nve
timestep 0.004
thermo 20
thermo_style custom step temp bonds press
{after}
"""
FULL = "id1 id2 time x y z x/ref y/ref z/ref"
COLUMNS = " ".join(f"f_brk[{k}]" for k in range(1, 10))
MODIFY = 'dump_modify 9 format float "%.17g"'
WEIGHTS = "lj 0 1 1 coul 1 1 1"

CASES = {
    "every attribute": (
        WEIGHTS, "", f"store/local brk 10 {FULL}",
        f"dump 9 all local 10 broken {COLUMNS}\n{MODIFY}\nrun 95\nrun 0\nrun 65",
    ),
    "one attribute": (
        WEIGHTS, "", "smooth no store/local brk 5 id2 normalize yes",
        f"dump 9 all local 20 broken f_brk\n{MODIFY}\nrun 130",
    ),
    "overlay": (
        "lj/coul 1 1 1", "", "overlay/pair yes store/local brk 20 time id1 id2",
        f"dump 9 all local 20 broken f_brk[3] f_brk[2] f_brk[1]\n{MODIFY}\nrun 133\nundump 9\nreset_timestep 7\ndump 9 all local 20 broken2 f_brk[3] f_brk[1]\nrun 60",
    ),
    "later atoms have no reference": (
        WEIGHTS, "", f"store/local brk 10 {FULL}",
        "create_atoms 1 single 0.7 0.7 0.3\ncreate_bonds single/bond 1 109 1\nvelocity all create 1.5 87287 loop geom\n"
        f"dump 9 all local 10 broken {COLUMNS}\n{MODIFY}\nrun 100",
    ),
    "styles given twice": (
        WEIGHTS, "bond_style bpm/spring/plastic store/local brk 7 time id1 x/ref y/ref\nbond_coeff * 60.0 0.12 0.5 0.03\nrun 0",
        "store/local brk 10 x/ref id1", f"dump 9 all local 10 broken f_brk[1] f_brk[2]\n{MODIFY}\nrun 100",
    ),
    "reduced in thermo": (
        WEIGHTS, "", "store/local brk 10 time id1",
        "compute last all reduce max f_brk[1] inputs local\n"
        "thermo_style custom step temp bonds c_last\nrun 100",
    ),
}  # fmt: skip


def thermo(log: str) -> list[str]:
    """The lines of numbers of the thermo tables."""
    return [line for line in log.splitlines() if line.split() and all(w[0] in "-0123456789" for w in line.split())]


@pytest.mark.parametrize("name", CASES)
def test_same_rows(name: str, tmp_path) -> None:
    weights, before, options, after = CASES[name]
    script = BLOCK.format(weights=weights, before=before, options=options, after=after)
    there = lammps(script, tmp_path / "lammps")
    assert there.code == 0, there.screen[-500:]
    _, screen = simulate(script, tmp_path / "pylmp")
    assert thermo(screen) == thermo(there.screen)
    for dump in (tmp_path / "lammps").glob("broken*"):
        assert (tmp_path / "pylmp" / dump.name).read_text() == dump.read_text()
        assert len(dump.read_text().splitlines()) > 50


def test_a_record_in_the_manuals_form_is_the_same(tmp_path) -> None:
    """bond_style bpm/spring/plastic brk 10 time id1 id2, as the manual's example leaves store/local out: a warning, the same rows."""
    after = f"dump 9 all local 10 broken f_brk[1] f_brk[2] f_brk[3]\n{MODIFY}\nrun 60"
    texts, screens = [], []
    for folder, options in (("release", "store/local brk 10 time id1 id2"), ("manual", "brk 10 time id1 id2")):
        script = BLOCK.format(weights=WEIGHTS, before="", options=options, after=after)
        screens.append(simulate(script, tmp_path / folder)[1])
        texts.append((tmp_path / folder / "broken").read_text())
    assert texts[0] == texts[1]
    assert "[D001]" in screens[1]
    assert "[D001]" not in screens[0]
