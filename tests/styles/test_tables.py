"""Files of tables, sound and broken: what LAMMPS says and computes of each, live on both programs in one process."""

from __future__ import annotations

import os
import random
import re
from pathlib import Path

import numpy as np
import pytest

from pylmp.model import table_file
from pylmp.text.diagnostic import ScriptError, Unsupported
from tests.setup.both import difference
from tests.support import simulate

BOX = """units {units}
atom_style bond
region b block 0 12 0 9 0 9
create_box 2 b bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 40
create_atoms 1 single 3 3 3
create_atoms 2 single {x} 3.1 3.2
mass * 1
"""
BOND = """pair_style zero 2.0
pair_coeff * *
special_bonds lj/coul 0 1 1
create_bonds single/bond 1 1 2
bond_style table {style}
bond_coeff 1 one.table {key}
"""
PAIR = "pair_style table {style}\npair_coeff * * one.table {key}\n"
SHOW = "thermo_style custom step pe pxx pxy\nthermo_modify format float %.17g\nfix 1 all nve\nrun 2\n"
ROWS = "1 0.5 1 1\n2 1 0 0\n3 2 1 -1\n"
GOOD = f"ONE\nN 3\n\n{ROWS}"


def table(kind: str, style: str, key: str = "ONE", x: float = 4.0, units: str = "lj") -> str:
    return BOX.format(units=units, x=x) + (BOND if kind == "bond" else PAIR).format(style=style, key=key) + SHOW


def same(folder: Path, text: str | bytes, script: str) -> None:
    (folder / "one.table").write_bytes(text if isinstance(text, bytes) else text.encode())
    before = os.getcwd()
    os.chdir(folder)
    try:
        assert difference(script, folder) == ""
    finally:
        os.chdir(before)


def section(line: str = "N 3", rows: str = ROWS, key: str = "ONE", head: str = "", skipped: str = "") -> str:
    return f"{head}{key}\n{line}\n{skipped}\n{rows}"


