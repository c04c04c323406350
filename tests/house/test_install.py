"""Ways to have pylmp: a wheel, a source distribution, an editable install, a bare checkout. Each finds its grammar."""

from __future__ import annotations

import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SCRIPT = "units lj\nvariable a equal 2^3+1\nprint 'nine: $(v_a) ${a}'\n"


def run(*words: str | Path, cwd: Path, path: Path | None = None) -> str:
    environment = {**os.environ, "PYTHONPATH": str(path or ""), "PYTHONSAFEPATH": "1"}
    done = subprocess.run(list(map(str, words)), cwd=cwd, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def works(folder: Path, path: Path) -> None:
    """pylmp found on path alone reads a script; path is where its package and its grammar come from."""
    (folder / "in.script").write_text(SCRIPT)
    assert "nine: 9 9" in run(sys.executable, "-m", "pylmp", "in.script", cwd=folder, path=path)
    line = "import pylmp; from pylmp.text import grammar; print(pylmp.__file__, grammar.folder(), sep='\\n')"
    package, grammar = run(sys.executable, "-c", line, cwd=folder, path=path).split()
    assert path in Path(package).parents
    assert path in Path(grammar).parents


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("built")
    run(sys.executable, "-m", "hatchling", "build", "-d", folder, cwd=ROOT)
    return folder


def test_a_wheel(built: Path, tmp_path: Path) -> None:
    (wheel,) = built.glob("*.whl")
    run(
        sys.executable,
        "-m",
        "pip",
        "install",
        "--no-deps",
        "--no-index",
        "--target",
        tmp_path / "site",
        wheel,
        cwd=tmp_path,
    )
    works(tmp_path, tmp_path / "site")
    console = tmp_path / "site" / "bin" / "pylmp"
    assert "pylmp 0" in run(console, "--version", cwd=tmp_path, path=tmp_path / "site")


def test_a_wheel_holds_the_package_and_nothing_else(built: Path) -> None:
    (wheel,) = built.glob("*.whl")
    names = zipfile.ZipFile(wheel).namelist()
    assert {name.split("/")[0].partition("-")[0] for name in names} == {"pylmp"}
    assert {Path(name).name for name in names if name.startswith("pylmp/grammar/")} == {
        path.name for path in (ROOT / "grammar").iterdir()
    }
    assert any(name.endswith("licenses/LICENSE") for name in names)
    assert not [name for name in names if "__pycache__" in name]


def test_a_source_distribution(built: Path, tmp_path: Path) -> None:
    (source,) = built.glob("*.tar.gz")
    with tarfile.open(source) as archive:
        archive.extractall(tmp_path, filter="data")
    (unpacked,) = tmp_path.glob("pylmp-*")
    for name in (
        "Makefile",
        "LICENSE",
        "README.md",
        "tests/support.py",
        "inputs/quartic_pull/in.quartic_pull",
        ".ci/run",
    ):
        assert (unpacked / name).is_file(), name
    works(tmp_path, unpacked)
    run(sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", tmp_path / "again", cwd=unpacked)
    (first,), (second,) = built.glob("*.whl"), (tmp_path / "again").glob("*.whl")
    assert zipfile.ZipFile(first).namelist() == zipfile.ZipFile(second).namelist()


def test_a_bare_checkout(tmp_path: Path) -> None:
    works(tmp_path, ROOT)


def test_an_editable_install(tmp_path: Path) -> None:
    """The one the tests run in: make test installs it."""
    package = run(sys.executable, "-c", "import pylmp; print(pylmp.__file__)", cwd=tmp_path).strip()
    assert Path(package).parents[1] == ROOT
    (tmp_path / "in.script").write_text(SCRIPT)
    assert "nine: 9 9" in run(Path(sys.executable).with_name("pylmp"), "in.script", cwd=tmp_path)
