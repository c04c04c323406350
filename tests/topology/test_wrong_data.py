"""Wrong data files: LAMMPS's sentence, file, line and column; nothing else escapes, however garbled the file is."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.topology.support import refused, run_both

GOOD = """title

3 atoms
2 atom types
2 bonds
2 bond types
0 6 xlo xhi
0 6 ylo yhi
0 6 zlo zhi

Masses

1 1
2 2

Pair Coeffs

1 1 1
2 1 1

Bond Coeffs

1 10 1
2 20 1

Atoms

1 1 1 1 1 1
2 1 2 2 1 1
3 1 1 3 1 1

Velocities

1 0 0 0
2 0 1 0
3 0 0 0

Bonds

1 1 1 2
2 2 2 3
"""

# What to replace, by what, and the line and column the error must point at (None: wherever).
WRONG = [
    ("3 atoms", "-3 atoms", (3, 1)),
    ("3 atoms", "x atoms", (3, 1)),
    ("3 atoms", "3.0 atoms", (3, 1)),
    ("3 atoms", "99999999999999999999 atoms", (3, 1)),
    ("3 atoms", "4 atoms", None),
    ("3 atoms", "2 atoms", (30, 1)),
    ("2 atom types", "2 foo types", (4, 1)),
    ("2 bonds", "3 bonds", None),
    ("2 bonds\n", "", None),
    ("2 bond types", "1 bond types", None),
    ("2 bond types\n", "", (5, 1)),
    ("0 6 xlo", "6 0 xlo", None),
    ("0 6 xlo", "0 x xlo", (7, 1)),
    ("0 6 xlo", "0 6-0 xlo", (7, 3)),
    ("0 6 xlo xhi", "0 6 xlo yhi", (7, 1)),
    ("0 6 xlo xhi", "0 6 xlo xhi\n1 ellipsoids", (8, 1)),
    ("0 6 xlo xhi", "0 6 xlo xhi\n0 lines", (8, 1)),
    ("0 6 xlo xhi", "0 6 xlo xhi\n4 angles", (8, 1)),
    ("0 6 xlo xhi", "0 6 xlo xhi\n4 dihedral types", (8, 1)),
    ("0 6 xlo xhi", "0 6 xlo xhi\n4 impropers", (8, 1)),
    ("Masses", "Mass", (11, 1)),
    ("Masses\n\n1 1", "Masses\n1 1", None),
    ("1 1\n2 2", "1 0\n2 2", (13, 3)),
    ("1 1\n2 2", "1 1\n2 -2", (14, 3)),
    ("1 1\n2 2", "1 1\n3 2", (14, 1)),
    ("1 1\n2 2", "1 1\n0 2", (14, 1)),
    ("1 1\n2 2", "1 1\n2 x", (14, 3)),
    ("1 1\n2 2", "1 1\n* 2", (14, 1)),
    ("1 1\n2 2", "1 1\n2", (14, 1)),
    ("1 1\n2 2", "1 1\n2 2 2", (14, 1)),
    ("1 1\n2 2", "1 1#\n2 2", (13, 3)),
    ("1 1 1\n2 1 1\n", "1 1 1\n2 1 x\n", (19, 5)),
    ("1 1 1\n2 1 1\n", "1 1 1\n3 1 1\n", (19, 1)),
    ("1 1 1\n2 1 1\n", "1 1 1\n* 1 1\n", (19, 1)),
    ("1 1 1\n2 1 1\n", "1 1 1\n2 1\n", (19, 3)),
    ("1 1 1\n2 1 1\n", "1 1 1\n2 1 1 1 1\n", (19, 9)),
    ("1 1 1\n2 1 1\n", "1 1 1\n\n2 1 1\n", (19, 1)),
    ("Pair Coeffs\n\n1 1 1\n2 1 1", "PairIJ Coeffs\n\n1 1 1 1\n2 1 1 1\n2 2 1 1", (19, 3)),
    ("2 20 1", "2 20", (24, 3)),
    ("2 20 1", "2 20 1 1", (24, 8)),
    ("2 20 1", "2 20 f", (24, 6)),
    ("2 20 1", "9 20 1", (24, 1)),
    ("2 20 1", "#2 20 1", (24, 1)),
    ("Bond Coeffs", "Angle Coeffs", (21, 1)),
    ("Bond Coeffs", "BondBond Coeffs", (21, 1)),
    ("Atoms", "Atoms foo", (26, 1)),
    ("Atoms\n\n", "Atoms\n", None),
    ("Atoms\n\n", "Atoms\n\n\n", (28, 1)),
    ("1 1 1 1 1 1\n", "1 1 1 1 1\n", (28, 1)),
    ("1 1 1 1 1 1\n", "1 1 1 1 1 1 0\n", (28, 1)),
    ("1 1 1 1 1 1\n", "1 1 1 1 1 1 0 0 0\n", (29, 1)),
    ("2 1 2 2 1 1\n", "2 1 2 2 1 1 0 0 0\n", (29, 1)),
    ("2 1 2 2 1 1\n", "\n2 1 2 2 1 1\n", None),
    ("2 1 2 2 1 1\n", "#2 1 2 2 1 1\n", None),
    ("2 1 2 2 1 1\n", "0 1 2 2 1 1\n", (29, 1)),
    ("2 1 2 2 1 1\n", "-2 1 2 2 1 1\n", (29, 1)),
    ("2 1 2 2 1 1\n", "x 1 2 2 1 1\n", (29, 1)),
    ("2 1 2 2 1 1\n", "4000000000 1 2 2 1 1\n", (29, 1)),
    ("2 1 2 2 1 1\n", "2 m 2 2 1 1\n", (29, 3)),
    ("2 1 2 2 1 1\n", "2 1 3 2 1 1\n", (29, 5)),
    ("2 1 2 2 1 1\n", "2 1 0 2 1 1\n", (29, 5)),
    ("2 1 2 2 1 1\n", "2 1 -1 2 1 1\n", (29, 5)),
    ("2 1 2 2 1 1\n", "2 1 2.0 2 1 1\n", (29, 5)),
    ("2 1 2 2 1 1\n", "2 1 2 x 1 1\n", (29, 7)),
    ("2 1 2 2 1 1\n", "2 1 2 nan 1 1\n", (29, 7)),
    ("2 1 2 2 1 1\n", "2 1 2 1e400 1 1\n", (29, 7)),
    ("2 1 2 2 1 1\n", "2 1 2 0x10 1 1\n", (29, 7)),
    ("2 1 2 2 1 1\n", "2 1 2 1_0 1 1\n", (29, 7)),
    ("2 1 2 2 1 1\n3", "2 1 2 1 1 1#y\n3", (29, 11)),
    ("3 1 1 3 1 1\n", "3 1 1 3 1 1\n4 1 1 3 1 1\n", (31, 1)),
    ("Velocities", "Ellipsoids", (32, 1)),
    ("2 0 1 0", "2 0 1", (35, 1)),
    ("2 0 1 0", "2 0 1 0 0", (35, 1)),
    ("2 0 1 0", "7 0 1 0", (35, 1)),
    ("2 0 1 0", "0 0 1 0", (35, 1)),
    ("2 0 1 0", "i 0 1 0", (35, 1)),
    ("2 0 1 0", "2 0 y 0", (35, 5)),
    ("2 2 2 3", "2 2 2 2", (41, 1)),
    ("2 2 2 3", "2 2 2 9", (41, 1)),
    ("2 2 2 3", "2 2 -2 3", (41, 1)),
    ("2 2 2 3", "2 2 z 3", (41, 5)),
    ("2 2 2 3", "2 0 2 3", (41, 1)),
    ("2 2 2 3", "2 3 2 3", (41, 1)),
    ("2 2 2 3", "2 -1 2 3", (41, 3)),
    ("2 2 2 3", "2 t 2 3", (41, 3)),
    ("2 2 2 3", "2 2 2", (41, 1)),
    ("2 2 2 3", "2 2 2 3 3", (41, 1)),
    ("2 2 2 3", "\n2 2 2 3", None),
    ("2 2 2 3", "#2 2 2 3", None),
    ("2 2 2 3\n", "", None),
    ("Velocities\n\n1 0 0 0\n2 0 1 0\n3 0 0 0\n", "Velocities\n\n1 0 0 0\n", None),
    ("\nBonds\n\n1 1 1 2\n2 2 2 3\n", "", (5, 3)),
    (GOOD[GOOD.index("Atoms\n") : GOOD.index("Velocities")], "", (26, 1)),
    (GOOD[GOOD.index("Masses") :], "", None),
]
HEAD = "units lj\natom_style bond\npair_style lj/cut 2.0\nbond_style harmonic\n"
READ = f"{HEAD}read_data wrong.data\n"


@pytest.mark.parametrize(("old", "new", "place"), WRONG, ids=[f"{k}" for k in range(len(WRONG))])
def test_sentence_and_place(old: str, new: str, place: tuple[int, int] | None, tmp_path: Path) -> None:
    assert old in GOOD
    reference, ours = run_both(f"{HEAD}read_data in.data\n", tmp_path, {"in.data": GOOD.replace(old, new, 1)})
    assert reference.error and ours.error == reference.error
    if place is not None:
        error = refused(READ, GOOD.replace(old, new, 1), tmp_path)
        assert error is not None and error.span is not None
        assert (error.span.line, error.span.column) == place
        assert error.span.file.endswith("wrong.data")


def test_files_that_lammps_misreads_are_refused(tmp_path: Path) -> None:
    """LAMMPS overlooks a surplus last line, and notices equal IDs only when a bond is missing."""
    error = refused(READ, GOOD.replace("2 bonds", "1 bonds"), tmp_path)
    assert error is not None and error.message == "Unknown identifier in data file: 2 2 2 3"
    error = refused(READ, GOOD.replace("2 1 2 2 1 1\n", "1 1 2 2 1 1\n"), tmp_path)
    assert error is not None and error.message == "Duplicate atom IDs exist"


def test_the_good_file_is_good(tmp_path: Path) -> None:
    reference, ours = run_both(f"{HEAD}read_data in.data\n", tmp_path, {"in.data": GOOD})
    assert reference.error == ours.error == ""
    assert refused(READ, GOOD, tmp_path) is None


def test_truncated_anywhere(tmp_path: Path) -> None:
    for end in range(0, len(GOOD) - 10, 7):
        error = refused(READ, GOOD[:end], tmp_path)
        if "3 atoms\n" in GOOD[:end]:
            assert error is not None and error.span is not None


KEYWORDS = [
    "read_data",
    "read_data nofile.data",
    "read_data in.data foo",
    "read_data in.data\nread_data in.data",
    "read_data in.data add append",
    "read_data in.data add",
    "read_data in.data add foo",
    "read_data in.data\nread_data in.data add foo 1",
    "read_data in.data extra/bond/per/atom",
    "read_data in.data extra/bond/per/atom x",
    "read_data in.data extra/bond/per/atom -1",
    "read_data in.data extra/special/per/atom -1",
    "read_data in.data extra/bond/types -1",
    "read_data in.data extra/atom/types -1",
    "read_data in.data extra/angle/types 1",
    "read_data in.data extra/dihedral/types 1",
    "read_data in.data extra/improper/types 1",
    "read_data in.data shift 1 2",
    "read_data in.data shift 1 2 x",
    "read_data in.data shift 1 2 3",
    "dimension 2\nboundary p p f\nread_data in.data",
    "dimension 2\nread_data in.data",
    "pair_style none\nread_data in.data",
    "bond_style none\nread_data in.data",
    "write_data out.data",
    "read_data in.data\nwrite_data",
    "read_data in.data\nwrite_data out.data foo",
    "read_data in.data\nwrite_data out.data pair",
    "read_data in.data\nwrite_data out.data pair all",
    "read_data in.data\nwrite_data out.data types",
    "read_data in.data\nwrite_data out.data types words",
    "read_data in.data\nwrite_data out.data triclinic/general",
    "read_data in.data\nwrite_data nofolder/out.data",
    "read_data in.data\nset atom 2 x 14.5\nwrite_data out.data",
]


@pytest.mark.parametrize("script", KEYWORDS)
def test_keywords(script: str, tmp_path: Path) -> None:
    reference, ours = run_both(f"{HEAD}{script}\n", tmp_path, {"in.data": GOOD})
    assert reference.error and ours.error == reference.error
