"""Who carries out a run, and what the log says of it."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = """units lj
lattice fcc 0.8442
region b block 0 5 0 5 0 5
create_box 1 b
create_atoms 1 box
mass 1 1
velocity all create 1.44 87287 loop geom
pair_style lj/cut 2.5
pair_coeff 1 1 1 1
fix 1 all nve
run 2
"""


def log(folder: Path, script: str, *switches: str) -> str:
    (folder / "in.script").write_text(script)
    subprocess.run([sys.executable, "-m", "pylmp", "in.script", "-screen", "none", *switches], cwd=folder, check=True)
    return (folder / "log.lammps").read_text()


@pytest.mark.parametrize(("switches", "engine"), [((), "fast"), (("--engine", "auto"), "fast"), (("--engine", "fast"), "fast"), (("--engine", "exact"), "exact")])
def test_the_log_says_who(switches: tuple[str, ...], engine: str, tmp_path: Path) -> None:
    """Once, before the table of the first run."""
    said = log(tmp_path, SCRIPT + "run 2\n", *switches)
    assert f"engine {switches[1] if switches else 'auto'}\n" in said.splitlines(keepends=True)[1]
    lines = [line for line in said.splitlines() if line.startswith("Engine")]
    assert len(lines) == 1
    assert re.match(rf"Engine {engine}: \d+ kernels \(.*\), 1 thread, float64", lines[0])
    assert said.index(lines[0]) < said.index("Per MPI rank memory allocation")


def test_the_log_says_why_not(tmp_path: Path) -> None:
    said = log(tmp_path, SCRIPT + "minimize 0 0 2 9\nrun 1\n")
    parts = said.split("Loop time")
    assert "Engine fast: " in parts[0]
    assert "Engine exact for this run: engine fast lacks minimize\nEngine exact: " in parts[1]
    assert "Engine fast: " in parts[2]
