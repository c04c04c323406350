"""Disk full, closed pipes, folders that vanish, two runs in one folder: a sentence, exit code 1, nothing half written."""

from __future__ import annotations

import resource
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support import frames

BOX = """lattice sc 1
region b block 0 10 0 10 0 10
create_box 1 b
create_atoms 1 box
mass 1 1
velocity all create 1 5
pair_style lj/cut 1.1
pair_coeff 1 1 1 1
fix 1 all nve
thermo 100
"""
CASES = {
    "dump": ("dump d all custom 1 d id type x y z\nrun 20", "Error writing dump d: File too large"),
    "one a frame": ("dump d all custom 1 d.* id type x y z vx vy vz fx fy fz\nrun 20", "Cannot open dump file d."),
    "gz": ("dump d all custom 1 d.gz id x y z vx vy vz fx fy fz\nrun 20", "Error writing dump d.gz: File too large"),
    "write_restart": ("write_restart state", "Cannot open restart file state: File too large"),
    "restart": ("restart 2 state\nrun 4", "Cannot open restart file state.2: File too large"),
    "write_data": ("write_data state", "Cannot open data file state: File too large"),
    "ave/time": ("fix a all ave/time 1 1 1 c_thermo_temp file means\nrun 5000", "Error writing file means: File too large"),
    "log": ("thermo 1\nrun 2000", "Error writing log file: File too large"),
    "print": ("label a\nprint '" + 500 * "x" + "' append lines screen no\njump SELF a", "File too large"),
}
MOST = 60 * 1024


def run(folder: Path, script: str, *switches: str, limit: int = 0, out: int | None = subprocess.PIPE) -> subprocess.CompletedProcess[str]:
    (folder / "in.script").write_text(script + "\n")
    bound = (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))) if limit else None
    command = [sys.executable, "-m", "pylmp", "in.script", *switches]
    return subprocess.run(command, cwd=folder, stdout=out, stderr=subprocess.PIPE, text=True, timeout=60, preexec_fn=bound, check=False)


@pytest.mark.parametrize("name", CASES)
def test_a_disk_that_is_full(name: str, tmp_path: Path) -> None:
    script, sentence = CASES[name]
    done = run(tmp_path, BOX + script, "-log", "none" if name == "print" else "log.lammps", limit=MOST)
    assert done.returncode == 1 and sentence in done.stdout, done.stdout + done.stderr
    assert "Traceback" not in done.stderr and "pylmp itself failed" not in done.stdout
    for path in tmp_path.iterdir():
        if path.name == "d":
            assert {len(rows) for _, _, rows in frames(path)} == {1000} and path.stat().st_size < MOST
        elif path.name.startswith("d.") and path.suffix != ".gz":
            assert path.read_text().count("\n") == 1009
        elif path.name == "means":
            assert path.read_text().endswith("\n")
        elif path.name != "d.gz":
            assert path.name in ("in.script", "log.lammps", "lines"), path


def test_the_log_or_the_screen_is_full(tmp_path: Path) -> None:
    done = run(tmp_path, BOX + "run 1", "-log", "/dev/full")
    assert done.returncode == 1 and "Error writing log file: No space left on device" in done.stdout and not done.stderr
    with open("/dev/full", "w") as full:
        done = run(tmp_path, BOX + "run 1", out=full.fileno())
    assert done.returncode == 1 and "Error writing to the screen" in done.stderr and "Traceback" not in done.stderr


def test_a_closed_pipe(tmp_path: Path) -> None:
    (tmp_path / "in.script").write_text(BOX + "thermo 1\nrun 100000000\n")
    running = subprocess.Popen([sys.executable, "-m", "pylmp", "in.script"], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert running.stdout is not None and running.stderr is not None
    running.stdout.readline()
    running.stdout.close()
    assert running.wait(60) == 1 and "Traceback" not in running.stderr.read()


@pytest.mark.parametrize("script", ["print x file no/x", "balance 1.1 x uniform out no/x", "log no/x", "dump d all atom 1 no/x\nrun 0", "write_data no/x", "restart 1 no/x\nrun 1"])
def test_a_folder_that_is_not_there(script: str, tmp_path: Path) -> None:
    done = run(tmp_path, BOX + script)
    assert done.returncode == 1 and "no/x" in done.stdout and "No such file or directory" in done.stdout and "in.script:1" in done.stdout
    assert "itself failed" not in done.stdout and not done.stderr


def test_a_working_directory_that_vanishes(tmp_path: Path) -> None:
    (tmp_path / "gone").mkdir()
    script = BOX + "shell rm in.script log.lammps\nshell rmdir ../gone\ndump d all atom 1 d\nrun 1"
    done = run(tmp_path / "gone", script, "--allow", "shell")
    assert done.returncode == 1 and "No such file or directory" in done.stdout and "Traceback" not in done.stderr


def test_two_runs_in_one_folder(tmp_path: Path) -> None:
    """Files that are written whole are whole, whoever wrote them last."""
    script = BOX + "dump d all custom 2 d.* id type x y z\nrestart 5 a b\nrun 300\nwrite_data end.data\n"
    (tmp_path / "in.script").write_text(script)
    both = [subprocess.Popen([sys.executable, "-m", "pylmp", "in.script"], cwd=tmp_path, stdout=subprocess.DEVNULL) for _ in range(2)]
    assert [one.wait(60) for one in both] == [0, 0]
    assert all(path.read_text().count("\n") == 1009 for path in tmp_path.glob("d.*"))
    assert {path.name for path in tmp_path.iterdir()} - {f"d.{k}" for k in range(0, 302, 2)} == {"in.script", "log.lammps", "a", "b", "end.data"}
    alone = tmp_path / "alone"
    alone.mkdir()
    assert run(alone, script).returncode == 0
    assert (alone / "b").read_bytes() == (tmp_path / "b").read_bytes()
