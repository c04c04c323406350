"""Two atoms on LAMMPS: what acts between them, to the last bit."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from tests.support import lammps

SETUP = """units lj
atom_style bond
atom_modify sort 0 0.0
newton on {newton}
comm_modify vel yes cutoff 6.0
region b block 0 30 0 30 0 30
create_box 2 b bond/types 1 extra/bond/per/atom 2 extra/special/per/atom 4
create_atoms 1 single 10 10 10
create_atoms 2 single 11 10 10
mass * 1.0
special_bonds lj/coul 1 1 1
{commands}
fix 1 all nve
timestep 1.0e-20
thermo_modify norm no
"""


def shifts(count: int, low: float, high: float, seed: int = 1) -> np.ndarray:
    """(count, 3) displacements of the second atom, lengths from low to high in no order, all directions."""
    random = np.random.default_rng(seed)
    d = random.normal(size=(count, 3))
    return d / np.linalg.norm(d, axis=1)[:, None] * random.uniform(low, high, count)[:, None]


def measure(
    commands: str, places: np.ndarray, v: Sequence[float], folder: Path, *, newton: str = "on"
) -> dict[str, np.ndarray]:
    """Move atom 2 to 10 + each place in turn, at velocity v, without a step in between.

    Returns d (n, 3) x1 - x2 in doubles, dot (n,), force on atom 1 (n, 3), epair, ebond (n,).
    """
    at = 10.0 + places
    lines = [SETUP.format(commands=commands, newton=newton)]
    lines += [f"set atom 2 {k} {x!r}" for k, x in zip(("vx", "vy", "vz"), map(float, v), strict=True)]
    for x, y, z in at.tolist():
        lines += [
            f"set atom 2 x {x!r} y {y!r} z {z!r}", "run 0 post no",
            'print "@ $(fx[1]:%.17g) $(fy[1]:%.17g) $(fz[1]:%.17g) $(epair:%.17g) $(ebond:%.17g)"',
        ]  # fmt: skip
    outcome = lammps("\n".join(lines) + "\n", folder, "-log", "none")
    assert outcome.code == 0, outcome.screen[-600:]
    found = re.findall(r"^@ (.*)$", outcome.screen, re.M)
    rows = np.array([[float(word) for word in row.split()] for row in found])
    d = np.array([10.0, 10.0, 10.0]) - at
    speed = -np.array(v, float)
    dot = d[:, 0] * speed[0] + d[:, 1] * speed[1] + d[:, 2] * speed[2]
    return {"d": d, "dot": dot, "force": rows[:, :3], "epair": rows[:, 3], "ebond": rows[:, 4]}


def squared(d: np.ndarray) -> np.ndarray:
    return d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]
