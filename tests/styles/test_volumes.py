"""bond_style bpm/spring volume/factor yes: volumes of atoms in boxes of two and three dimensions, while bonds break and are made."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.setup.both import difference

NET = """units lj
atom_style bond
newton {newton}
comm_modify vel yes cutoff 3.5
dimension {dimension}
{lattice}
create_box 2 b bond/types 2 extra/bond/per/atom 30 extra/special/per/atom 80
create_atoms 1 box
mass * 1
displace_atoms all random 0.04 0.04 0 4711
pair_style lj/cut 1.3
pair_coeff * * 1 0.7
special_bonds lj/coul 0 1 1
create_bonds many all all 1 0.8 1.15
special_bonds lj {weights}
velocity all create 0.5 87287 loop geom
bond_style bpm/spring {words}volume/factor yes
bond_coeff * 60 {strain} 0.3 15.0
fix 1 all nve
thermo 5
thermo_style custom step pe ebond press pxx pyz bonds
thermo_modify norm no format float %.17g
run 10
run 10
"""
LATTICES = {
    2: "lattice sq 0.8\nregion b block 0 6 0 6 -0.1 0.1", 3: "lattice sc 0.8\nregion b block 0 4 0 4 0 4",
}  # fmt: skip
HOLDS, ALL = "0 1 1 coul 1 1 1", "1 1 1 coul 1 1 1"
CASES = [
    ("on off", HOLDS, "", 0.08), ("on off", HOLDS, "normalize yes smooth no ", 0.08), ("on on", ALL, "overlay/pair yes ", 0.08),
    ("on off", HOLDS, "break no smooth no ", 0.3), ("on on", HOLDS, "break no smooth no ", 0.3),
]  # fmt: skip


@pytest.mark.parametrize("dimension", LATTICES)
@pytest.mark.parametrize(("newton", "weights", "words", "strain"), CASES)
def test_breaking(dimension: int, newton: str, weights: str, words: str, strain: float, tmp_path: Path) -> None:
    script = NET.format(**locals(), lattice=LATTICES[dimension])
    assert difference(script, tmp_path) == ""


@pytest.mark.parametrize("new", ["single/bond 2 1 22", "many all all 2 1.2 1.6"])
@pytest.mark.parametrize("newton", ["on off", "on on"])
def test_new_bonds_change_the_volumes_of_the_beginning(new: str, newton: str, tmp_path: Path) -> None:
    script = NET.format(
        newton=newton, weights=HOLDS, words="break no smooth no ", strain=0.3, dimension=3, lattice=LATTICES[3]
    )
    assert difference(f"{script}special_bonds lj/coul 0 1 1\ncreate_bonds {new}\nrun 10\n", tmp_path) == ""
