"""Helpers of the tests: run a script on real LAMMPS or on pylmp, read dumps, compare bits."""

from __future__ import annotations

import io
import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass
class Outcome:
    """What a run left: exit code, screen text, log text, its folder."""

    code: int
    screen: str
    log: str
    folder: Path


def lammps(script: str, folder: Path, *switches: str, timeout: float = 300.0) -> Outcome:
    """Run script on real LAMMPS (serial, one thread) in folder."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "in.script").write_text(script)
    done = subprocess.run(
        [str(Path(sys.executable).with_name("lmp")), "-in", "in.script", "-nocite", *switches],
        cwd=folder, env={**os.environ, "OMP_NUM_THREADS": "1"}, capture_output=True, text=True, timeout=timeout,
    )  # fmt: skip
    log = folder / "log.lammps"
    return Outcome(done.returncode, done.stdout, log.read_text() if log.exists() else "", folder)


def frames(path: Path) -> list[tuple[int, list[str], np.ndarray]]:
    """(step, column names, rows) of every frame of a dump atom, custom or local file whose cells are numbers."""
    result = []
    for frame in path.read_text().split("ITEM: TIMESTEP\n")[1:]:
        lines = frame.split("\n")
        header = next(k for k, line in enumerate(lines) if line.startswith(("ITEM: ATOMS", "ITEM: ENTRIES", "ITEM: BONDS")))
        rows = [[float(w) for w in line.split()] for line in lines[header + 1 :] if line]
        result.append((int(lines[0]), lines[header].split()[2:], np.array(rows)))
    return result


def simulate(script: str, folder: Path, engine=None, screen: io.StringIO | None = None, threads: int = 1):
    """Run script in this process on pylmp in folder, on the exact engine or another; returns (simulation, screen text). Errors are raised."""
    from pylmp.engines.exact import Exact
    from pylmp.interpreter import run_text
    from pylmp.kernels.team import Team
    from pylmp.model.console import Console
    from pylmp.model.simulation import Simulation

    folder.mkdir(parents=True, exist_ok=True)
    screen = screen or io.StringIO()
    sim = Simulation(Console(screen, None), engine or Exact())
    sim.team = Team(threads)
    before = Path.cwd()
    os.chdir(folder)
    try:
        run_text(sim, script, allow=["read"])
    finally:
        os.chdir(before)
    return sim, screen.getvalue()
