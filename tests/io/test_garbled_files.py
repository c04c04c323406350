"""Every reader meets garbled files: what comes is a sentence with a place, or numbers that nobody can know to be wrong."""

from __future__ import annotations

import gzip
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings

from tests.garbled import EDITS, Edit, garbled, refusal
from tests.restart.scenes import SCENES
from tests.topology import test_wrong_data as bonded
from tests.topology import test_wrong_sections as full

SIMPLE = """units lj
atom_style atomic
atom_modify map yes
lattice sc 0.8
region b block 0 3 0 3 0 3
create_box 2 b
create_atoms 1 box
mass * 1
pair_style lj/cut 1.2
pair_coeff * * 1 1
velocity all create 1 33
fix 1 all nve
"""
PLASTIC, AGAIN = SCENES["plastic, recorded"]
TILTED, TILTED_AGAIN = SCENES["triclinic"]
HISTORY = (
    "units lj\natom_style bond\nnewton on off\ncomm_modify vel yes\nspecial_bonds lj 0 1 1 coul 1 1 1\npair_style bpm/spring\nread_data wrong bond/history\n"
    "pair_coeff * * 40 1.0 0.8\nbond_style bpm/spring/plastic\nbond_coeff * 80 0.12 0.5 0.02\nfix 1 all nve\nrun 1\nwrite_data out.data\n"
)


@dataclass
class Case:
    """good: a file, by the name under which GOOD has it, or its bytes. script: reads it, called wrong (or wrong.gz)."""

    good: str | bytes
    script: str
    packed: bool = False


CASES = {
    "data": Case(bonded.GOOD.encode(), f"{bonded.HEAD}read_data wrong\nfix 1 all nve\nrun 1\nwrite_data out.data\n"),
    "data, tilted": Case(
        bonded.GOOD.replace("0 6 zlo zhi\n", "0 6 zlo zhi\n0.5 -0.5 1.0 xy xz yz\n").encode(), f"{bonded.HEAD}read_data wrong\nrun 0\n"
    ),
    "data, all sections": Case(
        full.GOOD.encode(), f"{full.HEAD}read_data wrong\npair_coeff * *\nbond_coeff *\nfix 1 all nve\nrun 1\nwrite_data out.data\nreplicate 2 1 1\n"
    ),
    "data, compressed": Case(bonded.GOOD.encode(), f"{bonded.HEAD}read_data wrong.gz\nrun 0\n", packed=True),
    "data, bond/history": Case("history", HISTORY),
    "restart": Case("restart", f"newton on off\nread_restart wrong\n{AGAIN}run 1\n"),
    "restart, tilted": Case("tilted", f"read_restart wrong\n{TILTED_AGAIN}run 1\n"),
    "read_dump": Case("dump", f"{SIMPLE}read_dump wrong 10 x y z vx vy vz ix iy iz purge yes add keep replace no\nrun 1\n"),
    "read_dump, replace": Case("dump", f"{SIMPLE}read_dump wrong 5 x y z vx trim yes\nrun 1\n"),
    "read_dump, compressed": Case("dump", f"{SIMPLE}read_dump wrong.gz 10 x y z\n", packed=True),
    "rerun": Case("dump", f"{SIMPLE}rerun wrong dump x y z vx vy vz\n"),
    "rerun, scaled": Case("scaled", f"{SIMPLE}rerun wrong dump x y z\n"),
    "variable file": Case(b"hello 1\n# c\nword two # three\n\nlast", f'{SIMPLE}variable a file wrong\nlabel l\nprint "$a"\nnext a\njump SELF l\n'),
    "variable atomfile": Case(
        b"# c\n3\n1 2.0\n2 3.5\n7 -1e3\n4\n1 1\n2 2\n3 3\n4 4\n",
        f'{SIMPLE}variable a atomfile wrong\nset atom * vx v_a\nprint "$(v_a[1])"\nnext a\nprint "$(v_a[4])"\n',
    ),
}  # fmt: skip


@cache
def written(folder: Path) -> Path:
    """A folder with good files that pylmp writes."""
    home = folder / "good"
    home.mkdir()
    dumps = "dump 1 all custom 5 dump id type x y z vx vy vz ix iy iz\ndump 2 all atom 5 scaled\n"
    for script in (
        f"{SIMPLE}{dumps}run 10\n",
        f"{PLASTIC}group two type 2\n{AGAIN}run 5\nwrite_restart restart\nwrite_data history nocoeff bond/history\n",
        f"{TILTED}{TILTED_AGAIN}run 5\nwrite_restart tilted\n",
    ):
        assert refusal(script, home) is None
    return home


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.getbasetemp())


def said(case: Case, edits: list[Edit], good: Path, folder: Path):  # type: ignore[no-untyped-def]
    data = case.good if isinstance(case.good, bytes) else (good / case.good).read_bytes()
    if case.packed:
        (folder / "wrong.gz").write_bytes(garbled(gzip.compress(data, mtime=0), edits))
    else:
        (folder / "wrong").write_bytes(garbled(data, edits))
    return refusal(case.script, folder)


@pytest.mark.parametrize("name", CASES)
@settings(
    max_examples=120, deadline=None, derandomize=True, database=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)  # fmt: skip
@given(edits=EDITS)
def test_nothing_but_a_sentence(name: str, edits: list[Edit], good: Path, tmp_path: Path) -> None:
    found = said(CASES[name], edits, good, tmp_path)
    if found is not None:
        assert found.message and found.span is not None and found.span.line >= 1


@pytest.mark.parametrize("name", CASES)
def test_the_good_file_is_good(name: str, good: Path, tmp_path: Path) -> None:
    assert said(CASES[name], [], good, tmp_path) is None
