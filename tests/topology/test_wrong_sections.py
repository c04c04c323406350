"""Wrong data files with angles, dihedrals, impropers, charges, labels: LAMMPS's sentence, file, line and column, however garbled."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.topology.support import refused, run_both

GOOD = """title

5 atoms
2 atom types
2 bonds
2 bond types
2 angles
2 angle types
1 dihedrals
2 dihedral types
1 impropers
1 improper types
0 6 xlo xhi
0 6 ylo yhi
0 6 zlo zhi

Atom Type Labels

1 A
2 B

Angle Type Labels

2 bent
1 straight

Masses

A 1
2 2

Angle Coeffs # zero

1 180
2 120

Dihedral Coeffs

1
2

Improper Coeffs

1

Atoms

1 1 A 0.5 1 1 1
2 1 2 -.5 2 1 1
3 1 1 0 3 1 1
4 1 B 1e-1 3 2 1
5 0 1 0 4 2 1

Bonds

1 1 1 2
2 2 2 3

Angles

1 straight 1 2 3
2 2 2 3 4

Dihedrals

1 2 1 2 3 4

Impropers

1 1 2 1 3 4
"""
HEAD = "units lj\natom_style full\npair_style zero 2.0\nbond_style zero\n" + "".join(
    f"{kind}_style zero\n" for kind in ("angle", "dihedral", "improper")
)
READ = f"{HEAD}read_data wrong.data\n"

# What to replace, by what, and the line and column the error must point at (None: wherever).
WRONG = [
    ("2 angles", "3 angles", None),
    ("2 angles\n", "", None),
    ("2 angles", "x angles", (7, 1)),
    ("2 angle types\n", "", None),
    ("1 dihedrals", "0 dihedrals", None),
    ("1 dihedrals", "2 dihedrals", None),
    ("2 dihedral types\n", "", None),
    ("1 improper types", "0 improper types", None),
    ("1 impropers", "-1 impropers", (11, 1)),
    ("1 A\n2 B", "1 A\n2 A", (17, 1)),
    ("1 A\n2 B", "1 A\n1 B", (17, 1)),
    ("1 A\n2 B", "1 A\n2 2B", (20, 3)),
    ("1 A\n2 B", "1 A\n2 *", (20, 3)),
    ("1 A\n2 B", "1 A\n2", (20, 1)),
    ("1 A\n2 B", "1 A\n2 B C", (20, 1)),
    ("1 A\n2 B", "1 A\nx B", (20, 1)),
    ("1 A\n2 B", "1 A\n\n2 B", None),
    ("Angle Type Labels", "Angel Type Labels", (22, 1)),
    ("Angle Type Labels\n\n2 bent\n1 straight\n\n", "", None),
    ("A 1\n2 2", "A 1\nC 2", (30, 1)),
    ("A 1\n2 2", "A 1\n3 2", (30, 1)),
    ("1 180\n2 120", "1 180\n2 x", (35, 3)),
    ("1 180\n2 120", "1 180\nbent 120", (35, 1)),
    ("1 180\n2 120", "1 180\n3 120", (35, 1)),
    ("1 180\n2 120", "1 180\n2 120 1", (35, 7)),
    ("1 180\n2 120", "1 180\n\n2 120", (35, 1)),
    ("1\n2\n", "1\n2 1\n", (40, 3)),
    ("1\n2\n", "1\nx\n", (40, 1)),
    ("1\n2\n", "1\n\n2\n", (40, 1)),
    ("Improper Coeffs\n\n1", "Improper Coeffs\n\n2", (44, 1)),
    ("Improper Coeffs", "AngleAngle Coeffs\n\n1 2 3\n\nImproper Coeffs", None),
    ("Improper Coeffs", "BondBond Coeffs\n\n1 2 3\n2 2 3\n\nImproper Coeffs", None),
    ("1 1 A 0.5 1", "1 1 C 0.5 1", (48, 5)),
    ("1 1 A 0.5 1", "1 1 -1 0.5 1", (48, 5)),
    ("1 1 A 0.5 1", "1 1 A x 1", (48, 7)),
    ("1 1 A 0.5 1", "1 1 A 1", (48, 1)),
    ("2 1 2 -.5 2", "2 1 2 2", (49, 1)),
    ("2 1 2 -.5 2", "2 1 2 1e400 2", (49, 7)),
    ("2 1 2 -.5 2", "2 1 2 nan 2", (49, 7)),
    ("2 1 2 -.5 2", "2 x 2 -.5 2", (49, 3)),
    ("2 1 2 -.5 2", "2 1 2 y x", (49, 9)),
    ("2 1 2 -.5 2", "2 z 2 y 2", (49, 3)),
    ("2 1 2 -.5 2", "2 1 3 y 2", (49, 7)),
    ("1 straight 1 2 3", "1 bended 1 2 3", (61, 3)),
    ("1 straight 1 2 3", "1 A 1 2 3", (61, 3)),
    ("1 straight 1 2 3", "1 3 1 2 3", (61, 1)),
    ("1 straight 1 2 3", "1 -1 1 2 3", (61, 3)),
    ("2 2 2 3 4\n", "2 2 2 3 9\n", (62, 1)),
    ("2 2 2 3 4\n", "2 2 2 3 3\n", (62, 1)),
    ("2 2 2 3 4\n", "2 2 2 3\n", (62, 1)),
    ("2 2 2 3 4\n", "2 2 2 3 4 5\n", (62, 1)),
    ("2 2 2 3 4\n", "2 2 2 x 4\n", (62, 7)),
    ("2 2 2 3 4\n", "#2 2 2 3 4\n", None),
    ("2 2 2 3 4\n", "", None),
    ("1 2 1 2 3 4", "1 0 1 2 3 4", (66, 1)),
    ("1 2 1 2 3 4", "1 2 1 2 3 1", (66, 1)),
    ("1 2 1 2 3 4", "1 2 1 2 3 0", (66, 1)),
    ("1 2 1 2 3 4", "1 2 1 2 3", (66, 1)),
    ("1 2 1 2 3 4", "1 bent 1 2 3 4", (66, 3)),
    ("1 1 2 1 3 4", "1 2 2 1 3 4", (70, 1)),
    ("1 1 2 1 3 4", "1 1 2 2 3 4", (70, 1)),
    ("1 1 2 1 3 4", "1 1 2 1 3 4 5", (70, 1)),
    ("1 1 2 1 3 4", "1 1 2 1 3 4.0", (70, 11)),
    ("Dihedrals\n\n", "Dihedrals\n", None),
    ("\nImpropers\n\n1 1 2 1 3 4\n", "", (11, 3)),
    ("\nImpropers\n", "\nImpropers\n\n1 1 2 1 3 4\n\nImpropers\n", None),
    ("Masses", "Bond Type Labels\n\n1 b\n2 b\n\nMasses", None),
    ("Angles\n\n", "Angle Type Labels\n\n1 s\n2 t\n\nAngles\n\n", None),
    (GOOD[GOOD.index("Atoms\n") : GOOD.index("Bonds\n")], "", None),
]


@pytest.mark.parametrize(("old", "new", "place"), WRONG, ids=[f"{k}" for k in range(len(WRONG))])
def test_sentence_and_place(old: str, new: str, place: tuple[int, int] | None, tmp_path: Path) -> None:
    assert old in GOOD
    text = GOOD.replace(old, new, 1)
    reference, ours = run_both(f"{HEAD}read_data in.data\n", tmp_path, {"in.data": text})
    assert reference.error and ours.error.split("\n")[0] == reference.error
    error = refused(READ, text, tmp_path)
    assert error is not None and error.span is not None
    assert error.span.file.endswith("wrong.data")
    if place is not None:
        assert (error.span.line, error.span.column) == place


def test_the_good_file_is_good(tmp_path: Path) -> None:
    reference, ours = run_both(f"{HEAD}read_data in.data\n", tmp_path, {"in.data": GOOD})
    assert reference.error == ours.error == ""
    assert refused(READ, GOOD, tmp_path) is None


@pytest.mark.parametrize(
    "line",
    ["2000000000 atom types", "2000000000 angle types", "2000000000 extra dihedral per atom", "1000000 extra special per atom"],
)
def test_counts_that_nobody_means(line: str, tmp_path: Path) -> None:
    """LAMMPS dies for want of memory, or fills it."""
    error = refused(READ, GOOD.replace("0 6 xlo", f"{line}\n0 6 xlo"), tmp_path)
    assert error is not None and error.message.startswith("Data file asks for too many")
    assert error.span is not None and error.span.line == 13


def test_label_numbers_out_of_range(tmp_path: Path) -> None:
    """LAMMPS says `argument not found`."""
    for new in ("1 A\n3 B", "0 A\n2 B"):
        error = refused(READ, GOOD.replace("1 A\n2 B", new), tmp_path)
        assert error is not None and error.message.startswith("Invalid atom type")


def test_truncated_anywhere(tmp_path: Path) -> None:
    for end in range(0, len(GOOD) - 14, 7):
        error = refused(READ, GOOD[:end], tmp_path)
        if "5 atoms\n" in GOOD[:end]:
            assert error is not None and error.span is not None