FILES = {
    "empty": "", "blank": "\n", "no such keyword": section(key="TWO"), "lower case": section(key="one"),
    "no N": section("FP 1 2"), "unknown word": section("N 3 FOO 2"), "lower case n": section("n 3"),
    "fewer rows": section("N 5"), "cut within a row": section("N 5")[:-3], "next table begins": section("N 5") + "\n" + section(key="TWO"),
    "nothing behind the parameters": "ONE\nN 5\n", "no rows": "ONE\nN 5\n\n", "short row": section(rows="1 0.5 1\n"),
    "only an index": section(rows="1\n"), "a word": section(rows="1 0.5 abc 1\n"), "a word as index": section(rows="x 0.5 1 1\n"),
    "a fraction as index": section(rows="1.0 0.5 1 1\n"), "too large": section(rows="1 0.5 1e999 1\n"),
    "FORTRAN's exponent": section(rows="1 0.5 1d0 1\n"), "too large an index": section(rows="2147483648 0.5 1 1\n"),
    "no number behind N": section("N"), "N is a word": section("N x"), "N is a fraction": section("N 2.0"),
    "one row": section("N 1"), "N is 0": section("N 0"), "N is too large": section("N 10000000000"), "N is large": section("N 1000000000"),
    "N twice": section("N 2 N 3"), "descending": section(rows="1 2 1 1\n2 1 0 0\n3 0.5 1 -1\n"),
    "no skipped line": f"ONE\nN 3\n{ROWS}", "a row is skipped": f"ONE\nN 3\n{ROWS}4 3 2 1\n", "more columns": section().replace("1 1\n", "1 1 7 8\n"),
    "comments": section(rows=ROWS.replace("2 1 0", "# c\n\n2 1 0").replace("\n", " # x\n", 1)), "words behind the keyword": section(key="ONE more"),
    "indented": section("  N 3", key="   ONE"), "twice": section() + section(rows=ROWS.replace("1\n", "2\n")),
    "keyword inside a row": "1 0.5 ONE\nTWO\n" + section(), "keyword as a row": section("N 2", "ONE 0.5 1 1\n2 1 0 0\n", "TWO") + section(),
    "keyword in a comment": section(head="# ONE\n"), "comments behind words": section("N 3 # foo", key="ONE # hello"),
    "other units": section(head="# UNITS: real\n"), "these units": section(head="# UNITS: lj\n"), "no units": section(head="# UNITS:\n"),
    "a date": section(head="# DATE: 2020-02-03 UNITS: lj CONTRIBUTOR: me\n"), "a date without #": section(head="DATE: 2020-02-03 UNITS: lj\n"),
    "a date and other units": section(head="# table DATE: 2020-02-03 UNITS: real\n"), "units that are none": section(head="# UNITS: bogus\n"),
    "units in the second line": section(head="# hello\n# UNITS: real\n"), "two rows": section("N 2", "1 0.5 1 1\n2 2 0 0.5\n"),
    "forces of other energies": section("N 4", "1 0.5 1 1\n2 1 0 5\n3 1.5 1 -7\n4 2 1 -1\n"), "DOS": section().replace("\n", "\r\n"),
    "tabs": section().replace(" ", "\t"), "a long comment": section(head=f"# {'x' * 3000}\n"),
    "distances that fall": section("N 4", "1 0.5 1 1\n2 1.5 0 0\n3 0.9 1 -1\n4 2 1 -1\n"), "below zero": section(rows="1 -0.5 1 1\n2 1 0 0\n3 2 1 -1\n"),
    "from zero": section(rows="1 0 1 1\n2 1 0 0\n3 2 1 -1\n"), "hexadecimal": section(rows="1 0.5 0x1.8p1 1\n2 1 +0 0.\n3 2 .1e1 -1\n"),
    "not a number": section(rows="1 0.5 nan 1\n2 1 0 0\n3 2 1 -1\n"), "a zero byte": section(rows="1 0.5\0 1 1\n"), "beyond ASCII": section(head="ONÉ\n"),
    "a byte beyond": b"\xff\n" + GOOD.encode(),
}  # fmt: skip
BOND_FILES = {
    "FP and one number": section("N 3 FP 1"), "FP": section("N 3 FP"), "FP, words": section("N 3 FP 1 x"), "EQ": section("N 3 EQ"),
    "EQ, a word": section("N 3 EQ x"), "all words": section("EQ 1.1 FP 3 4 N 3"), "FPRIME": section("N 3 FPRIME 1 2"),
}  # fmt: skip
PAIR_FILES = {
    "FP": section("N 3 FP 2 3"), "EQ": section("N 3 EQ 2"), "FPRIME": section("N 3 FPRIME 2 3"), "R and one number": section("N 3 R 1"),
    "R": section("N 3 R"), "R, a word": section("N 3 R x 3"), "R and FPRIME": section("FPRIME 1 -2 R 0.5 2.0 N 3"), "R, other distances": section("N 3 R 0.5 2.5"),
    "R, descending": section("N 3 R 2.5 0.5"), "R from zero": section("N 3 R 0 2"), "RSQ from zero": section("N 3 RSQ 0 2"),
    "R from below zero": section("N 3 R -1 2"), "RSQ": section("N 3 RSQ 0.5 2"), "one row, R": section("N 1 R 0.5 2"),
    "BITMAP": section("N 4 BITMAP 0.5 2", ROWS + "4 2 1 1\n"), "BITMAP, no power of two": section("N 3 BITMAP 0.5 2"),
    "bad forces, other distances": section("N 4 R 0.5 2", "1 0.5 1 1\n2 1.1 0 5\n3 1.5 1 -7\n4 2 1 -1\n", head="# DATE: 2020-01-01\n"),
}  # fmt: skip


@pytest.mark.parametrize("name", [*FILES, *(f"bond, {name}" for name in BOND_FILES)])
def test_file_of_bonds(name: str, tmp_path: Path) -> None:
    same(tmp_path, (FILES | {f"bond, {key}": text for key, text in BOND_FILES.items()})[name], table("bond", "spline 20"))


