"""Scenes for the fast engine: small boxes of atoms and bonds, with what a force field needs."""

from __future__ import annotations

import random

CELL = """units lj
dimension {dimension}
atom_style bond
boundary {boundary}
newton {newton}
comm_modify vel yes cutoff 3.0
lattice {lattice}
region cell block 0 {nx} 0 {ny} {nz}
create_box 2 cell bond/types 2 extra/bond/per/atom 24 extra/special/per/atom 90
{region}
mass 1 1.0
mass 2 1.7
set group all type/fraction 2 {second} 16326
displace_atoms all random 0.04 0.04 {dz} 1569
special_bonds lj 0 1 1 coul 0 1 1
neighbor 0.3 bin
pair_style zero 1.7
pair_coeff * *
create_bonds many all all 1 0.5 1.35
group two type 2
create_bonds many two two 2 1.35 1.6
"""
TAIL = """velocity all create {heat} 12334 loop geom
fix 1 all nve
{flat}timestep 0.004
neigh_modify every 1 delay 0 check yes
thermo 10
thermo_style custom step temp epair ebond press pxx pyy pzz pxy pxz pyz bonds
thermo_modify lost ignore lost/bond ignore
"""
PAIRS = {
    "lj": "pair_style lj/cut 1.3\npair_modify shift yes\npair_coeff 1 1 1.0 0.95\npair_coeff 2 2 0.8 0.9\n",
    "spring": "pair_style bpm/spring\npair_coeff * * 20.0 1.0 0.4\npair_coeff 2 2 10.0 1.1 0.2\n",
    "soft": "pair_style soft 1.2\npair_coeff * * 12.0\n",
    "morse": "pair_style morse 1.5\npair_coeff * * 1.0 3.0 1.0\n",
    "none": "pair_style zero 1.2\npair_coeff * *\n",
}
BONDS = {
    "quartic": "special_bonds lj/coul 1 1 1\nbond_style quartic\nbond_coeff 1 1200 -0.55 0.25 1.45 34.6878\nbond_coeff 2 900 -0.55 0.25 1.65 30\n",
    "plastic": "special_bonds lj 0 1 1 coul 1 1 1\nbond_style bpm/spring/plastic normalize yes\nbond_coeff 1 60 0.15 0.8 0.02\nbond_coeff 2 26 0.25 0.5 0.05\n",
    "overlaid": "special_bonds lj/coul 1 1 1\nbond_style bpm/spring/plastic overlay/pair yes smooth no\nbond_coeff * 60 0.12 0.8 0.02\n",
    "spring": "special_bonds lj 0 1 1 coul 1 1 1\nbond_style bpm/spring\nbond_coeff 1 60 0.15 0.8\nbond_coeff 2 26 0.25 0.5\n",
    "harmonic": "special_bonds lj/coul 0 1 1\nbond_style harmonic\nbond_coeff * 40 1.1\n",
    "fene": "special_bonds fene\nbond_style fene\nbond_coeff 1 20 1.6 1.0 0.9\nbond_coeff 2 20 1.9 1.0 1.0\n",
    "morse": "special_bonds lj/coul 0 1 1\nbond_style morse\nbond_coeff * 20 2.0 1.1\n",
}  # fmt: skip


def script(pair: str, bond: str, flat: bool = False, boundary: str = "p p p", newton: str = "on off", heat: float = 1.0, seed: int = 0) -> str:
    """A box of some hundred atoms, wide enough for the fast engine."""
    dice = random.Random(seed)
    n = [dice.randint(6, 8) for _ in range(3)]
    if flat:
        n = [3 * m for m in n]
    inside = f"region in block 0.6 {n[0] - 0.9} 0.6 {n[1] - 0.9} {'INF INF' if flat else f'0.6 {n[2] - 0.9}'}\ncreate_atoms 1 region in"
    head = CELL.format(
        dimension=2 if flat else 3, boundary=boundary, newton=newton, lattice="hex 1.0" if flat else "sc 1.0", nx=n[0], ny=n[1],
        nz="-0.5 0.5" if flat else f"0 {n[2]}", region="create_atoms 1 box" if boundary == "p p p" else inside,
        second=dice.choice((0.0, 0.4)), dz="0.0" if flat else "0.04",
    )  # fmt: skip
    return head + PAIRS[pair] + BONDS[bond] + TAIL.format(heat=heat, flat="fix 2 all enforce2d\n" if flat else "")
