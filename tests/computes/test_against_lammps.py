"""Every compute against LAMMPS, as thermo columns, per-atom dumps and local dumps: the same numbers."""

from __future__ import annotations

import pytest

from tests.fixes.twins import compare

VALUES = "dist dx dy dz engpot force fx fy fz engvib engrot engtrans omega velvib"
NETWORK = """units lj
atom_style bond
newton {newton}
comm_modify vel yes cutoff 3.5
lattice sc 0.9
region b block 0 {size} 0 {size} 0 {size}
create_box 2 b bond/types 2 extra/bond/per/atom 14 extra/special/per/atom 30
create_atoms 1 box
set group all type/fraction 2 0.4 4711
mass 1 1.0
mass 2 2.5
group odd id 1:1000:2
group two type 2
group few id 1:40
group none empty
pair_style {pair}
displace_atoms all random 0.05 0.05 0.05 47
special_bonds lj/coul 0 1 1
create_bonds many all all 1 0.1 1.2
create_bonds many few few 2 0.1 1.01
special_bonds {special}
bond_style {style}
velocity all create {heat} 4711
timestep 0.004
fix 1 all nve
compute bl all bond/local {values}
compute bo odd bond/local dist engpot
compute pl all property/local batom1 batom2 btype
compute pt two property/local btype
compute nb all nbond/atom
compute nt two nbond/atom bond/type 2
"""
COMPUTES = {
    "cb": "all count/type bond", "ca": "all count/type atom", "cf": "few count/type bond", "t2": "two temp", "k2": "two ke",
    "p2": "all pressure t2", "p3": "all pressure NULL virial", "p4": "all pressure NULL bond",
    "p5": "all pressure thermo_temp ke", "e2": "all pe bond", "e3": "all pe pair", "n1": "none temp", "n2": "none ke",
    "rs": "all reduce sum c_nb c_nt x vx fz", "rm": "all reduce max c_nb c_nt x vx fz",
    "ri": "two reduce min c_nb c_nt x vx fz", "ra": "few reduce ave c_nb c_nt x vx fz",
    "rq": "few reduce sumsq c_nb c_nt x vx fz", "rv": "few reduce avesq c_nb c_nt x vx fz", "rb": "few reduce sumabs x",
    "rc": "few reduce aveabs vx", "rd": "few reduce maxabs vx vy fz", "re": "few reduce minabs vx vy",
    "rf": "few reduce aveabs x vx", "rl": "all reduce sum c_bl[*] inputs local", "ro": "all reduce max c_bo[*] inputs local",
    "rt": "all reduce ave c_pt inputs local", "r1": "all reduce max x y vz c_nb replace 3 1 replace 4 2",
    "r2": "two reduce min x y vz c_nb replace 3 1", "r3": "all reduce min c_bl[1] c_bl[5] c_pl[1] replace 3 1 inputs local",
    "ea": "all pe/atom", "eb": "two pe/atom bond", "sa": "all stress/atom NULL", "sb": "odd stress/atom t2 virial",
    "rz": "all reduce sum c_ea c_eb c_sa[1] c_sa[4] c_sb[6]",
    "r4": "none reduce max x y", "r5": "none reduce min x", "r6": "none reduce ave x y", "r7": "none reduce sum x y",
}  # fmt: skip
SCALARS = "cb t2 k2 p2 p3 p4 p5 e2 e3 n1 n2 rb rc rt r5".split()
VECTORS = "cb ca cf t2 p2 p3 rs rm ri ra rq rv rd re rf rl ro rz r1 r2 r3 r4 r6 r7".split()
OUTPUT = """
thermo 5
thermo_style custom step temp pe ke etotal press pxx pyz vol bonds {columns}
thermo_modify format float %.17g lost/bond ignore
dump d all custom 10 d.all id type x y z vx vy vz fx fy fz ix iy iz c_nb c_nt c_ea c_eb c_sa[*] c_sb[*]
dump_modify d format float %.17g
dump l all local 5 d.local c_pl[*] c_bl[*]
dump_modify l format float %.17g
dump o odd local 10 d.odd c_bo[*]
dump_modify o format float %.17g
"""
PLASTIC = "\nbond_coeff 1 50 0.3 0.5 0.02\nbond_coeff 2 70 0.3 0.5 0.05"
QUARTIC = "quartic\nbond_coeff * 1200 -0.55 0.25 1.3 34.6878"
LJ, SPRING = "lj/cut 2.0\npair_coeff * * 1.0 1.0", "bpm/spring\npair_coeff * * 20.0 1.1 1.0"
BPM, ONES = "lj 0 1 1 coul 1 1 1", "lj/coul 1 1 1"


def network(
    newton: str, style: str, heat: float, pair: str = LJ, special: str = BPM, size: int = 6, more: str = "",
    runs: str = "run 40\nrun 45",
) -> str:  # fmt: skip
    """A bonded crystal measured by every compute. more: b1 b2 of bond/local."""
    start = NETWORK.format(
        newton=newton, style=style, heat=heat, pair=pair, special=special, size=size, values=f"{VALUES} {more}"
    )
    computes = "".join(f"compute {name} {words}\n" for name, words in COMPUTES.items())
    columns = " ".join([*(f"c_{name}" for name in SCALARS), *(f"c_{name}[*]" for name in VECTORS)])
    return start + computes + OUTPUT.format(columns=columns) + runs + "\n"


SCENES = {
    "harmonic, newton on": network("on on", "harmonic\nbond_coeff * 30.0 1.05", 1.3, size=5),
    "harmonic, newton off": network("on off", "harmonic\nbond_coeff * 30.0 1.05", 1.3, size=5),
    "quartic, newton on": network("on on", QUARTIC, 0.3, special=ONES),
    "quartic, newton off": network("off off", QUARTIC, 1.3, special=ONES),
    "plastic": network("on off", f"bpm/spring/plastic smooth no{PLASTIC}", 1.5, SPRING, more="b1 b2"),
    "plastic normalized": network("off off", f"bpm/spring/plastic normalize yes{PLASTIC}", 2.5, SPRING, more="b1 b2"),
    "plastic overlaid": network(
        "on on", f"bpm/spring/plastic overlay/pair yes{PLASTIC}", 2.5, SPRING, ONES, more="b1 b2"
    ),
    "hybrid": network(
        "on off",
        "hybrid quartic bpm/spring/plastic overlay/pair yes\nbond_coeff 1 quartic 1200 -0.55 0.25 1.3 34.6878\n"
        "bond_coeff 2 bpm/spring/plastic 50 0.3 0.5 0.02",
        2.0, special=ONES, more="b1 b2",
    ),  # fmt: skip
}


@pytest.mark.parametrize("name", SCENES)
def test_same_numbers(name: str, tmp_path) -> None:
    compare(SCENES[name], tmp_path)


def test_bonds_turned_off(tmp_path) -> None:
    """They keep their rows in local output; nbond/atom does not count them. Where LAMMPS prints stray memory, nothing is compared."""
    script = network("on off", "harmonic\nbond_coeff * 30.0 1.05", 1.3, size=5)
    script = script.replace("compute pl all", "group off id 3:20\ndelete_bonds off bond 1 any\ncompute pl all")
    script = script.replace(VALUES, "dist dx dy dz dist engvib engrot engtrans omega velvib")
    script = script.replace("compute bo odd bond/local dist engpot", "compute bo odd bond/local dist velvib")
    compare(script, tmp_path)
