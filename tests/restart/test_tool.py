"""pylmp restart info and to-data, and lmp's switches for the same."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from pylmp.cli import main
from tests.restart.both import Pair
from tests.restart.scenes import SCENES
from tests.support import lammps

BROKEN = "quartic, breaking"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with LAMMPS's files of two scenes."""
    home = tmp_path_factory.mktemp("restart")
    for name in (BROKEN, "plastic"):
        place = home / name.split(",")[0]
        place.mkdir()
        setup, again = SCENES[name]
        Pair(place).run(f"{setup}{again}run 20 post no\nwrite_restart state.*\nwrite_restart set.%.*\n")
    return home


def run(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, str, str]:
    code = main(list(words))
    seen = capsys.readouterr()
    return code, seen.out, seen.err


def test_info(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The numbers are those that LAMMPS has after reading the same file."""
    file = folder / "quartic" / "lammps" / "state.20"
    code, text, _ = run(capsys, "restart", "info", str(file))
    assert code == 0
    assert run(capsys, "-r2info", str(file))[1] == text
    said = json.loads(run(capsys, "restart", "info", "--json", str(file))[1])
    script = f'read_restart {file}\nprint "$(step) $(dt) $(count(all)) $(count(two))"\ndelete_bonds all stats\n'
    printed = lammps(script, file.parent).screen
    numbers = [said["step"], said["timestep"], said["atoms"], said["groups"]["two"]]
    assert " ".join(f"{x:.20g}" for x in numbers) in printed
    left = said["bonds"] - said["broken_bonds"]
    assert f"{said['bonds']} total bonds, {left} turned on, {said['broken_bonds']} turned off" in printed
    assert said["broken_bonds"] > 0
    assert "bond_style    quartic" in text


def test_info_of_a_set_and_of_the_latest(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    home = folder / "plastic" / "lammps"
    one = json.loads(run(capsys, "restart", "info", "--json", str(home / "state.*"))[1])
    two = json.loads(run(capsys, "restart", "info", "--json", str(home / "set.%.20"))[1])
    assert {**one, "file": ""} == {**two, "file": ""}
    assert [fix["style"] for fix in one["fixes_per_atom"]] == ["property/atom"]


@pytest.mark.parametrize("scene", ["quartic", "plastic"])
@pytest.mark.parametrize("words", [[], ["nocoeff"]])
def test_to_data(scene: str, words: list[str], folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The very file that `lmp -restart2data` makes."""
    home = folder / scene / "lammps"
    flags = [f"--{word}" for word in words]
    code, text, _ = run(capsys, "restart", "to-data", *flags, str(home / "state.20"))
    assert code == 0
    assert run(capsys, "-r2data", str(home / "state.20"), str(home / "ours"), *words)[0] == 0
    assert (home / "ours").read_text() == text
    command = [str(Path(sys.executable).with_name("lmp")), "-log", "none", "-r2data", "state.20", "theirs", *words]
    subprocess.run(command, cwd=home, check=True, capture_output=True, timeout=60)
    assert text == (home / "theirs").read_text()


def test_wrong_use(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "text").write_text("no restart file\n")
    code, _, said = run(capsys, "restart", "info", str(tmp_path / "text"))
    assert code == 1 and said.startswith("ERROR: Invalid LAMMPS restart file\n") and str(tmp_path / "text") in said
    code, _, said = run(capsys, "restart", "info", str(tmp_path / "none"))
    assert code == 1 and "Cannot open restart file" in said
    assert run(capsys, "restart")[0] == 2
