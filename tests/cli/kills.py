"""SIGKILL at random moments: what a run leaves must be readable up to the last whole frame, and its last restart file must load.

    python -m tests.cli.kills [N]     kills N runs (default 200) of both engines in turn and says what was found
"""

from __future__ import annotations

import os
import random
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import numpy as np

from tests.support import lammps

_HEAD = """
units lj
atom_style bond
lattice sc 1.0
region cell block 0 8 0 8 0 8
create_box 1 cell bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 30
create_atoms 1 box
mass 1 1.0
displace_atoms all random 0.05 0.05 0.05 4711
pair_style lj/cut 1.12
pair_modify shift yes
pair_coeff * * 1.0 1.0
special_bonds lj/coul 0 1 1
create_bonds many all all 1 0.85 1.15
special_bonds lj/coul 1 1 1
"""
_BONDS = "bond_style quartic\nbond_coeff 1 1200 -0.55 0.25 1.3 34.6878\n"
SCRIPT = (
    _HEAD + _BONDS + "velocity all create 4.0 87287 loop geom\nfix 1 all nve\ntimestep 0.002\n"
    """thermo 2
thermo_style custom step temp pe ebond bonds
dump 1 all custom 2 all.dump id type x y z vx vy vz
dump_modify 1 format float %.17g
dump 2 all atom 4 frame.*.dump
fix mean all ave/time 1 2 2 c_thermo_temp file mean.txt
restart 10 state.a state.b
run 1000000
"""
)


class Broken(AssertionError):
    """Something a killed run left cannot be read."""


def kill_one(folder: Path, engine: str, after: float) -> str:
    """Start a run, kill it so many seconds after its first frame; what its dump ends with: "whole" or "cut". Raises Broken."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "in.script").write_text(SCRIPT)
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    running = subprocess.Popen(
        [sys.executable, "-m", "pylmp", "in.script", "--engine", engine], cwd=folder, env=environment, stdout=subprocess.DEVNULL
    )  # fmt: skip
    dump, until = folder / "all.dump", time.monotonic() + 60.0
    while not (dump.exists() and dump.stat().st_size) and time.monotonic() < until and running.poll() is None:
        time.sleep(0.001)
    time.sleep(after)
    running.kill()
    if running.wait() != -9:
        raise Broken("the run ended by itself")
    ending, last = _dump(dump)
    _lines(folder)
    _restarts(folder, last)
    return ending


def _dump(path: Path) -> tuple[str, int]:
    """What it ends with, and the step of the last whole frame. Frames before the last are whole; ASE and MDAnalysis read those of a whole file."""
    texts = path.read_text().split("ITEM: TIMESTEP\n")[1:]
    whole = [text for text in texts if text.count("\n") == 8 + 512 and text.endswith("\n")]
    if len(whole) < len(texts) - 1 or whole != texts[: len(whole)]:
        raise Broken("a frame before the last one is not whole")
    steps = [int(text.split("\n", 1)[0]) for text in whole]
    if steps != list(range(0, 2 * len(whole), 2)):
        raise Broken(f"steps {steps}")
    last = steps[-1] if steps else -1
    if len(whole) < len(texts) or not whole:
        return "cut", last
    import ase.io
    import MDAnalysis

    read = ase.io.read(path, index=":", format="lammps-dump-text")
    universe = MDAnalysis.Universe(str(path), format="LAMMPSDUMP", topology_format="LAMMPSDUMP")
    if len(read) != len(whole) or len(universe.trajectory) != len(whole):
        raise Broken(f"readers find {len(read)} and {len(universe.trajectory)} of {len(whole)} frames")
    return "whole", last


def _lines(folder: Path) -> None:
    """Texts consist of whole lines, one frame a file is whole, and no other files lie about."""
    for name in ("log.lammps", "mean.txt"):
        text = (folder / name).read_text()
        if text and not text.endswith("\n"):
            raise Broken(f"{name} ends with {text[-60:]!r}")
    means = [line.split() for line in (folder / "mean.txt").read_text().splitlines() if not line.startswith("#")]
    if [int(row[0]) for row in means] != list(range(2, 2 + 2 * len(means), 2)):
        raise Broken("mean.txt lacks a line")
    for path in folder.glob("frame.*.dump"):
        if path.read_text().count("\n") != 9 + 512:
            raise Broken(f"{path.name} is cut")


def _restarts(folder: Path, last: int) -> None:
    """Both programs go on from the last restart file, equally, and read the last whole frame of the dump, also if a part of one follows."""
    found = sorted(folder.glob("state.[ab]"), key=lambda path: path.stat().st_mtime_ns)
    if not found:
        return
    follow = f"read_restart {found[-1].name}\n{_BONDS}fix 1 all nve\nthermo 1\nrun 2\n"
    if last >= 0:
        follow += f"read_dump all.dump {last} x y z vx vy vz\nrun 0\n"
    theirs = lammps(follow.replace("read_restart ", "read_restart ../").replace("all.dump", "../all.dump"), folder / "lammps")
    if theirs.code:
        raise Broken(f"LAMMPS: {theirs.screen[-300:]}")
    from tests.support import simulate

    sim, _ = simulate(follow, folder)
    row = theirs.log.split("   Step")[-1].split("\n")[1 if last >= 0 else 3].split()
    ours = sim.computes["thermo_temp"].scalar(sim)
    if int(row[0]) != sim.step or not np.isclose(float(row[1]), ours, rtol=1e-7):
        raise Broken(f"{found[-1].name} goes on as {sim.step} {ours}, on LAMMPS as {row}")


def many(count: int, folder: Path, seed: int = 1) -> Counter[str]:
    """How dumps of count killed runs ended; raises Broken with the number of the run."""
    chance = random.Random(seed)
    endings: Counter[str] = Counter()
    for number in range(count):
        engine, after = ("exact", "fast")[number % 2], chance.uniform(0.0, 0.4)
        try:
            endings[kill_one(folder / str(number), engine, after)] += 1
        except Broken as error:
            raise Broken(f"run {number}, {engine}, killed after {after:.3f} s: {error}") from None
    return endings


if __name__ == "__main__":
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    with tempfile.TemporaryDirectory() as place:
        print(f"{number} kills; the last frame of the dump: {dict(many(number, Path(place), seed=2))}")