@pytest.mark.parametrize("name", [*FILES, *(f"pair, {name}" for name in PAIR_FILES)])
def test_file_of_pairs(name: str, tmp_path: Path) -> None:
    same(tmp_path, (FILES | {f"pair, {key}": text for key, text in PAIR_FILES.items()})[name], table("pair", "linear 20"))


@pytest.mark.parametrize("cut", ["0.5", "1.99999", "2.0", "2.00001", "-1", "x", "1.5 2"])
@pytest.mark.parametrize("line", ["N 3", "N 3 R 0.5 2.0", "N 3 RSQ 0.5 2.0"])
def test_cutoff(cut: str, line: str, tmp_path: Path) -> None:
    same(tmp_path, section(line), table("pair", "spline 20", f"ONE {cut}"))


@pytest.mark.parametrize("size", [2, 3, 4, 5, 12, 31])
@pytest.mark.parametrize("ends", ["0.5 2", "0.001 2", "1 1.4"])
def test_number_of_bits(size: int, ends: str, tmp_path: Path) -> None:
    same(tmp_path, section(f"N 3 R {ends}"), table("pair", f"bitmap {size}"))


@pytest.mark.parametrize("units", [("real", "metal"), ("metal", "real"), ("metal", "metal"), ("si", "metal"), ("real", "lj")])
@pytest.mark.parametrize("kind", ["bond", "pair"])
def test_units(units: tuple[str, str], kind: str, tmp_path: Path) -> None:
    """LAMMPS converts pair tables between real and metal units, but not the slopes at their ends."""
    line = "N 3 FP 0.3 -0.7" if kind == "bond" else "N 3 FPRIME 0.3 -0.7"
    same(tmp_path, section(line, head=f"# UNITS: {units[0]}\n"), table(kind, "spline 9", units=units[1]))


DICE = random.Random(11)
REACHES = [(kind, style, x) for x in (0.3, 0.5, 0.999, 1.0, 1.7, 1.9, 1.98, 2.3) for kind, style in (
    ("bond", "linear 15"), ("bond", "linear 2"), ("bond", "spline 15"), ("pair", "lookup 15"), ("pair", "linear 15"), ("pair", "spline 3"),
    ("pair", "bitmap 6"),
)]  # fmt: skip


@pytest.mark.parametrize(("kind", "style", "x"), REACHES)
def test_ends_of_a_table(kind: str, style: str, x: float, tmp_path: Path) -> None:
    """A little beyond, LAMMPS goes on, farther it stops."""
    if x >= 1.9 and style in ("spline 15", "linear 2") and kind == "bond":
        pytest.skip("LAMMPS reads memory that it never wrote")
    rows = "".join(f"{k} {0.5 + 0.05 * k} {DICE.uniform(-1, 1)} {DICE.uniform(-9, 9)}\n" for k in range(29))
    script = table(kind, style, x=3.0 + x).replace(" 3.1 3.2", " 3 3").replace("run 2", "run 0")
    same(tmp_path, section("N 29", rows), script)


@pytest.mark.parametrize("seed", range(12))
def test_random_tables(seed: int, tmp_path: Path) -> None:
    """Random values at random distances, in all styles, with and without slopes and spacings."""
    dice = random.Random(seed)
    n, low, high = dice.randint(2, 40), dice.uniform(0.3, 0.9), dice.uniform(1.2, 2.5)
    places = sorted([low, high, *(dice.uniform(low, high) for _ in range(n - 2))])
    rows = "".join(f"{k} {r:.9g} {dice.uniform(-5, 5):.9g} {dice.gauss(0, 30):.9g}\n" for k, r in enumerate(places))
    slopes = f" FP{{}} {dice.gauss(0, 9):.5g} {dice.gauss(0, 9):.5g}" if dice.random() < 0.5 else ""
    x = 3.0 + dice.uniform(max(low, 0.35), high)
    size = dice.randint(2, 60)
    for style in ("linear", "spline"):
        same(tmp_path, section(f"N {n}{slopes.format('')}", rows), table("bond", f"{style} {size}", x=x))
    spacing = dice.choice(("", f" R {low:.9g} {high:.9g}", f" RSQ {low:.9g} {high:.9g}"))
    cut = dice.choice(("ONE", f"ONE {dice.uniform(1.0, high):.5g}"))
    for style in ("lookup", "linear", "spline", "bitmap"):
        wide = dice.randint(6, 12) if style == "bitmap" else size
        same(tmp_path, section(f"N {n}{slopes.format('RIME')}{spacing}", rows), table("pair", f"{style} {wide}", cut, x=x))


