"""What other programs read from our files: ASE, MDAnalysis, lammps-logfile and LAMMPS itself.

LAMMPS and pylmp run the same script; every reader must find in our files the arrays it finds in LAMMPS's.
"""

from __future__ import annotations

import signal
import subprocess
import sys
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.setup.both import on_lammps
from tests.support import frames, lammps

SCRIPT = """
units           lj
atom_style      bond
lattice         sc 1.0
region          cell block 0 6 0 5 0 6
create_box      2 cell bond/types 2 extra/bond/per/atom 6 extra/special/per/atom 30
create_atoms    1 box
mass            1 1.0
mass            2 1.6
set             group all type/fraction 2 0.3 9213
displace_atoms  all random 0.05 0.05 0.05 4711
pair_style      lj/cut 1.2
pair_modify     shift yes
pair_coeff      * * 1.0 1.0 1.122462048309373
special_bonds   lj/coul 0 1 1
create_bonds    many all all 1 0.85 1.15
special_bonds   lj/coul 1 1 1
bond_style      quartic
bond_coeff      1 1200 -0.55 0.25 1.3 34.6878
bond_coeff      2 900 -0.55 0.25 1.25 30.0
velocity        all create 11.0 87287 loop geom
fix             1 all nve
timestep        0.002
thermo          20
thermo_style    custom step temp pe ebond press bonds
dump            1 all custom 50 all.dump id type x y z vx vy vz ix iy iz
dump            2 all atom 50 atom.dump
dump_modify     1 sort id format float %.17g
dump_modify     2 sort id
dump            3 all custom 100 *.dump type id xu yu zu fx fy fz
"""
RUNS = "run 130\nrun 70\nwrite_data out.data\nwrite_data bare.data nocoeff\n"
DUMPS = "all.dump", "atom.dump", "100.dump"


@dataclass(frozen=True)
class Twins:
    """Folders with the files of the two programs."""

    reference: Path
    ours: Path

    def same(self, read: Callable[[Path], dict[str, Any]], name: str) -> dict[str, np.ndarray]:
        """What read finds in file name of LAMMPS, once it has found the same in ours."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found, other = (
                {key: np.asarray(value) for key, value in read(folder / name).items()}
                for folder in (self.reference, self.ours)
            )
        assert found and found.keys() == other.keys()
        for key, values in found.items():
            assert values.shape == other[key].shape and np.array_equal(values, other[key]), f"{name}: {key}"
        return found


def pylmp(folder: Path) -> list[str]:
    return [sys.executable, "-m", "pylmp", "in.script", "-screen", "none", "--engine", "exact"]


@pytest.fixture(scope="module")
def twins(tmp_path_factory: pytest.TempPathFactory) -> Twins:
    home = tmp_path_factory.mktemp("readers")
    assert lammps(SCRIPT + RUNS, home / "reference").code == 0
    ours = home / "ours"
    ours.mkdir()
    (ours / "in.script").write_text(SCRIPT + RUNS)
    subprocess.run(pylmp(ours), cwd=ours, check=True)
    return Twins(home / "reference", ours)


# ---- ASE --------------------------------------------------------------------------------------------------------


def ase_dump(path: Path) -> dict[str, Any]:
    from ase.io import read

    found: dict[str, Any] = {}
    for k, atoms in enumerate(read(path, ":", format="lammps-dump-text")):  # type: ignore[arg-type]
        found |= {f"{name} {k}": values for name, values in atoms.arrays.items()}
        found |= {f"cell {k}": atoms.cell.array, f"pbc {k}": atoms.pbc}
        if atoms.calc is not None:
            found[f"forces {k}"] = atoms.get_forces()
    return found


def ase_data(path: Path) -> dict[str, Any]:
    from ase.io.lammpsdata import read_lammps_data

    atoms = read_lammps_data(path, units="metal", sort_by_id=True)
    return {**atoms.arrays, "cell": atoms.cell.array}


@pytest.mark.parametrize("name", DUMPS)
def test_ase_reads_dumps(name: str, twins: Twins) -> None:
    found = twins.same(ase_dump, name)
    atoms = len(frames(twins.ours / name)[0][2])
    assert found["positions 0"].shape == (atoms, 3)
    assert len([key for key in found if key.startswith("cell")]) == len(frames(twins.ours / name))


@pytest.mark.parametrize("name", ["out.data", "bare.data"])
def test_ase_reads_data(name: str, twins: Twins) -> None:
    found = twins.same(ase_data, name)
    assert {"positions", "masses", "bonds", "momenta"} <= found.keys()


# ---- MDAnalysis -------------------------------------------------------------------------------------------------


def universe(path: Path) -> dict[str, Any]:
    import MDAnalysis

    data = MDAnalysis.Universe(path, topology_format="DATA")
    atoms = data.atoms
    return {
        "ids": atoms.ids, "types": atoms.types, "masses": atoms.masses, "resids": atoms.resids, "x": atoms.positions,
        "v": atoms.velocities, "box": data.dimensions, "bonds": data.bonds.indices, "bond types": data.bonds.types(),
    }  # fmt: skip


def trajectory(path: Path) -> dict[str, Any]:
    import MDAnalysis

    found = {}
    moving = MDAnalysis.Universe(path.with_name("out.data"), path, topology_format="DATA", format="LAMMPSDUMP")
    for frame in moving.trajectory:
        found |= {f"x {frame.frame}": frame.positions.copy(), f"box {frame.frame}": frame.dimensions}
        found[f"step {frame.frame}"] = frame.data["step"]
    return found


@pytest.mark.parametrize("name", ["out.data", "bare.data"])
def test_mdanalysis_reads_data(name: str, twins: Twins) -> None:
    found = twins.same(universe, name)
    assert len(found["bonds"]) > 0


@pytest.mark.parametrize("name", DUMPS)
def test_mdanalysis_reads_dumps(name: str, twins: Twins) -> None:
    twins.same(trajectory, name)


# ---- lammps-logfile ---------------------------------------------------------------------------------------------


def tables(path: Path) -> dict[str, Any]:
    from lammps_logfile import File

    log = File(str(path))
    parts = log.get_num_partial_logs()
    return {f"{word} {k}": log.get(word, run_num=k) for k in range(parts) for word in log.get_keywords(run_num=k)}


def test_lammps_logfile_reads_logs(twins: Twins) -> None:
    found = twins.same(tables, "log.lammps")
    assert found["Step 0"].tolist() == [0, 20, 40, 60, 80, 100, 120, 130]
    assert found["Step 1"].tolist() == [130, 140, 160, 180, 200]
    assert found["Bonds 1"].shape == (5,)


# ---- LAMMPS -----------------------------------------------------------------------------------------------------

HEAD = "units lj\natom_style bond\nspecial_bonds lj/coul 1 1 1\npair_style lj/cut 1.2\nbond_style quartic\n"


@pytest.mark.parametrize("name", ["out.data", "bare.data"])
def test_lammps_reads_data(name: str, twins: Twins, tmp_path: Path) -> None:
    """Atoms by read_data's arrays; bonds and coefficients by what LAMMPS writes again."""
    coeffs = "" if name == "out.data" else "pair_coeff * * 1 1\nbond_coeff * 1 1 1 1 1\n"

    def read(path: Path) -> dict[str, Any]:
        script = f"{HEAD}read_data {path}\n{coeffs}write_data {tmp_path}/again.data\n"
        made = on_lammps(script, tmp_path)
        assert not made.error
        again = (tmp_path / "again.data").read_text().splitlines()[1:]  # the title names the step of its writer
        return {**made.arrays, "again": np.array(again)}

    twins.same(read, name)


