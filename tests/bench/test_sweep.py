"""pylmp bench --dt: energy error against time, on a small liquid and on chains that break."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.long  # dozens of whole runs

LIQUID = """units lj
variable steps index 200
lattice fcc 0.8442
region box block 0 4 0 4 0 4
create_box 1 box
create_atoms 1 box
mass 1 1.0
velocity all create 2.0 87287 loop geom
pair_style lj/cut 2.5
pair_modify shift yes
pair_coeff 1 1 1.0 1.0
neigh_modify every 1 delay 0
fix 1 all nve
timestep 0.004
run 50
run ${steps}
"""
DUMBBELLS = """units lj
atom_style bond
special_bonds lj/coul 0 1 1
lattice sc 0.125
region cell block 0 5 0 5 0 5
create_box 2 cell bond/types 1 extra/bond/per/atom 2 extra/special/per/atom 4
create_atoms 1 region cell
create_atoms 2 region cell
group right type 2
mass * 1.0
displace_atoms right move 0.95 0.0 0.0 units box
pair_style lj/cut 1.122462048309373
pair_modify shift yes
pair_coeff * * 1.0 1.0
create_bonds many all all 1 0.8 1.2
special_bonds lj/coul 1 1 1
bond_style quartic
bond_coeff 1 1200 -0.55 0.25 1.3 34.6878
variable speed atom 14*random(0,1,9123)
velocity right set v_speed NULL NULL
fix 1 all nve
neigh_modify every 1 delay 0
timestep 0.001
run 0
run 200
"""


def swept(script: str, folder: Path, *words: str) -> dict:
    (folder / "in.script").write_text(script)
    command = [sys.executable, "-m", "pylmp", "bench", "in.script", "--json", *words]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_energy_error_falls_with_the_square_of_the_timestep(tmp_path: Path) -> None:
    report = swept(LIQUID, tmp_path, "--dt", "2,1", "--engines", "exact,fast,lammps")
    by = {(p["engine"], p["times_dt"]): p for p in report["points"]}
    assert [by["exact", dt]["sd_energy_per_atom"] for dt in (2, 1)] == [by["lammps", dt]["sd_energy_per_atom"] for dt in (2, 1)]
    assert [(p["dt"], p["steps"]) for p in report["points"] if p["engine"] == "fast"] == [(0.008, 100), (0.004, 200)]
    assert report["time"] == pytest.approx(0.8)
    assert by["exact", 1]["force_error"] == by["lammps", 1]["force_error"] == 0.0
    assert 0.0 < by["fast", 1]["force_error"] < 1e-11
    for curve in report["within"]:
        assert 1.8 < curve["order"] < 2.2
        assert curve["seconds"] > 0.0


def test_broken_bonds_take_their_energy_with_them(tmp_path: Path) -> None:
    """What is conserved stays so while bonds break; with a timestep much too long it does not."""
    report = swept(DUMBBELLS, tmp_path, "--dt", "2,1,0.5", "--engines", "exact", "--save", "page.html")
    assert all(0.0 < p["first_break"] < 0.2 for p in report["points"])
    assert report["points"][-1]["sd_energy_per_atom"] < 1e-2
    page = (tmp_path / "page.html").read_text()
    assert "<svg" in page
    assert "http://" not in page.replace("http://www.w3.org", "").replace("http://purl.org", "").replace("http://creativecommons.org", "")


def test_a_run_that_blows_up_says_when(tmp_path: Path) -> None:
    report = swept(LIQUID, tmp_path, "--dt", "100,1", "--engines", "exact")
    assert report["points"][0]["blew_up_after"] is not None or report["points"][0]["failed"]
    assert report["points"][1]["failed"] is None


def test_words_that_do_not_go_together(tmp_path: Path) -> None:
    for words in (["--all", "--dt", "1"], ["in.x", "--save", "a.png"], ["in.x", "--dt", "0"], ["in.x", "--dt", "1", "--save", "a.pdf"]):
        done = subprocess.run([sys.executable, "-m", "pylmp", "bench", *words], cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 2, words
