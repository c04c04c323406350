"""Variants of three scenes, each at least 1000 steps with breaking and rebuilding, compared with LAMMPS to the last bit."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.oracle.test_decks import diff, failures

QUARTIC = """
units lj
atom_style bond
newton {newton}
boundary {boundary}
special_bonds lj/coul 0 1 1
lattice sc 1.0
region cell block 0 7 0 6 0 7
create_box 2 cell bond/types 2 extra/bond/per/atom 6 extra/special/per/atom 30
create_atoms 1 box
mass * 1.0
set group all type/fraction 2 0.3 9213
mass 2 1.6
displace_atoms all random 0.05 0.05 0.05 4711
pair_style lj/cut 1.2
pair_modify shift yes
pair_coeff * * 1.0 1.0 1.122462048309373
group soft type 2
create_bonds many soft soft 2 0.85 1.15
create_bonds many all all 1 0.85 1.15
special_bonds lj/coul 1 1 1
bond_style quartic
bond_coeff 1 1200 -0.55 0.25 1.3 34.6878
bond_coeff 2 900 -0.55 0.25 1.25 30.0
velocity all create 9.0 87287 loop geom
fix 1 all nve
{fixes}
timestep 0.002
neighbor 0.4 bin
neigh_modify {neigh}
atom_modify sort {sort} 0.0
thermo 50
thermo_style custom step temp ke pe epair ebond etotal press pxx pyy pzz pxy pxz pyz vol lx bonds
dump 1 all custom 200 q.dump id type x y z ix iy iz
run 430
run 670
delete_bonds all stats
"""

PLASTIC = """
units lj
atom_style bond
dimension {dimension}
newton {newton}
boundary {boundary}
comm_modify vel yes cutoff 2.6
special_bonds lj 0 1 1 coul 0 1 1
lattice {lattice} 1.0
region cell block 0 {cells} 0 {cells} {depth}
create_box 1 cell bond/types 2 extra/bond/per/atom 12 extra/special/per/atom 60
create_atoms 1 box
mass 1 1.0
displace_atoms all random 0.03 0.03 {dz} 77
pair_style bpm/spring
pair_coeff 1 1 12.0 1.0 0.5
create_bonds many all all 1 0.8 1.25
special_bonds {special}
bond_style bpm/spring/plastic store/local broken 50 time id1 id2 {options}
bond_coeff * {coefficients}
velocity all create {temperature} 4321 loop geom
fix 1 all nve
{fixes}
timestep 0.01
neigh_modify {neigh}
thermo 50
thermo_style custom step temp ke pe etotal press pxx pyy pzz pxy pxz pyz vol lx bonds
dump 1 all local 100 p.broken f_broken[1] f_broken[2] f_broken[3]
dump 2 all custom 200 p.dump id type x y z ix iy iz
run 330
run 770
delete_bonds all stats
"""

DEFAULT_Q = {"newton": "on on", "boundary": "p p p", "fixes": "", "neigh": "every 1 delay 0 check yes", "sort": 1000}
DEFAULT_P = {
    "newton": "on off", "boundary": "p p p", "fixes": "", "neigh": "every 1 delay 0 check yes", "dimension": 3,
    "lattice": "fcc", "cells": 4, "depth": "0 4", "dz": 0.03, "options": "", "special": "lj 0 1 1 coul 1 1 1",
    "coefficients": "40.0 0.2 0.4 0.05", "temperature": 2.0,
}  # fmt: skip
FLAT = {"dimension": 2, "lattice": "hex", "cells": 12, "depth": "-0.5 0.5", "dz": 0.0, "fixes": "fix 9 all enforce2d"}

QUARTIC_VARIANTS = {
    "plain": {},
    "newton on off": {"newton": "on off"},
    "newton off on": {"newton": "off on"},
    "newton off off": {"newton": "off off"},
    "every 2 delay 4": {"neigh": "every 2 delay 4 check yes"},
    "every 5 no check": {"neigh": "every 5 delay 0 check no"},
    "delay 20": {"neigh": "every 20 delay 20 check yes"},
    "langevin": {"fixes": "fix 2 all langevin 4.0 14.0 0.8 48271"},
    "sort often": {"sort": 200},
    "no sort": {"sort": 0},
    "deform": {"fixes": "fix 2 all deform 1 x erate 0.1 y scale 0.95 z final 0 6.5 units box remap x"},
    "shrink": {"boundary": "s p m"},
}
PLASTIC_VARIANTS = {
    "plain": {},
    "newton off off": {"newton": "off off"},
    "every 2 delay 4": {"neigh": "every 2 delay 4 check yes"},
    "every 5 no check": {"neigh": "every 5 delay 0 check no"},
    "no smoothing": {"options": "smooth no normalize yes"},
    "overlay": {"options": "overlay/pair yes", "special": "lj/coul 1 1 1", "newton": "on on"},
    "unbroken": {"options": "break no smooth no", "newton": "on on", "temperature": 1.5},
    "langevin": {"fixes": "fix 2 all langevin 1.0 5.0 1.5 771"},
    "drag and pull": {"fixes": "fix 2 all viscous 0.1\nfix 3 all addforce 0.02 0.0 -0.01"},
    "flat": FLAT,
    "flat, shrink": FLAT | {"boundary": "s s p"},
    "flat, newton off off": FLAT | {"newton": "off off", "boundary": "s p p"},
    "flat, deform": FLAT | {"fixes": "fix 9 all enforce2d\nfix 2 all deform 5 x erate 0.02 remap x"},
}
SCENES = [(QUARTIC, DEFAULT_Q, name, change) for name, change in QUARTIC_VARIANTS.items()] + [
    (PLASTIC, DEFAULT_P, name, change) for name, change in PLASTIC_VARIANTS.items()
]


@pytest.mark.parametrize(
    ("scene", "settings", "name", "change"),
    SCENES,
    ids=[("quartic, " if scene is QUARTIC else "plastic, ") + name for scene, _, name, _ in SCENES],
)
def test_identical(scene: str, settings: dict, name: str, change: dict, tmp_path: Path) -> None:
    script = tmp_path / "in.variant"
    script.write_text(scene.format(**(settings | change)))
    report = diff(script)
    assert report["verdict"] == "identical", failures(report)
