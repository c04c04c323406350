"""read_dump and rerun against LAMMPS: state, logs and sentences, on dumps that LAMMPS wrote."""

from __future__ import annotations

import difflib
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from pylmp.io.dump_file import DumpFile
from pylmp.text.diagnostic import ScriptError
from tests.restart.both import words
from tests.setup.both import Made, on_lammps, on_pylmp, second_opinion

SETUP = """units lj
{before}
atom_style {style}
boundary {boundary}
{lattice}
create_box 2 cell {counts}
create_atoms 1 box
set group all type/fraction 2 0.3 9213
mass * 1
pair_style lj/cut 1.5
pair_coeff * * 1 1
{after}
velocity all create 3 123
thermo_modify lost ignore
thermo 10
"""
WRITE = """fix 1 all nve
dump a all atom 10 {0}.atom
dump b all custom 10 {0}.custom id type x y z vx vy vz ix iy iz fx fy fz
dump c all custom 10 {0}.unwrapped.gz id type xu yu zu
dump d all custom 10 {0}.both id type xsu ysu zsu vx
run 30 post no
undump a
undump b
undump c
undump d
unfix 1
reset_timestep 7
"""
CUBE = "lattice sc 0.8\nregion cell block 0 3 0 3 0 3"
SCENES = {
    "periodic": {},
    "walls": {"boundary": "p s m"},
    "triclinic": {"lattice": "lattice sc 0.8\nregion cell prism 0 4 0 4 0 4 .8 .3 -.5 units box"},
    "flat": {"before": "dimension 2", "lattice": "lattice sq 0.8\nregion cell block 0 5 0 5 -.5 .5"},
    "bonds": {
        "style": "bond", "counts": "bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 20",
        "after": "special_bonds lj/coul 0 1 1\ncreate_bonds many all all 1 0.8 1.1\nbond_style harmonic\nbond_coeff 1 50 1.05",
    },
}  # fmt: skip
PLAIN = {"before": "units lj", "style": "atomic", "boundary": "p p p", "lattice": CUBE, "counts": "", "after": "timestep 0.005"}
GO_ON = "\nfix 1 all nve\nrun 5 post no"
READS = (
    "read_dump {0}.atom 10 x y{z}", "read_dump {0}.custom 20 x y{z} vx vy fx", "read_dump {0}.custom 20 x y{z} ix iy box no",
    "read_dump {0}.unwrapped.gz 20 x y{z}", "read_dump {0}.unwrapped.gz 20 x y{z} box no timestep no", "read_dump {0}.both 0 x y{z} vx",
    "group g id 5 6\ndelete_atoms group g compress no\nread_dump {0}.atom 30 x y{z} add keep trim yes",
    "group g id 5 6\ndelete_atoms group g compress no\nread_dump {0}.atom 30 x y{z} add yes",
    "read_dump {0}.unwrapped.gz 30 x y{z} purge yes add keep replace no", "read_dump {0}.custom 30 vx",
    "change_box all y final -1 4 units box\nread_dump {0}.atom 20 x y{z} box no",
    "read_dump {0}.custom 20 x y{z} label x fx label y fy scaled 1", "create_atoms 1 single .1 .1 0\nread_dump {0}.custom 20 x y trim yes",
)  # fmt: skip
RERUNS = (
    "rerun {0}.custom dump x y{z} vx vy ix iy", "rerun {0}.atom {0}.custom first 10 last 20 dump x y{z}\nrun 0 post no",
    "rerun {0}.custom every 20 dump x y{z}", "rerun {0}.custom skip 2 first 10 dump x y{z}", "thermo 7\nrerun {0}.custom dump x y{z}",
    "thermo 0\nrerun {0}.custom dump x y{z} timestep no", "rerun {0}.custom start 0 stop 30 post yes dump x y{z}",
    "compute p all stress/atom NULL\ncompute s all reduce sum c_p[1]\nthermo_style custom step time temp pe press c_s\nrerun {0}.atom dump x y{z}",
    "compute m all msd\nthermo_style custom step c_m[4] etotal\nrerun {0}.unwrapped.gz dump x y{z} box no\nread_dump {0}.custom 10 vx vy",
    "variable t equal ramp(1,2)\nthermo_style custom step v_t elapsed elaplong\nrerun {0}.custom start 0 stop 40 dump x y{z}",
    "fix 1 all langevin 1 1 1 123\nfix 2 all ave/time 10 1 10 c_thermo_temp\nthermo_style custom step temp f_2\nrerun {0}.custom dump x y{z} vx vy",
    "dump z all custom 20 again.{0} id x y fx fy\nrerun {0}.custom dump x y{z}",
)  # fmt: skip
WRONG = (
    "read_dump", "read_dump d.custom", "read_dump d.custom 20", "read_dump d.custom x y", "read_dump d.custom 25 x y z",
    "read_dump nofile 20 x y z", "read_dump d.custom 20 x y z q", "read_dump d.custom 20 x foo", "read_dump d.atom 20 x y z vx",
    "read_dump d.custom 20 x y z foo yes", "read_dump d.custom 20 x y z box maybe", "read_dump d.custom 20 box yes",
    "read_dump d.custom 20 x y z format native foo", "read_dump d.custom 20 x y z format foo", "read_dump d.custom 20 x y z label x zz",
    "read_dump d.custom 20 x y z nfile 2", "read_dump d.% 20 x y z", "read_dump d.custom 20 x y z purge yes",
    "read_dump d.custom 20 x y z label", "read_dump d.custom 20 x y z label x", "read_dump d.custom 20 x y z add",
    "read_dump d.custom 20 x y z add maybe", "read_dump d.custom 20 x y z format", "read_dump d.custom 20 x y z box",
    "read_dump d.both 20 x y z label x xsu", "dump z all atom 1 zz\nrun 1 post no\nread_dump d.custom 20 x y z",
    "rerun", "rerun d.custom", "rerun d.custom dump", "rerun d.custom dump x y z foo", "rerun d.custom first 10 x y z",
    "rerun d.custom first 100 dump x y z", "rerun d.custom every -7 dump x y z", "rerun d.custom skip 0 dump x y z",
    "rerun d.custom post maybe dump x y z", "rerun d.custom start 5 stop 10 dump x y z", "rerun d.custom first 30 last 20 dump x y z",
    "rerun nofile dump x y z", "rerun d.custom first x dump x y z", "rerun d.custom start 15 stop 10 dump x y z", "rerun first 10",
    "rerun d.custom first", "rerun d.custom post yes", "rerun d.% dump x y z", "rerun dump x y z",
)  # fmt: skip


