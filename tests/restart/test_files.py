"""LAMMPS and pylmp write the same restart file, byte by byte, and go on from one another's as from their own."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from pylmp.io.restart.decode import decode
from pylmp.io.restart.encode import encode
from pylmp.io.restart.layout import MAGIC
from tests.restart.both import Pair, differences
from tests.restart.scenes import SCENES

STEPS = 40
DECKS = Path(__file__).parents[1] / "decks" / "command"


@pytest.mark.parametrize("name", SCENES)
def test_same_bytes_and_same_future(name: str, tmp_path: Path) -> None:
    """A file of a run's middle, one of its end, and one of the end of a run continued from LAMMPS's file."""
    setup, again = SCENES[name]
    both = Pair(tmp_path)
    run = f"run {STEPS} post no\n"
    both.run(f"{setup}{again}{run}write_restart middle\n{run}write_restart end\n")
    for file in ("middle", "end"):
        assert differences(*both.files(file)) == []
    shutil.copy(both.lammps / "middle", both.pylmp / "middle")
    newton = next((line for line in setup.splitlines() if line.startswith("newton")), "")
    both.run(f"{newton}\nread_restart middle\n{again}{run}write_restart again\n")
    assert differences(*both.files("again")) == []


@pytest.mark.parametrize("name", SCENES)
def test_content_to_bytes_is_the_inverse(name: str, tmp_path: Path) -> None:
    setup, again = SCENES[name]
    both = Pair(tmp_path)
    both.run(f"{setup}{again}run 5 post no\nwrite_restart one\nwrite_restart set.%\n")
    data = (both.lammps / "one").read_bytes()
    assert encode(decode(data, "one")) == [data]
    base, piece = ((both.lammps / f"set.{part}").read_bytes() for part in ("base", "0"))
    assert [base, piece] == [(both.pylmp / f"set.{part}").read_bytes() for part in ("base", "0")]
    assert encode(decode(base, "set.base", lambda number: (piece, f"set.{number}"))) == [base, piece]


def test_files_of_a_run(tmp_path: Path) -> None:
    """All files that the deck of the restart command leaves, atoms in files of their own included."""
    both = Pair(tmp_path)
    both.run((DECKS / "restart.in").read_text())
    names = sorted(path.name for path in both.lammps.iterdir() if path.read_bytes()[-16:] == MAGIC)
    assert len(names) > 15
    for name in names:
        first, second = both.files(name)
        assert first == second, name
