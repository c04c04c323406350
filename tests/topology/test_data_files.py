"""read_data and write_data against LAMMPS: every bit of what is read, every line of what is printed and written."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.setup.both import on_lammps, on_pylmp
from tests.topology.support import STORED, Network, difference

BOUNDARIES = ("ppp", "fpp", "psp", "mmm", "sfm", "pps", "fff")


@pytest.mark.parametrize("seed", range(60))
def test_random_networks(seed: int, tmp_path: Path) -> None:
    style = tuple(STORED)[seed % 6]
    dimension = 2 if seed % 5 == 4 else 3
    boundary = "ppp" if dimension == 2 else BOUNDARIES[seed % 7]
    kinds, labeled = STORED[style], seed % 4 == 3
    extra = " ".join(f"extra/{kind}/per/atom {seed % 3 + 1}" for kind in kinds)
    script = f"""
units lj
dimension {dimension}
atom_style {style}
newton on {"off" if seed % 2 else "on"}
boundary {" ".join(boundary)}
special_bonds lj 0 {seed % 3 / 2} {seed % 4 / 3} coul 1 1 1 angle {"yes" if seed % 5 == 1 else "no"} dihedral {"no" if seed % 3 else "yes"}
pair_style zero 1.0
{"".join(f"{kind}_style zero nocoeff" + chr(10) for kind in kinds if seed % 8 < 5)}
read_data in.data {extra + " extra/special/per/atom 2" if kinds and seed % 4 == 0 else ""}
pair_coeff * *
{"".join(f"{kind}_coeff *" + chr(10) for kind in kinds if seed % 8 < 5)}
write_data out.data
write_data bare.data nocoeff nolabelmap
{"write_data named.data types labels" if labeled and seed % 8 < 5 else "shell"}
""".replace("shell\n", "")
    network = Network(seed, style, dimension, boundary, labeled)
    written = ("out.data", "bare.data", "named.data") if "named" in script else ("out.data", "bare.data")
    assert not difference(script, tmp_path, {"in.data": network.text()}, written)


@pytest.mark.parametrize("seed", range(6))
def test_what_pylmp_writes_lammps_reads_back(seed: int, tmp_path: Path) -> None:
    """The same atoms to the last bit, and the same file again."""
    header = f"units lj\natom_style bond\nnewton on {'off' if seed % 2 else 'on'}\n"
    (tmp_path / "in.data").write_text(Network(seed, "bond", 3, "ppp").text())
    ours = on_pylmp(f"{header}read_data in.data\nwrite_data {tmp_path}/one.data\n", tmp_path)
    theirs = on_lammps(f"{header}read_data {tmp_path}/one.data\nwrite_data {tmp_path}/two.data\n", tmp_path)
    assert not ours.error and not theirs.error
    for name in ("id", "type", "x", "v", "image"):
        assert np.array_equal(ours.arrays[name], theirs.arrays[name]), name
    assert (tmp_path / "one.data").read_text() == (tmp_path / "two.data").read_text()


COEFFICIENTS = """title

2 atoms
2 atom types
1 bonds
2 bond types
0 6 xlo xhi
0 6 ylo yhi
0 6 zlo zhi

{coeffs}
Atoms # bond

1 1 1 1 1 1
2 1 2 2 1 1

Bonds

1 1 1 2
"""


@pytest.mark.parametrize(
    ("pair", "bond", "coeffs"),
    [
        ("lj/cut 2.0", "harmonic", "Pair Coeffs # lj/cut\n\n1 1 1\n2 1.5 1.1 1.75\n\nBond Coeffs # harmonic\n\n1 10 1\n2 20 1.1\n"),
        ("lj/cut 2.0", "harmonic", "Bond Coeffs\n\n2 10 1 # last\n1 2 1.1\n\nPairIJ Coeffs\n\n1 1 1 1\n1 2 1 0.5 1.5\n2 2 3 1\n"),
        ("lj/cut 2.0", "quartic", "Pair Coeffs # foo\n\n1 1 1\n2 1 1\n\nBond Coeffs # fene\n\n1 1200 -.55 .25 1.3 34.6878\n2 1 2 3 4 5\n"),
        ("lj/cut/omp 2.0", "zero", "Pair Coeffs # lj/cut\n\n1 1 1\n2 1 1\n\nBond Coeffs # zero\n\n1 1.5\n2 0.5\n"),
        ("zero 2.0", "zero", "Pair Coeffs # zero\n\n1 1.5\n2\n\nBond Coeffs\n\n1 1\n2 1\n"),
        ("bpm/spring", "zero", "Pair Coeffs # bpm/spring\n\n1 1 1.5 0.3\n2 2 1.25 0.5\n\nBond Coeffs\n\n1 1\n2 1\n"),
        ("bpm/spring anharmonic yes", "zero", "Pair Coeffs\n\n1 1 1.5 0.3 2\n2 2 1.25 0.5 3\n\nBond Coeffs\n\n1 1\n2 1\n"),
    ],
)  # fmt: skip
def test_coefficients(pair: str, bond: str, coeffs: str, tmp_path: Path) -> None:
    script = f"""
