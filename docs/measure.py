"""Measures pylmp against LAMMPS on inputs/quartic_melt and on a small script, and writes docs/performance.md.

usage: python docs/measure.py [repetitions]      (needs the extra "reference"; about a minute)

The two programs run alternately; medians of loop times and of whole processes are reported with their range.
"""

from __future__ import annotations

import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from datetime import date
from pathlib import Path

from pylmp.engines import lammps

DOCS = Path(__file__).parent
MELT = DOCS.parent / "inputs" / "quartic_melt"
REPEAT = int(sys.argv[1]) if len(sys.argv) > 1 else 7
SMALL = """\
units lj
atom_style bond
special_bonds lj/coul 0 1 1
lattice sc 1.0
region b block 0 6 0 6 0 6
create_box 1 b bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 30
create_atoms 1 box
mass 1 1.0
pair_style lj/cut 1.12
pair_modify shift yes
pair_coeff 1 1 1.0 1.0
create_bonds many all all 1 0.9 1.1
special_bonds lj/coul 1 1 1
bond_style quartic
bond_coeff 1 1200 -0.55 0.25 1.3 34.6878
velocity all create 4.0 7823 loop geom
fix 1 all nve
fix 2 all langevin 4 4 1 12345
timestep 0.002
thermo 20
run 100
"""


def ours(script: str, folder: Path, **environment: str) -> tuple[float, str]:
    """(whole process, log) of pylmp."""
    start = time.perf_counter()
    subprocess.run(
        [sys.executable, "-m", "pylmp", script, "-screen", "none"],
        cwd=folder,
        check=True,
        env={**os.environ, **environment},
    )
    return time.perf_counter() - start, (folder / "log.lammps").read_text()


def theirs(script: str, folder: Path) -> tuple[float, str]:
    start = time.perf_counter()
    lammps.run(script, folder, ["-screen", "none", "-nocite"]).check_returncode()
    return time.perf_counter() - start, (folder / "log.lammps").read_text()


def last_loop(log: str) -> float:
    """Seconds of the last run: the steady state."""
    return [float(line.split()[3]) for line in log.splitlines() if line.startswith("Loop time")][-1]


def spread(values: list[float], unit: float = 1.0, digits: int = 2) -> str:
    low, high = min(values) * unit, max(values) * unit
    return f"{statistics.median(values) * unit:.{digits}f} [{low:.{digits}f}, {high:.{digits}f}]"


def measure(folder: Path) -> str:
    steps, beads = 200, 32000
    for name in ("make_melt.py", "in.quartic_melt"):
        shutil.copy2(MELT / name, folder / name)
    subprocess.run([sys.executable, "make_melt.py"], cwd=folder, check=True)
    deck = (folder / "in.quartic_melt").read_text() + "run ${steps}\n"
    (folder / "in.melt").write_text(deck)
    (folder / "in.release").write_text(deck.replace("quartic/breakable", "quartic"))
    (folder / "in.small").write_text(SMALL)
    cold = ours("in.small", folder, PYLMP_CACHE=str(folder / "empty"))[0]
    for script in ("in.melt", "in.small"):
        ours(script, folder)
    loops: tuple[list[float], list[float]] = ([], [])
    whole: tuple[list[float], list[float]] = ([], [])
    for _ in range(REPEAT):
        loops[0].append(last_loop(ours("in.melt", folder)[1]))
        loops[1].append(last_loop(theirs("in.release", folder)[1]))
        whole[0].append(ours("in.small", folder)[0])
        whole[1].append(theirs("in.small", folder)[0])
    ratios = [b / a for a, b in zip(*loops, strict=True)]
    per = 1e9 / steps / beads
    return f"""# Performance

Written by `python docs/measure.py {REPEAT}` on {date.today()}: {_processor()}, {os.cpu_count()} cores, shared with other work;
Python {platform.python_version()}, one thread each. The two programs ran alternately; medians [least, most] of {REPEAT} repetitions.

| what | pylmp, exact engine | LAMMPS 22 Jul 2025, serial | LAMMPS / pylmp |
|---|---|---|---|
| `inputs/quartic_melt`, 32 000 beads, second run of {steps} steps, ns per bead and step | {spread(loops[0], per, 0)} | {spread(loops[1], per, 0)} | {spread(ratios)} |
| whole process, 216 atoms, 100 steps, kernels in the store, s | {spread(whole[0])} | {spread(whole[1])} | |
| the same, the first time: compiling its kernels, s | {cold:.1f} | | |

The numbers of both programs are the same, to the last bit: `pylmp diff inputs/quartic_melt/in.quartic_melt`.

Where the time goes: the pair law is evaluated for every listed pair without a branch, because the cutoff test is unpredictable;
neighbor lists are built by scanning runs of bins that follow each other in memory; forces and output steps have kernels of their own,
composed for the scene. Nothing here trades accuracy for speed.
"""


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        text = measure(Path(place))
    (DOCS / "performance.md").write_text(text)
    print(text)
