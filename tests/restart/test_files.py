"""LAMMPS and pylmp write the same restart file, byte by byte, and go on from one another's as from their own."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from pylmp.io.restart.decode import decode
from pylmp.io.restart.encode import encode
from pylmp.io.restart.layout import MAGIC
from tests.restart.both import Pair, differences
from tests.restart.scenes import BPM, KEPT_OTHERWISE, NET, NVE, PLASTIC, SCENES, setup

STEPS = 40
DECKS = Path(__file__).parents[1] / "decks" / "command"


@pytest.mark.parametrize("name", SCENES)
def test_same_bytes_and_same_future(name: str, tmp_path: Path) -> None:
    """A file of a run's middle, one of its end, and one of the end of a run continued from LAMMPS's file."""
    begin, again = SCENES[name]
    both = Pair(tmp_path)
    run = f"run {STEPS} post no\n"
    written = ("middle", "end") if name not in KEPT_OTHERWISE else ()
    both.run(f"{begin}{again}{run}write_restart middle\n{run}write_restart end\n", *written)
    ours = (both.pylmp / "middle").read_bytes()
    shutil.copy(both.lammps / "middle", both.pylmp / "middle")
    (both.lammps / "middle").write_bytes(ours)  # each goes on from the other's
    newton = next((line for line in begin.splitlines() if line.startswith("newton")), "")
    go_on = f"{newton}\nread_restart middle\n{again}{run}write_restart again\n"
    if name not in KEPT_OTHERWISE:
        both.run(go_on, "again")
        return
    both.run(go_on)
    found = differences(*both.files("again"))
    assert not found or (found[0].startswith("fixes") and len(found) == 1)


@pytest.mark.parametrize("name", SCENES)
def test_content_to_bytes_is_the_inverse(name: str, tmp_path: Path) -> None:
    begin, again = SCENES[name]
    both = Pair(tmp_path)
    both.run(f"{begin}{again}run 5 post no\nwrite_restart one\nwrite_restart set.%\n")
    data = (both.lammps / "one").read_bytes()
    assert encode(decode(data, "one")) == [data]
    if name in KEPT_OTHERWISE:
        return
    base, piece = ((both.lammps / f"set.{part}").read_bytes() for part in ("base", "0"))
    assert [base, piece] == [(both.pylmp / f"set.{part}").read_bytes() for part in ("base", "0")]
    assert encode(decode(base, "set.base", lambda number: (piece, f"set.{number}"))) == [base, piece]


def test_a_box_goes_on_changing(tmp_path: Path) -> None:
    """The ramp of fix deform refers to the box of its definition, which a restart file keeps."""
    both = Pair(tmp_path)
    again = "fix 1 all nve\nfix 2 all deform 1 x final -0.2 6.3 y volume xy delta 0.7 xz trate 0.5 z wiggle 0.2 1.0 flip yes\n"
    both.run(f"{SCENES['triclinic'][0]}{again}run 10\nrun 10 start 0 stop 60\nwrite_restart ramp\n")
    for file in both.files("ramp"):
        for folder in (both.lammps, both.pylmp):
            (folder / "ramp").write_bytes(file)
        table = "thermo 10\nthermo_style custom step temp press lx ly lz xy xz yz\nthermo_modify format float %.17g\n"
        both.run(f"read_restart ramp\n{again}{table}run 20 start 0 stop 60\n")


def test_files_of_a_run(tmp_path: Path) -> None:
    """All files that the deck of the restart command leaves, atoms in files of their own included."""
    both = Pair(tmp_path)
    both.run((DECKS / "restart.in").read_text())
    names = sorted(path.name for path in both.lammps.iterdir() if path.read_bytes()[-16:] == MAGIC)
    assert len(names) > 15
    for name in names:
        first, second = both.files(name)
        assert first == second, name


SEQUENCES = {
    "files of the run": "restart 7 file\nrun 40\nwrite_restart file.end noinit\nrun 20\nwrite_restart file.last",
    "few rebuilds": "neigh_modify every 50 delay 50\nrestart 7 file\nrun 40\nrestart 0\nrun 20\nwrite_restart file.last noinit",
    "one after the other": "run 40\nwrite_restart file.1 noinit\nwrite_restart file.2\nwrite_restart file.3\nrun 20\nwrite_restart file.4",
    "a data file first": "run 40\nwrite_data data\nwrite_restart file.1\nrun 20\nwrite_restart file.2 noinit",
    "bonds counted first": "run 40\ndelete_bonds all stats\nwrite_restart file.1\nrun 20\nwrite_restart file.2",
    "runs without set-up": "run 40\nrun 20 pre no\nwrite_restart file.1 noinit\nrun 20 pre no\nwrite_restart file.2 noinit\nrun 20\nwrite_restart file.3",
    "atoms changed": "run 40\nvelocity all create 1 123 loop geom\nset atom 5 type 1\nwrite_restart file.1 noinit\nrun 20 pre no\nwrite_restart file.2",
}  # fmt: skip


@pytest.mark.parametrize("name", SEQUENCES)
@pytest.mark.parametrize("walls", ["p p p", "p s m"])
def test_what_bonds_remember(name: str, walls: str, tmp_path: Path) -> None:
    """When LAMMPS copies it from its list to the atoms, and when it forgets to: files and trajectories show both."""
    both = Pair(tmp_path)
    rest = NET + BPM + PLASTIC.format(words="")
    both.run(f"{setup(rest, newton='on off', boundary=walls, heat=2.0)}{NVE}{SEQUENCES[name]}\n", *re.findall(r"write_restart (\S+)", SEQUENCES[name]))
    names = sorted(path.name for path in both.lammps.glob("file.*"))
    assert len(names) > 1
    for file in names:
        assert differences(*both.files(file)) == [], file


WAITING = {
    "twice": "fix 2 all spring/self 10\nunfix 2\nfix 2 all spring/self 10",
    "replaced": "fix 2 few spring/self 5 x\nfix 2 few spring/self 6",
    "of another style": "fix 2 all nve",
    "of another ID": "fix 2 all temp/rescale 5 1 1 .1 .5\nfix 3 all spring/self 10",
    "too late": "fix 3 all temp/rescale 5 1 1 .1 .5\nrun 0 post no\nfix 2 few spring/self 10",
    "a file in between": "write_restart file.0\nfix 2 few spring/self 5",
    "never": "",
}


@pytest.mark.parametrize("name", WAITING)
def test_what_waits_for_its_fix(name: str, tmp_path: Path) -> None:
    both = Pair(tmp_path)
    begin = setup("group few id 1:20\n", "atomic") + NVE
    keep = "fix 2 few spring/self 10\nfix 3 all temp/rescale 5 1 1 .1 .5\nrun 5 post no\nwrite_restart state\nclear\n"
    both.run(f"{begin}{keep}read_restart state\nfix 1 all nve\n{WAITING[name]}\nrun 10 post no\nwrite_restart file.1\n", "file.1")
