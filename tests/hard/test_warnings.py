"""What LAMMPS passes in silence is said on the screen, and --strict is silent."""

from __future__ import annotations

import math
import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.hard.pair import PAIR

DIMER = PAIR + """bond_style {bond}
bond_coeff 1 {coeff}
fix 1 all nve
timestep {dt}
thermo {every}
neigh_modify delay 0 every {every} check no
run {steps}
"""


def run(folder: Path, *switches: str, **words: object) -> subprocess.CompletedProcess[str]:
    (folder / "in.script").write_text(DIMER.format(**{"every": 10, "steps": 20, **words}))
    return subprocess.run([sys.executable, "-m", "pylmp", *switches, "in.script"], cwd=folder, capture_output=True, text=True, timeout=120)


@pytest.mark.parametrize("engine", ["exact", "fast"])
@pytest.mark.parametrize(("bond", "coeff", "k"), [("harmonic", "50 1.0", 100.0), ("bpm/spring/plastic", "100 0.3 0.5 0.02", 100.0)])
def test_a_timestep_too_long_for_a_bond(tmp_path: Path, engine: str, bond: str, coeff: str, k: float) -> None:
    """omega = sqrt(k/mu), mu = 1."""
    said = run(tmp_path, "--engine", engine, bond=bond, coeff=coeff, dt=0.02).stdout
    found = re.search(r"bond type 1 \((\S+)\) swings with omega = (\S+), omega dt = (\S+) ", said)
    assert found
    assert found[1] == bond
    assert math.isclose(float(found[2]), math.sqrt(k), rel_tol=1e-3)
    assert "swings" not in (tmp_path / "log.lammps").read_text()
    for switches, dt in ((("--strict",), 0.02), ((), 0.009)):
        assert "swings" not in run(tmp_path, "--engine", engine, *switches, bond=bond, coeff=coeff, dt=dt).stdout
    assert "will blow up" in run(tmp_path, "--engine", engine, bond=bond, coeff=coeff, dt=0.21).stdout


@pytest.mark.parametrize("engine", ["exact", "fast"])
def test_positions_that_are_no_numbers_end_the_run(tmp_path: Path, engine: str) -> None:
    done = run(tmp_path, "--engine", engine, bond="gromos", coeff="1e300 0.9", dt=1.0, every=1000000, steps=5)
    assert done.returncode == 1
    assert re.search(r"Non-numeric positions or velocities of 2 atoms at step 5: 1 2; bond 1 2 of type 1", done.stdout + done.stderr)
    assert run(tmp_path, "--engine", engine, "--strict", bond="gromos", coeff="1e300 0.9", dt=1.0, every=1000000, steps=5).returncode == 0