@pytest.mark.parametrize(("kind", "style"), [("bond", "spline 20"), ("pair", "bitmap 8")])
@pytest.mark.parametrize("end", range(0, len(GOOD) - 2, 4))
def test_cut_anywhere_names_file_and_line(kind: str, style: str, end: int, tmp_path: Path) -> None:
    (tmp_path / "one.table").write_text(GOOD[:end])
    with pytest.raises(ScriptError) as caught:
        simulate(table(kind, style), tmp_path)
    assert re.fullmatch(r"one\.table", caught.value.diagnostic.span.file)
    assert 1 <= caught.value.diagnostic.span.line <= GOOD[:end].count("\n") + 1


@pytest.mark.parametrize("kind", ["bond", "pair"])
def test_what_lammps_would_crash_on_or_read_wrongly(kind: str, tmp_path: Path) -> None:
    long = section(rows=ROWS.replace("1 0.5 1 1", "1 0.5 1 1" + " 7" * 600))
    wrong = {"ONE\n# a\n\n": "parameters did not set N", section("N -3"): "Invalid", long: "longer than 1023 characters", GOOD + "x" * 50: ""}
    for text, says in wrong.items():
        (tmp_path / "one.table").write_text(text)
        if not says:
            simulate(table(kind, "linear 20"), tmp_path)
            continue
        with pytest.raises(ScriptError, match=says):
            simulate(table(kind, "linear 20"), tmp_path)
    with pytest.raises(ScriptError, match="Is a directory"):
        simulate(table(kind, "linear 20").replace("one.table", "."), tmp_path)
    with pytest.raises(Unsupported):
        simulate(table(kind, f"linear {2**30}"), tmp_path)
    if kind == "pair":
        (tmp_path / "one.table").write_text(section("N 3 R 0.001 2"))
        with pytest.raises(Unsupported, match=r"tables of 2\^26 values"):
            simulate(table(kind, "bitmap 26"), tmp_path)


def test_beyond_a_spline_of_bonds_it_stops(tmp_path: Path) -> None:
    (tmp_path / "one.table").write_text(GOOD)
    with pytest.raises(ScriptError, match=r"Bond length > table outer cutoff: type 1 length 2\.01"):
        simulate(table("bond", "spline 20", x=5.01).replace(" 3.1 3.2", " 3 3"), tmp_path)


@pytest.mark.parametrize(("kind", "style"), [("bond", "spline 20"), ("bond", "linear 20"), ("pair", "spline 20"), ("pair", "bitmap 6")])
def test_distances_that_are_equal_end_without_a_traceback(kind: str, style: str, tmp_path: Path) -> None:
    """LAMMPS divides by zero there, too."""
    (tmp_path / "one.table").write_text(section(rows="1 0.5 1 1\n2 0.5 0 0\n3 2 1 -1\n"))
    script = table(kind, style)
    if kind == "bond":
        with pytest.raises(ScriptError, match="Illegal bond in bond style table"):
            simulate(script, tmp_path)
    else:
        simulate(script, tmp_path)


def test_slopes_inside_a_table_are_counted() -> None:
    r = np.array([1.0, 2.0, 3.0, 4.0])
    parts = table_file.Section(None, "K", 1, table_file.Parameters(4), r, r * r, -2.0 * r)  # type: ignore[arg-type]
    assert table_file.inconsistent(parts) == 0
    parts.f = -2.0 * r + np.array([99.0, 1.1, -0.9, 99.0])
    assert table_file.inconsistent(parts) == 1
