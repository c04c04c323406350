"""One script on LAMMPS and on pylmp: equal thermo rows, warnings and dump files, every digit."""

from __future__ import annotations

import re
from pathlib import Path

from tests.support import lammps, simulate

CRYSTAL = """units lj
atom_style bond
dimension {dim}
newton on {bond}
boundary {faces}
comm_modify vel yes cutoff 3.0
lattice {lattice}
region b block 0 5 0 5 {thick}
create_box 2 b bond/types 2 extra/bond/per/atom 4 extra/special/per/atom 10
create_atoms 1 box
set group all type/fraction 2 0.4 4711
mass 1 1.0
mass 2 2.5
group odd id 1:1000:2
group two type 2
pair_style lj/cut 1.5
pair_coeff * * 1.0 1.0
velocity all create 1.3 4711
timestep 0.004
"""
OUTPUT = """
thermo 5
thermo_style custom step temp pe ke etotal press pxx pyy pzz pxy pxz pyz vol lx ly xlo xhi {columns}
thermo_modify format float %.17g
dump d all custom 10 d.all id type x y z vx vy vz fx fy fz ix iy iz
dump_modify d format float %.17g
"""


def scene(
    fixes: str, columns: str = "", runs: str = "run 60\nrun 60", dim: int = 3, bond: str = "off", faces: str = "p p p"
) -> str:
    """A moving crystal of two types of atoms under these fixes; columns: more of the thermo table."""
    lattice, thick = ("sc 0.8", "0 5") if dim == 3 else ("sq 0.8", "-0.5 0.5")
    crystal = CRYSTAL.format(dim=dim, bond=bond, lattice=lattice, thick=thick, faces=faces)
    return f"{crystal}{fixes}\n{OUTPUT.format(columns=columns)}{runs}\n"


def rows(screen: str) -> list[str]:
    """Lines that begin with a number: thermo rows above all."""
    return re.findall(r"^ +\d.*$", screen, re.M)


def warnings(screen: str) -> list[str]:
    return [line.split(" (src/")[0] for line in screen.splitlines() if "WARNING" in line]


def compare(script: str, folder: Path, least: int = 10) -> None:
    """least: so many rows at least, so that nothing is compared with nothing."""
    theirs = lammps(script, folder / "lammps")
    assert theirs.code == 0, theirs.screen[-500:]
    _, screen = simulate(script, folder / "pylmp")
    assert len(rows(theirs.screen)) >= least
    for one, other in zip(rows(theirs.screen), rows(screen), strict=True):
        assert one == other, [pair for pair in zip(one.split(), other.split(), strict=False) if pair[0] != pair[1]]
    assert warnings(theirs.screen) == warnings(screen)
    dumps = sorted((folder / "lammps").glob("d.*"))
    assert dumps
    for path in dumps:
        assert path.read_bytes() == (folder / "pylmp" / path.name).read_bytes(), path.name
