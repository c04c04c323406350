"""Ctrl-C, SIGTERM, SIGKILL: what a run leaves behind."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.cli.kills import SCRIPT, many
from tests.support import frames, lammps

LONG = "region b block 0 4 0 4 0 4\ncreate_box 1 b\nprint begin\ncreate_atoms 1 random 100000 5 NULL overlap 3 maxtry 1000000000\n"
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143}


def start(folder: Path, script: str, *switches: str) -> subprocess.Popen[str]:
    (folder / "in.script").write_text(script)
    command = [sys.executable, "-m", "pylmp", "in.script", *switches]
    return subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def wait_for(path: Path, text: str) -> None:
    until = time.monotonic() + 60.0
    while time.monotonic() < until and not (path.exists() and text in path.read_text()):
        time.sleep(0.01)


@pytest.mark.parametrize("number", CODES, ids=lambda number: number.name)
@pytest.mark.parametrize("engine", ["exact", "fast"])
def test_the_step_ends_and_a_checkpoint_is_written(engine: str, number: signal.Signals, tmp_path: Path) -> None:
    running = start(tmp_path, SCRIPT, "--engine", engine, "--checkpoint-on-exit", "last.rst")
    wait_for(tmp_path / "mean.txt", "\n6 ")
    sent = time.monotonic()
    running.send_signal(number)
    screen, _ = running.communicate(timeout=60)
    assert time.monotonic() - sent < 5.0
    assert running.returncode == CODES[number], screen
    step = int(screen.split("Interrupted at step ")[1].split(";")[0])
    assert "Loop time of" in (tmp_path / "log.lammps").read_text()
    found = frames(tmp_path / "all.dump")
    assert [at for at, _, _ in found] == list(range(0, step + 1, 2)) and {len(rows) for _, _, rows in found} == {512}
    follow = 'read_restart ../last.rst\nprint "at $(step) $(atoms)"\n'
    there = lammps(follow, tmp_path / "lammps")
    assert there.code == 0 and f"at {step} 512" in there.screen


def test_a_second_interrupt_does_not_wait(tmp_path: Path) -> None:
    running = start(tmp_path, LONG, "--checkpoint-on-exit", "last.rst")
    wait_for(tmp_path / "log.lammps", "begin")
    time.sleep(0.2)
    running.send_signal(signal.SIGINT)
    time.sleep(0.3)
    assert running.poll() is None  # the command goes on
    running.send_signal(signal.SIGINT)
    screen, _ = running.communicate(timeout=10)
    assert running.returncode == 130 and "Traceback" not in screen
    assert (tmp_path / "log.lammps").read_text().endswith("\n") and not (tmp_path / "last.rst").exists()


def test_a_signal_between_short_runs(tmp_path: Path) -> None:
    """Nothing is half done between commands either."""
    body = SCRIPT.replace("run 1000000", "label again\nrun 1\nvariable n equal step\njump SELF again")
    running = start(tmp_path, body, "--checkpoint-on-exit", "last.rst")
    wait_for(tmp_path / "mean.txt", "\n6 ")
    running.send_signal(signal.SIGTERM)
    screen, _ = running.communicate(timeout=60)
    assert running.returncode == 143 and "Checkpoint: last.rst" in screen


def test_kills_at_random_moments(tmp_path: Path) -> None:
    """A few of them; `python -m tests.cli.kills` does 200."""
    assert sum(many(6, tmp_path).values()) == 6
