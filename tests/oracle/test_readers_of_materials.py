"""What OVITO and pymatgen read from our files, in arrays: the same as from LAMMPS's."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.oracle.test_readers import DUMPS, RUNS, SCRIPT, Twins, pylmp
from tests.support import lammps

LOCAL = """
compute ends all property/local batom1 batom2 btype
compute bonds all bond/local dist engpot force
dump 4 all local 50 bonds.dump c_ends[1] c_ends[2] c_ends[3] c_bonds[1] c_bonds[2] c_bonds[3]
"""


@pytest.fixture(scope="module")
def twins(tmp_path_factory: pytest.TempPathFactory) -> Twins:
    import subprocess

    home = tmp_path_factory.mktemp("materials")
    assert lammps(SCRIPT + LOCAL + RUNS, home / "reference").code == 0
    ours = home / "ours"
    ours.mkdir()
    (ours / "in.script").write_text(SCRIPT + LOCAL + RUNS)
    subprocess.run(pylmp(ours), cwd=ours, check=True)
    return Twins(home / "reference", ours)


# ---- OVITO, as a library ----------------------------------------------------------------------------------------


def ovito(path: Path, **options: Any) -> dict[str, Any]:
    """Every particle property, bond and cell of every frame."""
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    from ovito.io import import_file

    pipeline = import_file(str(path), **options)
    found: dict[str, Any] = {}
    for k in range(pipeline.source.num_frames):
        data = pipeline.compute(k)
        if data.particles is not None:
            found |= {f"{name} {k}": np.array(values) for name, values in data.particles.items()}
            if data.particles.bonds is not None:
                found |= {f"bond {name} {k}": np.array(values) for name, values in data.particles.bonds.items()}
        if data.cell is not None:
            found |= {f"cell {k}": np.array(data.cell[:]), f"pbc {k}": data.cell.pbc}
        found |= {f"attribute {name} {k}": value for name, value in data.attributes.items() if name != "SourceFile"}
    return found


@pytest.mark.parametrize("name", DUMPS)
def test_ovito_reads_dumps(name: str, twins: Twins) -> None:
    found = twins.same(ovito, name)
    assert found["Position 0"].shape[1] == 3


def test_ovito_reads_data(twins: Twins) -> None:
    found = twins.same(ovito, "out.data")
    assert found["bond Topology 0"].shape[1] == 2


def test_ovito_reads_bonds_of_dumps(twins: Twins) -> None:
    """Broken bonds leave: fewer rows frame by frame."""
    columns = [
        "Particle Identifiers.1", "Particle Identifiers.2", "Bond Type", "Length", "Energy", "Force",
    ]  # fmt: skip

    def read(path: Path) -> dict[str, Any]:
        from ovito.io import import_file
        from ovito.modifiers import LoadTrajectoryModifier

        pipeline = import_file(str(path.with_name("out.data")), atom_style="bond")
        overlay = LoadTrajectoryModifier()
        overlay.source.load(str(path), columns=columns)
        pipeline.modifiers.append(overlay)
        found = {}
        for k in range(5):
            bonds = pipeline.compute(k).particles.bonds
            found |= {f"{name} {k}": np.array(bonds[name]) for name in ("Topology", "Bond Type", "Length", "Force")}
        return found

    found = twins.same(read, "bonds.dump")
    assert len(found["Topology 4"]) < len(found["Topology 0"])


# ---- pymatgen ---------------------------------------------------------------------------------------------------


def pymatgen_dump(path: Path) -> dict[str, Any]:
    from pymatgen.io.lammps.outputs import parse_lammps_dumps

    found: dict[str, Any] = {}
    for k, frame in enumerate(parse_lammps_dumps(str(path))):
        found |= {f"{name} {k}": frame.data[name].to_numpy() for name in frame.data.columns}
        found |= {f"step {k}": frame.timestep, f"box {k}": frame.box.bounds}
    return found


def pymatgen_data(path: Path) -> dict[str, Any]:
    from pymatgen.io.lammps.data import LammpsData

    data = LammpsData.from_file(str(path), atom_style="bond")
    found = {f"atoms {name}": data.atoms[name].to_numpy() for name in data.atoms.columns}
    found |= {f"bonds {name}": data.topology["Bonds"][name].to_numpy() for name in data.topology["Bonds"].columns}
    return {**found, "masses": data.masses["mass"].to_numpy(), "box": data.box.bounds}


def pymatgen_log(path: Path) -> dict[str, Any]:
    from pymatgen.io.lammps.outputs import parse_lammps_log

    tables = parse_lammps_log(str(path))
    return {f"{name} {k}": table[name].to_numpy() for k, table in enumerate(tables) for name in table.columns}


@pytest.mark.parametrize("name", DUMPS)
def test_pymatgen_reads_dumps(name: str, twins: Twins) -> None:
    assert twins.same(pymatgen_dump, name)["step 0"] % 50 == 0


def test_pymatgen_reads_data(twins: Twins) -> None:
    assert len(twins.same(pymatgen_data, "out.data")["bonds atom1"]) > 0


def test_pymatgen_reads_logs(twins: Twins) -> None:
    assert twins.same(pymatgen_log, "log.lammps")["Step 1"].tolist() == [130, 140, 160, 180, 200]
