"""The command line as a user meets it: the same switches, exit codes and files as lmp."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.oracle.test_decks import INPUTS
from tests.support import frames, lammps

SHORT = """\
units lj
lattice fcc 0.8442
region b block 0 3 0 3 0 3
create_box 1 b
create_atoms 1 box
mass 1 1.0
velocity all create 1.44 87287 loop geom
pair_style lj/cut 2.5
pair_coeff 1 1 1.0 1.0
fix 1 all nve
variable n index 20
thermo 10
dump 1 all custom 10 atoms.dump id type x y z
run ${n}
"""


def pylmp(folder: Path, *words: str, text: str | None = None, **more) -> subprocess.CompletedProcess[str]:
    """Run the command line in folder."""
    return subprocess.run(
        [sys.executable, "-m", "pylmp", *words],
        cwd=folder,
        input=text,
        capture_output=True,
        text=True,
        check=False,
        **more,
    )


def script(folder: Path, text: str = SHORT) -> str:
    (folder / "in.script").write_text(text)
    return "in.script"


@pytest.mark.parametrize("words", [["in.script"], ["run", "in.script"], ["-in", "in.script"], ["-i", "in.script"]])
def test_ways_to_name_the_script(words: list[str], tmp_path: Path) -> None:
    script(tmp_path)
    done = pylmp(tmp_path, *words)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Loop time" in done.stdout
    assert (tmp_path / "log.lammps").read_text().startswith("LAMMPS (22 Jul 2025 - Update 4)\n")


def test_script_from_standard_input(tmp_path: Path) -> None:
    done = pylmp(tmp_path, text=SHORT)
    assert done.returncode == 0
    assert "Loop time" in done.stdout


def test_variables_log_and_screen(tmp_path: Path) -> None:
    script(tmp_path)
    done = pylmp(tmp_path, "in.script", "-var", "n", "10", "-log", "other.log", "-screen", "none", "-nocite")
    assert done.returncode == 0
    assert done.stdout == ""
    assert "for 10 steps" in (tmp_path / "other.log").read_text()
    assert not (tmp_path / "log.lammps").exists()


def test_a_script_behind_var_is_taken_back(tmp_path: Path) -> None:
    script(tmp_path)
    done = pylmp(tmp_path, "-var", "n", "10", "in.script")
    assert done.returncode == 0
    assert "for 10 steps" in done.stdout
    assert "put it first" in done.stderr


def test_suffix_and_package_are_noted_once(tmp_path: Path) -> None:
    script(tmp_path)
    done = pylmp(tmp_path, "in.script", "-sf", "omp", "-pk", "omp", "1")
    assert done.returncode == 0
    assert done.stdout.count("-suffix and -package change nothing") == 1


def test_skiprun_makes_no_steps(tmp_path: Path) -> None:
    script(tmp_path)
    done = pylmp(tmp_path, "in.script", "-skiprun")
    theirs = lammps(SHORT, tmp_path / "lmp", "-skiprun")
    assert done.returncode == theirs.code == 0
    steps = [line for line in theirs.screen.splitlines() if line.startswith("Loop time")]
    assert [line.split(" for ")[1] for line in done.stdout.splitlines() if line.startswith("Loop time")] == [
        line.split(" for ")[1] for line in steps
    ]


def test_quit_gives_its_code(tmp_path: Path) -> None:
    script(tmp_path, "print 'before'\nquit 7\nprint 'after'\n")
    done = pylmp(tmp_path, "in.script")
    assert done.returncode == lammps("quit 7\n", tmp_path / "lmp").code == 7
    assert "before" in done.stdout
    assert "after" not in done.stdout


def test_exit_codes(tmp_path: Path) -> None:
    script(tmp_path, "fix 1 all\n")
    assert pylmp(tmp_path, "in.script").returncode == 1
    assert pylmp(tmp_path, "nothing.in").returncode == 1
    assert pylmp(tmp_path, "in.script", "-nope").returncode == 2
    script(tmp_path, "kspace_style ewald 1e-4\n")
    unsupported = pylmp(tmp_path, "in.script")
    assert unsupported.returncode == 5
    assert "LAMMPS has kspace_style ewald" in unsupported.stdout
    assert pylmp(tmp_path, "--help").returncode == 0
    assert pylmp(tmp_path, "--version").stdout.startswith("pylmp ")


def test_what_is_not_text_is_said_so(tmp_path: Path) -> None:
    (tmp_path / "in.rtf").write_bytes(b"{\\rtf1\\ansi units lj}")
    (tmp_path / "in.bin").write_bytes(bytes(range(256)))
    for name in ("in.rtf", "in.bin"):
        done = pylmp(tmp_path, name)
        assert done.returncode == 1
        assert "text" in done.stdout
        assert "Traceback" not in done.stdout + done.stderr


def test_engine_lammps_runs_the_script_unchanged(tmp_path: Path) -> None:
    script(tmp_path)
    done = pylmp(tmp_path, "in.script", "--engine", "lammps")
    assert done.returncode == 0, done.stderr
    assert "Loop time" in (tmp_path / "log.lammps").read_text()
    script(tmp_path, "fix 1 all\n")
    assert pylmp(tmp_path, "in.script", "--engine", "lammps").returncode == 1


def test_an_interrupt_ends_the_run_and_keeps_what_was_computed(tmp_path: Path) -> None:
    """The step is finished, the log gets its footer, dumps hold whole frames; exit code 130."""
    script(tmp_path, SHORT.replace("run ${n}", "run 100000000"))
    running = subprocess.Popen(
        [sys.executable, "-m", "pylmp", "in.script"],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    deadline = time.monotonic() + 60.0
    dump = tmp_path / "atoms.dump"
    while not (dump.exists() and dump.stat().st_size > 20000) and time.monotonic() < deadline:
        time.sleep(0.05)
    running.send_signal(signal.SIGINT)
    screen, _ = running.communicate(timeout=60)
    assert running.returncode == 130, screen
    assert "Traceback" not in screen
    log = (tmp_path / "log.lammps").read_text()
    assert "Loop time of" in log
    assert "Interrupted at step" in log
    rows = {len(data) for _, _, data in frames(dump)}
    assert rows == {108}


DEPARTURES = {
    "D001": ("bond_style bpm/spring/plastic myfix 1000 time id1 id2", "Illegal bond bpm command, invalid argument myfix"),
    "D002": ("dump 1 all custom 10 d id\ndump_modify 1 write_header no", "Unknown dump_modify keyword: write_header"),
    "D003": (
        "bond_style quartic\nbond_coeff * 1200 -0.55 0.25 1.3 34.6878\ndelete_bonds all bond 0 remove", "Invalid range string: 0",
    ),
    "D004": ("bond_style quartic/unbreakable", "Unrecognized bond style 'quartic/unbreakable'"),
}  # fmt: skip
BONDED = """\
units lj
atom_style bond
newton on off
comm_modify vel yes
region b block 0 6 0 6 0 6
create_box 1 b bond/types 1 extra/bond/per/atom 4 extra/special/per/atom 10
create_atoms 1 single 2.0 3 3
create_atoms 1 single 3.0 3 3
mass * 1.0
pair_style lj/cut 2.0
pair_coeff * * 1.0 1.0
special_bonds lj/coul 1 1 1
"""


@pytest.mark.parametrize("code", DEPARTURES)
def test_departures_warn_and_strict_refuses_as_the_release(code: str, tmp_path: Path) -> None:
    lines, sentence = DEPARTURES[code]
    text = BONDED + lines + "\n"
    script(tmp_path, text)
    lenient, strict = pylmp(tmp_path, "in.script"), pylmp(tmp_path, "in.script", "--strict")
    release = lammps(text, tmp_path / "lmp")
    assert lenient.returncode == 0, lenient.stdout
    assert f"[{code}]" in lenient.stdout
    assert strict.returncode == release.code == 1
    assert f"ERROR: {sentence}" in strict.stdout
    assert f"ERROR: {sentence}" in release.screen


def test_departures_are_documented() -> None:
    text = (INPUTS.parent / "docs" / "departures.md").read_text()
    for code in DEPARTURES:
        assert f"| {code} |" in text


def test_nothing_is_written_outside_the_working_directory_unless_allowed(tmp_path: Path) -> None:
    inside = tmp_path / "inside"
    inside.mkdir()
    target = tmp_path / "outside.txt"
    script(inside, f"print 'x' file {target}\n")
    refused = pylmp(inside, "in.script")
    assert refused.returncode == 1
    assert not target.exists()
    assert "--allow write" in refused.stdout
    assert pylmp(inside, "in.script", "--allow", "write").returncode == 0
    assert target.read_text() == "x\n"
    script(inside, SHORT.replace("atoms.dump", f"{os.pardir}/leak.dump"))
    assert pylmp(inside, "in.script").returncode == 1
    assert not (tmp_path / "leak.dump").exists()
