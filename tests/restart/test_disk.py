"""Files on disk: of LAMMPS on two processes, of a run that was killed, of styles that LAMMPS does not have; where scripts may write."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from pylmp.io.restart.decode import decode
from pylmp.io.restart.layout import MAGIC
from pylmp.text.diagnostic import ScriptError
from tests.restart.both import Pair
from tests.restart.scenes import NET, NVE, QUARTIC, SCENES, setup
from tests.support import simulate


def test_files_of_two_processes(tmp_path: Path) -> None:
    """One file and a set of files, both with the atoms of two processes."""
    begin, again = SCENES["harmonic, bond, newton on on"]
    (tmp_path / "in.two").write_text(f"{begin}{again}run 20 post no\nwrite_restart one\nwrite_restart set.%\n")
    tools = Path(sys.executable).parent
    subprocess.run(
        [str(tools / "mpiexec"), "-n", "2", str(tools / "lmp"), "-in", "in.two", "-log", "none"],
        cwd=tmp_path, env={**os.environ, "OMP_NUM_THREADS": "1"}, check=True, capture_output=True, timeout=120,
    )  # fmt: skip
    data = (tmp_path / "one").read_bytes()
    assert decode(data, "one").header["processes"] == 2
    both = Pair(tmp_path)
    for name in ("one", "set.%"):
        both.run(f"read_restart {tmp_path / name}\n{again}run 20 post no\nwrite_restart file\n", "file")


def test_a_killed_run_leaves_readable_files(tmp_path: Path) -> None:
    """Whenever it dies, every file with a restart file's name is a whole one; no half-written file takes its place."""
    script = setup(NET + QUARTIC, heat=1.0) + NVE + "special_bonds lj/coul 1 1 1\nrestart 1 two.a two.b\nrun 100000\n"
    (tmp_path / "in.long").write_text(script)
    for after in (0.05, 0.11, 0.17):
        run = subprocess.Popen([sys.executable, "-m", "pylmp", "in.long", "-screen", "none", "-log", "none"], cwd=tmp_path)
        limit = time.monotonic() + 60
        while not (tmp_path / "two.b").exists() and time.monotonic() < limit:
            time.sleep(0.02)
        time.sleep(after)
        run.send_signal(signal.SIGKILL)
        assert run.wait() == -signal.SIGKILL
        steps = [decode((tmp_path / name).read_bytes(), name).header["step"] for name in ("two.a", "two.b")]
        assert abs(steps[0] - steps[1]) == 1
        for name in ("two.a", "two.b"):
            (tmp_path / name).unlink()


@pytest.mark.parametrize("style", ["quartic/unbreakable", "quartic/breakable"])
def test_styles_of_the_manual_alone(style: str, tmp_path: Path) -> None:
    """pylmp goes on from its own file as from its own run; quartic/breakable is what LAMMPS calls quartic."""
    begin = setup(NET + "special_bonds lj/coul 1 1 1\n" + QUARTIC.replace("quartic\n", f"{style}\n", 1), heat=5.0)
    first, _ = simulate(f"{begin}{NVE}run 20\nwrite_restart middle\nrun 20\nwrite_restart end\n", tmp_path)
    second, _ = simulate(f"read_restart middle\n{NVE}run 20\nwrite_restart again\n", tmp_path)
    assert (tmp_path / "again").read_bytes() == (tmp_path / "end").read_bytes()
    assert np.array_equal(first.atoms.x[: first.atoms.n], second.atoms.x[: second.atoms.n])
    written = decode((tmp_path / "end").read_bytes(), "end").forces["bond"].style
    assert written == ("quartic" if style == "quartic/breakable" else style)


@pytest.mark.parametrize("command", ["write_restart ../elsewhere", "restart 1 ../elsewhere", "restart 1 /tmp/a /tmp/b"])
def test_scripts_write_in_their_folder_only(command: str, tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.mkdir()
    with pytest.raises(ScriptError, match="outside the working directory"):
        simulate(f"{setup(style='atomic')}{NVE}{command}\nrun 3\n", home)
    assert list(tmp_path.iterdir()) == [home]


def test_magic(tmp_path: Path) -> None:
    """A file is written whole: it begins and ends as LAMMPS's do, and no temporary one is left."""
    simulate(f"{setup(style='atomic')}{NVE}restart 5 file\nrun 10\n", tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file.10", "file.5"]
    for path in tmp_path.iterdir():
        data = path.read_bytes()
        assert data[:16] == data[-16:] == MAGIC
