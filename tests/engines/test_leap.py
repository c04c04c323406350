"""Steps that the fast engine takes many at once: the same bits, lists and output as one by one."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
import time
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from pylmp.engines import leap
from pylmp.engines.fast import Fast
from pylmp.engines.leap import Leap
from pylmp.kernels.fast import driver
from tests.engines.scenes import script
from tests.support import simulate

LISTS = ("every 1 delay 0 check yes", "every 3 delay 6 check yes", "every 2 delay 4 check no", "every 1 delay 0 once yes", "every 20 delay 40 check yes")
FIXES = {
    "bath": "fix 3 all langevin 1.0 1.0 0.5 77\n",
    "drag": "fix 3 all viscous 0.4 scale 2 1.5\nfix 4 two setforce 0.1 NULL 0.0\n",
    "limit": "unfix 1\nfix 1 two nve/limit 0.004\nfix 5 all langevin 1.0 1.0 0.5 77 zero yes\nthermo_style custom step temp pe f_1\n",
    "plain": "",
    "ramp": "fix 9 all langevin 1.0 2.0 0.5 77\nfix 4 all langevin 2.0 0.1 0.5 78 zero yes\n",
    "now and then": "fix 3 all momentum 7 linear 1 1 1\nfix 4 all print 9 'now' append out.said screen no\nfix 5 all temp/rescale 11 1.0 1.1 0.01 1.0\n"
    "variable w equal step\nfix 6 all halt 13 v_w > 1000\nfix 7 all ave/time 5 2 20 c_thermo_temp file out.mean\nfix 8 all store/state 0 x\n",
    "push": "fix 3 two addforce 0.3 -0.1 0.0\nfix 4 all addforce 0.0 0.1 0.0\nfix_modify 4 energy yes\nthermo_style custom step temp pe f_3 f_4[1]\n",
}
GOING_ON = "run 40\nrun 30 pre no\nvelocity all scale 2.0\nrun 45 pre no post no\nrun 60 every 17 'velocity two scale 1.5' 'print \"at $(step) $(temp)\"'\nrun 30 every 10 NULL\nrun 40 start 0 stop 400\nrun 20 pre no start 0 stop 400\n"
OTHERS = {
    "ave/time": "fix 9 all ave/time 1 1 10 c_thermo_temp\n",
    "tally": "fix 9 all langevin 1.0 1.0 0.5 77 tally yes\n",
    "variable": "variable v equal 0.001*step\nfix 9 all setforce NULL NULL v_v\n",
    "timeout": "timer timeout 1:00:00\n",
    "full": "timer full\n",
    "halt": "variable w equal step\nfix 9 all halt 1 v_w > 12\n",
}


def outcome(sim, folder: Path) -> tuple[Any, ...]:
    """Everything a run left."""
    atoms = sim.atoms
    arrays = [getattr(atoms, name)[: atoms.n].tobytes() for name in ("x", "v", "f", "tag", "image", "bond_type", "bond_history", "special")]
    files = {path.name: path.read_text() for path in sorted(folder.glob("out.*"))}
    return arrays, files, sim.step, sim.bonds, sim.report.builds, sim.report.dangerous, sim.report.steps


def table(screen: str) -> list[str]:
    """Lines of thermo output, and of the end of a run, that hold no times."""
    return [line for line in screen.splitlines() if line.split() and line.split()[0].isdigit() or "builds" in line or "ave " in line]


def leapt_and_not(text: str, folder: Path, monkeypatch) -> int:
    """Run text both ways, compare, return how many steps were taken in leaps."""
    taken: list[int] = []
    whole = Leap._leap

    def counted(self, run, steps: int) -> None:
        first = run.sim.step
        whole(self, run, steps)
        taken.append(run.sim.step - first)

    monkeypatch.setattr(Leap, "_leap", counted)
    fast, screen = simulate(text, folder / "leaps", Fast())
    assert "Engine exact" not in screen
    monkeypatch.setattr(Leap, "go", lambda self, run, end: False)
    slow, other = simulate(text, folder / "steps", Fast())
    assert outcome(fast, folder / "leaps") == outcome(slow, folder / "steps")
    assert table(screen) == table(other)
    assert len(table(screen)) > 3
    return sum(taken)


@pytest.mark.parametrize("lists", LISTS)
@pytest.mark.parametrize("fixes", FIXES)
@pytest.mark.parametrize("flat", [True, False], ids=["2d", "3d"])
def test_same_bits(lists: str, fixes: str, flat: bool, tmp_path: Path, monkeypatch) -> None:
    """Hot scenes, in which bonds break, with output at odd intervals and restart files."""
    bond = "quartic" if fixes in ("bath", "limit") else "plastic"
    text = script("lj" if bond == "quartic" else "spring", bond, flat=flat, newton="on on" if bond == "quartic" else "on off", heat=3.0, seed=len(lists))
    text = text.replace("every 1 delay 0 check yes", lists) + FIXES[fixes] + "thermo 23\nrestart 29 out.restart\ndump d all custom 17 out.dump.* id x vx\n"
    text = text.replace("out.restart", "rest")  # in bytes: not text
    assert leapt_and_not(text + "run 70\nrun 20\n", tmp_path, monkeypatch) > (30 if fixes == "now and then" else 70)


@pytest.mark.parametrize("fixes", FIXES)
def test_same_bits_without_set_up(fixes: str, tmp_path: Path, monkeypatch) -> None:
    """Runs that go on from one another, in pieces or with commands in between."""
    text = script("spring", "plastic", flat=len(fixes) % 2 == 0, heat=3.0, seed=len(fixes)) + FIXES[fixes] + "thermo 23\n"
    assert leapt_and_not(text + GOING_ON, tmp_path, monkeypatch) > 100


def test_bonds_break(tmp_path: Path, monkeypatch) -> None:
    """What keeps records of broken bonds has the same ones, in the same steps."""
    text = script("spring", "plastic", boundary="f f f", heat=6.0, seed=3)
    text = text.replace("normalize yes", "normalize yes store/local brk 25 time id1 id2 x y z")
    text = text.replace("fix 1 all nve", "fix 1 all nve\ndump 1 all local 25 out.broken.* f_brk[1] f_brk[2] f_brk[3] f_brk[4]") + "run 60\n"
    assert leapt_and_not(text, tmp_path, monkeypatch) > 20
    breaking = script("spring", "plastic", boundary="f f f", heat=6.0, seed=3) + "run 60\nrun 60 pre no\nrun 40 every 15 NULL\n"
    assert leapt_and_not(breaking, tmp_path / "more", monkeypatch) == 0  # go was replaced above: both by steps


@pytest.mark.parametrize("name", OTHERS)
def test_not_leapt_over(name: str, tmp_path: Path, monkeypatch) -> None:
    """Fixes and settings that want every step get it."""
    assert leapt_and_not(script("lj", "plastic") + OTHERS[name] + "run 25\n", tmp_path, monkeypatch) == 0


def test_driver_in_plain_python(tmp_path: Path, monkeypatch) -> None:
    """The driver is a Python function: it does by itself what the compiled one does."""
    text = script("lj", "plastic", heat=2.0) + "fix 3 all langevin 1.0 1.0 0.5 77\nrun 30\n"
    compiled, _ = simulate(text, tmp_path / "compiled", Fast())

    class Plain:
        def bind(self, *values: Any) -> Any:
            return partial(driver.drive, *values)

    monkeypatch.setattr(leap, "kernel", lambda function: Plain())
    plain, _ = simulate(text, tmp_path / "plain", Fast())
    assert outcome(plain, tmp_path / "plain") == outcome(compiled, tmp_path / "compiled")


def test_interrupt(tmp_path: Path) -> None:
    """An interrupt ends a run soon, between two of its steps."""
    (tmp_path / "in.script").write_text(script("spring", "plastic", flat=True, heat=1e-6) + "thermo 0\nrun 1\nrun 100000000\n")
    command = [str(Path(sys.executable).with_name("pylmp")), "--engine", "fast", "in.script"]
    running = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, text=True)
    assert running.stdout is not None
    tables = 0
    while tables < 2:
        line = running.stdout.readline()
        assert line, "the run ended by itself"
        tables += line.split()[:1] == ["Step"]
    time.sleep(0.5)
    running.send_signal(signal.SIGINT)
    sent = time.monotonic()
    rest = running.stdout.read()
    assert running.wait(30) != 0
    assert time.monotonic() - sent < 2.0
    steps = re.search(r"for (\d+) steps", rest)
    assert steps and 10 < int(steps[1]) < 100_000_000
