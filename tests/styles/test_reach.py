"""How far LAMMPS believes bonds to reach: ghosts without a pair style, warnings with one."""

from __future__ import annotations

import re

import pytest

from tests.styles.test_errors import BOX
from tests.support import lammps, simulate

START = (
    BOX.format(newton="off")
    .replace("comm_modify vel yes cutoff 3.0", "comm_modify vel yes")
    .replace("create_atoms 2 single 3.0 3 3", "create_atoms 2 single 2.0 0.5 3")
)
BOND = "create_bonds single/bond 1 1 2; "
WEIGHTS = "special_bonds lj 0 1 1 coul 1 1 1; "
HARMONIC = "bond_style harmonic; bond_coeff 1 1 2.2; bond_coeff 2 1 1.1; "
PLASTIC = "bond_style bpm/spring/plastic; bond_coeff * 1 .3 .1 .1; bond_coeff 1 1 .2 .1 .1; "
PAIR = "pair_style lj/cut 1; pair_coeff * * 1 1; "
CASES = {
    "quartic": "special_bonds lj/coul 1 1 1; " + PAIR + "bond_style quartic; bond_coeff * 1 2 3 4 5; ",
    "harmonic, no bonds": HARMONIC,
    "harmonic, no pair style": BOND + HARMONIC,
    "harmonic": PAIR + BOND + HARMONIC,
    "harmonic, pair style, no bonds": PAIR + HARMONIC,
    "zero": PAIR + BOND + "bond_style zero; bond_coeff 1 1.9; bond_coeff 2; ",
    "hybrid": PAIR + BOND + "bond_style hybrid zero harmonic; bond_coeff 1 zero 1.9; bond_coeff 2 harmonic 1 1.7; ",
    "plastic, no pair style": WEIGHTS + BOND + PLASTIC,
    "plastic": PAIR + WEIGHTS + BOND + PLASTIC,
    "plastic, unbreakable": PAIR + BOND + PLASTIC.replace(";", " break no smooth no;", 1),
    "nothing": "bond_style none; ",
}


def told(text: str) -> list[str]:
    """Warnings, cutoffs and numbers of ghosts, in order."""
    lines = [line.split(" (src")[0] for line in text.splitlines()]
    return [line for line in lines if re.match(r"WARNING|Nghost|  ghost atom cutoff|  master list", line)]


@pytest.mark.parametrize("name", CASES)
def test_same_reach(name: str, tmp_path) -> None:
    script = START + (CASES[name] + "fix 1 all nve; run 1").replace("; ", "\n") + "\n"
    there = lammps(script, tmp_path / "lammps")
    assert there.code == 0, there.screen[-300:]
    assert told(simulate(script, tmp_path / "pylmp")[1]) == told(there.screen)
