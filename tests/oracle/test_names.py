"""grammar/names.txt is what LAMMPS itself says; and what pylmp lacks of it is told before the first step."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from pylmp.model.unknown import STYLED, is_elsewhere

ROOT = Path(__file__).parents[2]
BEGIN = "units lj\nregion b block 0 4 0 4 0 4\ncreate_box 1 b\ncreate_atoms 1 single 1 1 1\nmass 1 1\npair_style zero 1.0\npair_coeff * *\nfix 1 all nve\n"
WANTED = """fix 2 all rigid molecule
compute x all voronoi/atom neighbors yes
pair_style hybrid/overlay lj/cut 2.5 eam  # two at once
pair_style hybrid lj/cut 2.5 soft 1.0
kspace_style pppm 1e-4
temper 100 10 1 1 1 1
"""


def run(folder: Path, script: str, **files: str) -> tuple[int, str]:
    (folder / "in.script").write_text(script)
    for name, text in files.items():
        (folder / name).write_text(text)
    done = subprocess.run(
        [sys.executable, "-m", "pylmp", "in.script", "-log", "none"], cwd=folder, capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout


def test_the_page_of_names_is_current() -> None:
    sys.path.insert(0, str(ROOT / "docs"))
    try:
        from names import PAGE, page
    finally:
        sys.path.pop(0)
    assert PAGE.read_text() == page()


def test_names_are_known_with_and_without_suffix() -> None:
    assert {kind for kind, _ in STYLED.values()} == {
        "pair", "bond", "angle", "dihedral", "improper", "kspace", "atom", "minimize", "integrate", "fix", "compute", "dump", "region",
    }  # fmt: skip
    assert is_elsewhere("fix", "rigid") and is_elsewhere("fix", "rigid/omp") and is_elsewhere("command", "temper")
    assert not is_elsewhere("fix", "nve") and not is_elsewhere("fix", "rigidd") and not is_elsewhere("pair", "hybrid/overlay")


def test_all_are_listed_before_the_first_step(tmp_path: Path) -> None:
    code, text = run(tmp_path, BEGIN + "run 5\n" + WANTED + "include more.in\n", **{"more.in": "\nfix 9 all ttm 1\n"})
    assert code == 5
    assert "Step" not in text
    assert "LAMMPS has fix rigid, pylmp's native engines do not\n  --> in.script:10:11" in text
    others = ("11:15  compute voronoi/atom", "12:38  pair_style eam", "14:14  kspace_style pppm", "15:1  the command temper")
    assert all(f"--> in.script:{other}" in text for other in others)
    assert "--> more.in:2:11  fix ttm" in text
    assert "--engine lammps runs this script" in text


def test_what_is_met_lists_the_others(tmp_path: Path) -> None:
    code, text = run(tmp_path, BEGIN + WANTED)
    assert code == 5
    assert "fix rigid, pylmp's native engines do not\n  --> in.script:9:11" in text
    assert "--> in.script:14:1  the command temper" in text


@pytest.mark.parametrize("leave", ["quit", 'if "1 == 1" then quit', "label here\njump SELF end"])
def test_what_may_not_be_reached_is_a_warning(leave: str, tmp_path: Path) -> None:
    code, text = run(tmp_path, BEGIN + f"run 5\n{leave}\n{WANTED}label end\n")
    assert code == 0
    assert "WARNING: in.script:" in text and "fix rigid" in text and "Loop time" in text


def test_what_was_jumped_over_is_nothing(tmp_path: Path) -> None:
    code, text = run(tmp_path, f"jump SELF on\n{WANTED}label on\n{BEGIN}run 1\n")
    assert code == 0 and "rigid" not in text
    code, text = run(tmp_path, BEGIN + 'variable s string rigid\nif "1 == 2" then "fix 2 all rigid single"\nrun 1\nif "2 == 1" then "temper 1"\n')
    assert code == 0 and "rigid" not in text
