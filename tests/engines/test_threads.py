"""Threads of the fast engine: the same bits for any number of them."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from pylmp.engines.fast import Fast
from pylmp.kernels import team
from tests.engines.scenes import script
from tests.engines.test_fast import NAMES
from tests.engines.test_fast import SCENES as LAWS
from tests.engines.test_fast import scene as scene_of_laws
from tests.engines.test_fast_scenes import SCENES, scene
from tests.engines.test_leap import outcome, table
from tests.support import frames, simulate

ROOT = Path(__file__).parents[2]
BATH = "fix 3 all langevin 1.0 1.0 1.0 77\nrun 60\nrun 20 pre no\n"
TEXTS = {
    **{name: scene_of_laws(*which, heat=2.0) + BATH for name, which in zip(NAMES, LAWS, strict=True)},
    "flat": script("lj", "plastic", flat=True, heat=1.0) + BATH,
    "free": script("lj", "plastic", boundary="s p m", newton="off off", heat=2.0) + BATH,
    **{name: scene(name) + "run 40\n" for name in SCENES},
}


@pytest.fixture
def small_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Parts of a few atoms, so that small systems have several."""
    monkeypatch.setattr(team, "_LEAST", 2)


@pytest.mark.usefixtures("small_parts")
@pytest.mark.parametrize("name", TEXTS)
def test_the_same_bits(name: str, tmp_path: Path) -> None:
    results = []
    for threads in (1, 2, 3):
        sim, screen = simulate(TEXTS[name], tmp_path / str(threads), Fast(), threads=threads)
        assert "Engine exact" not in screen
        results.append((outcome(sim, tmp_path / str(threads)), table(screen)))
    assert results[0] == results[1] == results[2]
    assert len(results[0][1]) > 2


@pytest.mark.usefixtures("small_parts")
@pytest.mark.parametrize("count", [1, 2, 7, 8, 9, 31, 33, 70])
def test_any_number_of_atoms(count: int, tmp_path: Path) -> None:
    text = (
        "units lj\natom_style atomic\nregion b block 0 9 0 9 0 9\ncreate_box 1 b\n"
        f"create_atoms 1 random {count} 4711 NULL overlap 0.9 maxtry 500\nmass 1 1.0\npair_style lj/cut 2.5\npair_coeff 1 1 1.0 1.0\n"
        "velocity all set 1.0 0.5 0.2\nfix 1 all nve\ntimestep 0.002\nthermo 7\nrun 50\n"
    )
    one, two = (simulate(text, tmp_path / str(threads), Fast(), threads=threads) for threads in (1, 2))
    assert outcome(one[0], tmp_path / "1") == outcome(two[0], tmp_path / "2")
    assert table(one[1]) == table(two[1])


def test_parts_do_all_once() -> None:
    """Whatever there is to do is in one part, and depends on nothing but how much it is."""
    for count in (0, 1, 15, 1023, 1024, 1025, 99_999):
        parts = team.cuts(count)
        assert [row for begin, end in parts for row in range(begin, end)] == list(range(count))
        assert len(parts) in (1, team.PARTS)


def test_helpers_live_as_long_as_a_run(tmp_path: Path) -> None:
    before = threading.active_count()
    simulate(TEXTS["lj-plastic"], tmp_path, Fast(), threads=3)
    assert threading.active_count() == before


def test_environment_says_how_many(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "cpu_count", lambda: 4)
    for said, asked, wanted in (("", None, 1), ("2", None, 2), ("3,2", None, 3), ("99", None, 4), ("0", None, 1), ("many", None, 1), ("2", 1, 1), ("1", 8, 8)):
        monkeypatch.setenv("OMP_NUM_THREADS", said)
        assert team.threads(asked) == wanted


LIQUID = (
    "units lj\nlattice fcc 0.8\nregion b block 0 9 0 9 0 9\ncreate_box 1 b\ncreate_atoms 1 box\nmass 1 1.0\npair_style lj/cut 2.5\n"
    "pair_coeff 1 1 1 1\nvelocity all create 1.0 99\nfix 1 all nve\ndump d all custom 100 out.dump id type x y z\nthermo 100\n"
)


def _start(folder: Path, *switches: str, steps: int = 1_000_000) -> subprocess.Popen[str]:
    (folder / "in.liquid").write_text(f"{LIQUID}run {steps}\n")
    command = [sys.executable, "-m", "pylmp", "in.liquid", "--engine", "fast", *switches]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.Popen(command, cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


@pytest.mark.parametrize(("sent", "code"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_interrupt(sent: int, code: int, tmp_path: Path) -> None:
    """The run ends with whole files and without a thread that hangs."""
    child = _start(tmp_path, "--threads", "2")
    deadline = time.monotonic() + 120
    while not ((tmp_path / "out.dump").exists() and len(frames(tmp_path / "out.dump")) > 1) and time.monotonic() < deadline:
        time.sleep(0.1)
    child.send_signal(sent)
    said, _ = child.communicate(timeout=60)
    assert child.returncode == code, said
    assert "Traceback" not in said
    assert {len(rows) for _, _, rows in frames(tmp_path / "out.dump")} == {2916}


def test_more_threads_than_cores(tmp_path: Path) -> None:
    """Many threads on few cores: the same numbers, and an end."""
    said = []
    for threads in ("1", "7"):
        child = _start(tmp_path, "--threads", threads, "-log", f"log.{threads}", steps=200)
        assert child.wait(timeout=120) == 0, child.communicate()[0]
        log = (tmp_path / f"log.{threads}").read_text()
        assert f"{threads} thread" in log
        said.append(table(log))
    assert said[0] == said[1]


def test_wrong_number_of_threads(tmp_path: Path) -> None:
    child = _start(tmp_path, "--threads", "0")
    said, _ = child.communicate(timeout=60)
    assert child.returncode == 2
    assert "--threads takes a number from 1 to 64" in said
