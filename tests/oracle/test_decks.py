"""Every deck of inputs/ under `pylmp diff`: identical to the last bit, wherever LAMMPS can run it."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

INPUTS = Path(__file__).parents[2] / "inputs"
DECKS = sorted(deck for deck in INPUTS.glob("*/in.*") if "unbreakable" not in deck.name and deck.parent.name != "bench")
BENCH = {  # the decks of speed, small: variables, and what must have happened
    "in.A_melt": "ny 4 nz 6 settle 60 steps 60", "in.B_melt_long": "nx 32 ny 6 nz 6 settle 60 steps 30",
    "in.C_impact": "shrink 0.4 steps 100", "in.C2_impact_mild": "shrink 0.4 steps 100", "in.D_sheet_2000": "n 20 steps 300",
    "in.D_sheet_200": "steps 300", "in.E_network": "cells 8 steps 200", "in.F_liquid": "cells 6 settle 60 steps 60",
    "in.G_two_types": "ny 4 nz 6 settle 60 steps 60",
}  # fmt: skip
LEAST_STEPS = 1000


def diff(script: Path, *switches: str) -> dict:
    """The JSON report of pylmp diff."""
    done = subprocess.run(
        [sys.executable, "-m", "pylmp", "diff", str(script), "--json", *switches],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.stdout, done.stderr
    report = json.loads(done.stdout)
    assert done.returncode == {"identical": 0, "different": 4}.get(report["verdict"], 1)
    return report


def failures(report: dict) -> list:
    return [part["first"] for part in report.get("parts", []) if part["first"]] or report.get("said", [])


def test_there_are_decks() -> None:
    assert len(DECKS) >= 9


@pytest.mark.parametrize("deck", DECKS, ids=[d.name for d in DECKS])
def test_identical(deck: Path, tmp_path: Path) -> None:
    folder = tmp_path / deck.parent.name
    shutil.copytree(deck.parent, folder)
    switches = []
    if deck.name == "in.quartic_melt":  # 3 200 beads stand for 32 000
        subprocess.run([sys.executable, "make_melt.py", "100", "32"], cwd=folder, check=True)
        switches = ["-var", "steps", "1000"]
    report = diff(folder / deck.name, *switches)
    assert report["verdict"] == "identical", failures(report)
    compared = {part["name"]: part["cells"] for part in report["parts"]}
    assert compared["thermo"] > 0
    assert compared["file pylmp-diff.atoms"] > 0
    if "bond_style" in deck.read_text():
        assert compared["file pylmp-diff.bonds"] > 0


@pytest.mark.parametrize("name", sorted({*BENCH, *(path.name for path in (INPUTS / "bench").glob("in.*"))}))
def test_a_deck_of_bench_is_identical(name: str) -> None:
    words = BENCH[name].split()
    pairs = zip(words[::2], words[1::2], strict=True)
    report = diff(INPUTS / "bench" / name, *(word for pair in pairs for word in ("-var", *pair)))
    assert report["verdict"] == "identical", failures(report)
    assert report["dialect"] == []  # LAMMPS runs them unchanged


@pytest.mark.parametrize("deck", DECKS, ids=[d.name for d in DECKS])
def test_decks_are_long_enough(deck: Path) -> None:
    steps = sum(int(n) for n in re.findall(r"^run\s+(\d+)", deck.read_text(), re.M))
    assert steps >= LEAST_STEPS or deck.name == "in.quartic_melt"


def test_a_difference_is_found(tmp_path: Path) -> None:
    """The instrument itself: a script whose two dialects differ in one coefficient is not called identical."""
    deck = (INPUTS / "plastic_cyclic" / "in.plastic_cyclic").read_text()
    other = deck.replace("bond_style      bpm/spring/plastic", "variable eps string 0.05\nbond_style      bpm/spring/plastic")
    (tmp_path / "in.same").write_text(other)
    assert diff(tmp_path / "in.same")["verdict"] == "identical"
    from pylmp.tools.diff import compare

    a, b = tmp_path / "a", tmp_path / "b"
    for folder, value in ((a, "1.0000000000000002"), (b, "1.0")):
        folder.mkdir()
        (folder / "log.lammps").write_text(f"   Step Temp\n 0 {value}\nLoop time of 0\n")
    found = compare.runs(a, b, set())
    assert not found.identical
    assert found.parts[0].first is not None
    assert found.parts[0].first.ulps == 1
