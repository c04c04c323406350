"""Data files of every atom style: ASE, MDAnalysis and LAMMPS find in ours what they find in LAMMPS's."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.oracle.test_readers import Twins, ase_data
from tests.setup.both import on_lammps, on_pylmp
from tests.topology.support import STORED, Network

COLUMNS = {"atomic": "id type x y z", "charge": "id type charge x y z", "full": "id resid type charge x y z"}  # MDAnalysis asks for them


@pytest.fixture(scope="module", params=STORED)
def styled(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Twins]:
    """The file of one atom style, written by both programs."""
    home, style = tmp_path_factory.mktemp("styles"), request.param
    text = Network(11, style, 3, "ppp").text()
    for name, program in (("reference", on_lammps), ("ours", on_pylmp)):
        folder = home / name
        folder.mkdir()
        (folder / "in.data").write_text(text)
        made = program(f"units lj\natom_style {style}\nread_data {folder}/in.data\nwrite_data {folder}/out.data\n", folder)
        assert not made.error
    return style, Twins(home / "reference", home / "ours")


def test_ase_reads_every_style(styled: tuple[str, Twins]) -> None:
    style, both = styled
    found = both.same(ase_data, "out.data")
    assert {"positions", "masses", "momenta"} <= found.keys()
    assert ("initial_charges" in found or "mmcharges" in found) == (style in ("charge", "full"))
    assert {f"{kind}s" for kind in STORED[style] if kind != "improper"} <= found.keys()


def test_mdanalysis_reads_every_style(styled: tuple[str, Twins]) -> None:
    import MDAnalysis

    style, both = styled

    def read(path: Path) -> dict[str, Any]:
        columns = COLUMNS.get(style, "id resid type x y z")
        data = MDAnalysis.Universe(path, topology_format="DATA", atom_style=columns)
        atoms = data.atoms
        found = {"ids": atoms.ids, "types": atoms.types, "x": atoms.positions, "v": atoms.velocities, "box": data.dimensions}
        if "charge" in columns:
            found["charges"] = atoms.charges
        for kind in STORED[style]:
            group = getattr(data, f"{kind}s")
            found |= {kind: group.indices, f"{kind} types": np.array(group.types())}
        return found

    found = both.same(read, "out.data")
    assert all(len(found[kind]) for kind in STORED[style])


def test_lammps_reads_every_style(styled: tuple[str, Twins], tmp_path: Path) -> None:
    style, both = styled

    def read(path: Path) -> dict[str, Any]:
        made = on_lammps(f"units lj\natom_style {style}\nread_data {path}\nwrite_data {tmp_path}/again.data\n", tmp_path)
        assert not made.error
        return {**made.arrays, "again": np.array((tmp_path / "again.data").read_text().splitlines())}

    both.same(read, "out.data")
