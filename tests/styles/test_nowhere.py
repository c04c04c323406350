"""Two atoms at one place fly to where numbers end; nobody else does, in LAMMPS as in pylmp."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.setup.both import difference

SCRIPT = """units lj
atom_style atomic
newton {newton}
lattice sc 0.8
region b block 0 4 0 4 0 4
create_box 1 b
create_atoms 1 box
create_atoms 1 single 2 2 2
mass * 1
pair_style {pair}
velocity all create 1.4 87287 loop geom
fix 1 all nve
thermo_modify format float %.17g lost warn
thermo 1
run 4 post no
"""
PAIRS = ("lj/cut 1.5\npair_coeff * * 1 1", "soft 1.3\npair_coeff * * 3", "morse 1.5\npair_coeff * * 3 2 1.1")


@pytest.mark.parametrize("newton", ["on", "off"])
@pytest.mark.parametrize("pair", PAIRS)
def test_two_atoms_at_one_place(pair: str, newton: str, tmp_path: Path) -> None:
    assert not difference(SCRIPT.format(pair=pair, newton=newton), tmp_path)
