"""Small scripts for the tests of diff, and a run of it."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

LIQUID = """units lj
lattice fcc 0.8442
region cell block 0 3 0 3 0 3
create_box 1 cell
create_atoms 1 box
mass 1 1.0
displace_atoms all random 0.1 0.1 0.1 9213 units box
velocity all create {temp} {seed} loop geom
pair_style lj/cut 2.5
pair_coeff 1 1 {epsilon} 1.0 2.5
{before}
timestep {dt}
fix 1 all nve
{fixes}
thermo 10
run {steps}
"""


def liquid(**changes: object) -> str:
    words = {"temp": 1.44, "seed": 87287, "epsilon": 1.0, "before": "", "dt": 0.005, "fixes": "", "steps": 200}
    return LIQUID.format(**{**words, **changes})


# the ends of a bond move at constant velocity: x = 1.1 + speed * time, without forces
BREAK = """units lj
atom_style bond
newton on on
special_bonds lj/coul 1 1 1
region cell block -20 20 -20 20 -20 20
create_box 1 cell bond/types 1 extra/bond/per/atom 2 extra/special/per/atom 4
create_atoms 1 single 0 0 0 units box
create_atoms 1 single 1.125 0 0 units box
mass 1 1.0
pair_style zero 3.0
pair_coeff * *
special_bonds lj/coul 1 1 1
create_bonds single/bond 1 1 2
bond_style quartic
bond_coeff 1 1200 -0.55 0.25 {limit} 34.6878
group right id 2
fix 1 right move linear 0.25 0 0
timestep 0.0625
thermo 1
run 20
"""


def diff(*words: str | Path) -> dict:
    """The JSON report of pylmp diff; its exit code is that of the verdict."""
    done = subprocess.run(
        [sys.executable, "-m", "pylmp", "diff", *map(str, words), "--json"], capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.stdout, done.stderr
    report = json.loads(done.stdout)
    assert done.returncode == {"identical": 0, "round-off": 0, "drift": 4, "different": 4}[report["verdict"]], (
        done.stderr
    )
    return report


def scripts(folder: Path, *texts: str) -> list[Path]:
    """The texts as scripts in folders of their own."""
    result = []
    for k, text in enumerate(texts):
        (folder / f"f{k}").mkdir()
        result.append(folder / f"f{k}" / f"in.s{k}")
        result[-1].write_text(text)
    return result