units lj
atom_style bond
comm_modify vel yes
special_bonds lj/coul 1 1 1
pair_style {pair.replace("/omp", "")}
bond_style {bond}
read_data in.data
mass * 1
write_data out.data
write_data bare.data nocoeff
"""
    assert not difference(script, tmp_path, {"in.data": COEFFICIENTS.format(coeffs=coeffs)}, ("out.data", "bare.data"))


def test_coefficients_that_lammps_would_round_keep_all_digits(tmp_path: Path) -> None:
    coeffs = (
        "Masses\n\n1 0.33333333333333331\n2 2\n\nPair Coeffs\n\n1 1.23456789 1\n2 1e-9 0.30000000000000004\n\n"
        "Bond Coeffs\n\n1 123456789 1\n2 1 2\n"
    )
    (tmp_path / "in.data").write_text(COEFFICIENTS.format(coeffs=coeffs))
    head = "units lj\natom_style bond\npair_style lj/cut 2.0\nbond_style harmonic\n"
    assert not on_pylmp(f"{head}read_data in.data\nwrite_data {tmp_path}/out.data\n", tmp_path).error
    written = (tmp_path / "out.data").read_text()
    sections = {name: written.split(f"{name}\n\n")[1].split("\n\n")[0] for name in ("Masses", "# lj/cut", "# harmonic")}
    numbers = {name: [float(w) for row in rows.split("\n") for w in row.split()[1:]] for name, rows in sections.items()}
    assert numbers["Masses"] == [1 / 3, 2.0]
    assert numbers["# lj/cut"] == [1.23456789, 1.0, 1e-9, 0.1 + 0.2]
    assert numbers["# harmonic"] == [123456789.0, 1.0, 1.0, 2.0]
    assert not on_lammps(f"{head}read_data {tmp_path}/out.data\n", tmp_path).error


def test_pair_ij(tmp_path: Path) -> None:
    script = """
units lj
atom_style bond
pair_style lj/cut 2.0
bond_style harmonic
read_data in.data nocoeff
mass * 1
pair_coeff 1 1 1 1
pair_coeff 2 2 4 1 2.5
bond_coeff * 1 1
write_data out.data pair ij
write_data all.* types numeric nofix nolabelmap pair ii
"""
    coeffs = "Pair Coeffs # none\n\n1 not read\n2 at all\n"
    assert not difference(script, tmp_path, {"in.data": COEFFICIENTS.format(coeffs=coeffs)}, ("all.0",))
    # mixed sigma and cutoff are printed in full here, with 6 digits by LAMMPS
    texts = [(tmp_path / home / "out.data").read_text().splitlines() for home in ("reference", "ours")]
    for reference, ours in zip(*texts, strict=True):
        assert reference == ours or [f"{float(w):g}" for w in ours.split()] == reference.split()


@pytest.mark.parametrize(
    "keywords",
    [
        "add append",
        "add append shift 0 3 0 group two",
        "add 10 5 shift 0 0 -1.5",
        "add merge",
        "add append shift 0.25 0 0 nocoeff",
    ],
)
@pytest.mark.parametrize("newton", ["on", "off"])
def test_add(keywords: str, newton: str, tmp_path: Path) -> None:
    script = f"""
units lj
atom_style bond
newton on {newton}
pair_style lj/cut 2.0
bond_style harmonic
read_data in.data extra/bond/per/atom 1
read_data in.data {keywords}
mass * 1
pair_coeff * * 1 1
bond_coeff * 1 1
write_data out.data
"""
    assert not difference(script, tmp_path, {"in.data": COEFFICIENTS.format(coeffs="")}, ("out.data",))


@pytest.mark.parametrize(("style", "newton"), [("bond", "on"), ("bond", "off"), ("molecular", "off")])
def test_broken_and_off_bonds(style: str, newton: str, tmp_path: Path) -> None:
    """Broken bonds are left out and the count says so; bonds that are off are written as if they were on."""
    coeffs = "Pair Coeffs\n\n1 1 1\n2 1 1\n\nBond Coeffs\n\n1 1200 -.55 .25 1.3 34.6878\n2 1200 -.55 .25 1.3 34.6878\n"
    data = COEFFICIENTS.format(coeffs=coeffs).replace("2 atoms", "4 atoms").replace("1 bonds", "3 bonds")
    data = data.replace("2 1 2 2 1 1\n", "2 1 2 2 1 1\n3 1 1 3 1 1\n4 1 1 4.75 1 1\n") + "2 2 3 2\n3 1 4 3\n"
    script = f"""
units lj
atom_style {style}
newton on {newton}
special_bonds lj/coul 1 1 1
pair_style lj/cut 2.0
bond_style quartic
read_data in.data
mass * 1
thermo_modify lost ignore
"""
    run = "fix 1 all nve\nrun 0\n"
    ends = (
        "delete_bonds all bond 2\nwrite_data out.data\n",
        "delete_bonds all stats remove special\nwrite_data out.data\n",
    )
    for number, end in enumerate(ends):
        both = []
        for home, program in (("reference", on_lammps), ("ours", on_pylmp)):
            folder = tmp_path / f"{number}{home}"
            folder.mkdir()
            (folder / "in.data").write_text(data)
            full = (
                (script + run + end).replace("in.data", f"{folder}/in.data").replace("out.data", f"{folder}/out.data")
            )
            assert not program(full, folder).error
            both.append((folder / "out.data").read_text())
        assert both[0] == both[1]
        assert "2 bonds" in both[0]