def setup(scene: str) -> str:
    return SETUP.format(**{**PLAIN, **SCENES[scene]})


@cache
def dumps(base: Path) -> Path:
    """A folder with LAMMPS's dumps of all scenes."""
    home = base / "dumps"
    home.mkdir()
    for scene in SCENES:
        assert not on_lammps(setup(scene) + WRITE.format(scene), home).error
    assert not on_lammps(setup("periodic") + WRITE.format("d"), home).error
    return home


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return dumps(tmp_path_factory.getbasetemp())


def difference(script: str, folder: Path) -> str:
    """Empty if both programs end alike: sentence, log, state."""
    ours = on_pylmp(script, folder)

    def wrong(reference: Made) -> list[str]:
        found = [] if reference.error == ours.error else [f"{reference.error!r} {ours.error!r}"]
        found += difflib.unified_diff(words(reference), words(ours), "LAMMPS", "pylmp", lineterm="", n=0)
        arrays = {} if reference.error else reference.arrays
        return found + [f"{name} differs" for name, values in arrays.items() if not np.array_equal(values, ours.arrays[name])]

    return "\n".join(second_opinion(script, folder, wrong))


@pytest.mark.parametrize("scene", SCENES)
def test_snapshots_read(scene: str, folder: Path) -> None:
    z = "" if scene == "flat" else " z"
    for read in READS:
        if "add" in read and scene == "bonds":
            continue  # LAMMPS then looks for partners that are gone
        assert difference(f"{setup(scene)}{read.format(scene, z=z)}{GO_ON}", folder) == "", read


@pytest.mark.parametrize("scene", SCENES)
def test_snapshots_rerun(scene: str, folder: Path) -> None:
    z = "" if scene == "flat" else " z"
    for rerun in RERUNS:
        assert difference(f"{setup(scene)}{rerun.format(scene, z=z)}{GO_ON}", folder) == "", rerun


def test_wrong_uses(folder: Path) -> None:
    for wrong in WRONG:
        assert difference(f"{setup('periodic')}{wrong}\n", folder) == "", wrong


def test_garbled_files(folder: Path, tmp_path: Path) -> None:
    """Cut or changed anywhere, a dump is read as far as it is whole, then comes a sentence that names file and line."""
    lines = (folder / "d.custom").read_text().splitlines(True)
    whole = list(DumpFile(str(folder / "d.custom")).snapshots())
    start = whole[1].first - 9
    for line in range(start, start + 12):
        for change in ("", "garbage\n", "1e5\n", "nan nan nan\n"):
            (tmp_path / "wrong").write_text("".join([*lines[:line], change, *lines[line + 1 :]]))
            with pytest.raises(ScriptError) as caught:
                for snapshot in DumpFile(str(tmp_path / "wrong")).snapshots():
                    snapshot.table(list(range(len(snapshot.columns))))
            span = caught.value.diagnostic.span
            assert span is not None and span.file == str(tmp_path / "wrong") and span.line >= start, (line, change)
    for end in range(start + 1, start + 11):
        (tmp_path / "short").write_text("".join(lines[:end]))
        with pytest.raises(ScriptError, match="Unexpected end of dump file"):
            list(DumpFile(str(tmp_path / "short")).snapshots())