def test_lammps_reads_dumps(twins: Twins, tmp_path: Path) -> None:
    def read(path: Path) -> dict[str, Any]:
        words = "x y z vx vy vz ix iy iz box yes replace yes"
        made = on_lammps(f"{HEAD}read_data {twins.reference}/out.data\nread_dump {path} 150 {words}\n", tmp_path)
        assert not made.error
        return made.arrays

    found = twins.same(read, "all.dump")
    step, _, rows = frames(twins.ours / "all.dump")[3]
    assert step == 150 == found["step"]
    order = np.argsort(found["id"])
    assert np.array_equal(found["v"][order], rows[:, 5:8])
    moved = (found["x"][order] - rows[:, 2:5]) / (found["hi"] - found["lo"])  # LAMMPS unwraps and wraps them again
    assert np.abs(moved - np.round(moved)).max() < 1e-15


# ---- a run that was interrupted ---------------------------------------------------------------------------------


def test_what_an_interrupted_run_leaves_can_be_read(twins: Twins, tmp_path: Path) -> None:
    """Its log and its dumps end with complete frames and rows, those of a run that LAMMPS ended there."""
    (tmp_path / "in.script").write_text(SCRIPT + "run 2000000\n")
    running = subprocess.Popen(pylmp(tmp_path), cwd=tmp_path)
    try:
        until = time.monotonic() + 120.0
        while time.monotonic() < until and len(_frames(tmp_path / "all.dump")) < 4:
            time.sleep(0.02)
        running.send_signal(signal.SIGINT)
        assert running.wait(60.0) == 130
    finally:
        running.kill()
        running.wait()
    last = frames(tmp_path / "all.dump")[-1][0]
    assert lammps(f"{SCRIPT}run {last}\nwrite_data out.data\n", tmp_path / "reference").code == 0
    (tmp_path / "out.data").write_bytes((tmp_path / "reference" / "out.data").read_bytes())
    both = Twins(tmp_path / "reference", tmp_path)
    for name in ("all.dump", "atom.dump"):
        both.same(ase_dump, name)
        both.same(trajectory, name)
    found = tables(tmp_path / "log.lammps")
    wanted = tables(tmp_path / "reference" / "log.lammps")
    assert found.keys() == wanted.keys()
    rows = last // 20 + 1
    for word, values in found.items():
        assert np.array_equal(values[:rows], wanted[word][:rows]), word
        assert len(values) >= rows


def _frames(path: Path) -> list[str]:
    return path.read_text().split("ITEM: TIMESTEP\n")[1:] if path.exists() else []
