"""write_data ... bond/history: a run that goes on from the file is the run that was never interrupted, bit for bit; LAMMPS reads it."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np
import pytest

from pylmp.text.diagnostic import ScriptError
from tests.setup.both import on_lammps
from tests.support import frames, simulate

HEAD = """
units lj
atom_style {atom_style}
newton {newton}
boundary {boundary}
comm_modify vel yes cutoff 2.6
"""
MAKE = """
lattice fcc 1.0
region cell {shape}
create_box 2 cell bond/types 2 extra/bond/per/atom 14 extra/special/per/atom 60
create_atoms 1 box
mass * 1.0
mass 2 1.7
set group all type/fraction 2 0.3 9213
displace_atoms all random 0.03 0.03 0.03 77
pair_style {pair}
pair_coeff * * {pair_coeff}
special_bonds lj/coul 0 1 1
create_bonds many all all 1 0.8 1.25
group soft type 2
{more_bonds}
velocity all create {temperature} 4321 loop geom
"""
FORCES = """
pair_style {pair}
pair_coeff * * {pair_coeff}
special_bonds {special}
bond_style {bond}
bond_coeff {bond_coeff}
{hybrid}
fix 1 all nve
timestep {dt}
thermo 20
compute broken all count/type bond
thermo_style custom step time temp pe ke ebond press pxx pxy bonds c_broken
dump 1 all custom 20 {dump} id type x y z vx vy vz fx fy fz ix iy iz
dump_modify 1 format float %.17g
compute ends all property/local batom1 batom2 btype
{local}
"""
PLASTIC = {
    "atom_style": "bond", "newton": "on off", "boundary": "p p p", "shape": "block 0 3 0 3 0 3", "pair": "bpm/spring",
    "pair_coeff": "12.0 1.0 0.5", "special": "lj 0 1 1 coul 1 1 1", "bond": "bpm/spring/plastic", "bond_coeff": "* 40 0.2 0.4 0.05",
    "temperature": 4.0, "dt": 0.01, "hybrid": "", "more_bonds": "create_bonds many soft soft 2 0.8 1.24",
    "local": "compute memory all bond/local b1 b2\ndump 2 all local 20 {dump}.bonds c_ends[*] c_memory[*]",
}  # fmt: skip
QUARTIC = PLASTIC | {
    "pair": "lj/cut 1.2", "pair_coeff": "1.0 1.0", "special": "lj/coul 1 1 1", "bond": "quartic", "dt": 0.002, "temperature": 12.0,
    "bond_coeff": "* 1200 -0.55 0.25 1.3 34.6878", "local": "dump 2 all local 20 {dump}.bonds c_ends[*]",
}  # fmt: skip
HYBRID = PLASTIC | {
    "bond": "hybrid bpm/spring/plastic overlay/pair yes quartic", "bond_coeff": "1 bpm/spring/plastic 40 0.2 0.4 0.05",
    "hybrid": "bond_coeff 2 quartic 1200 -0.55 0.25 1.35 34.6878", "special": "lj/coul 1 1 1", "pair": "lj/cut 1.2",
    "pair_coeff": "1.0 0.9", "local": "dump 2 all local 20 {dump}.bonds c_ends[*]", "dt": 0.002, "temperature": 8.0,
}  # fmt: skip
SCENES = {
    "plastic": PLASTIC,
    "plastic, newton off off": PLASTIC | {"newton": "off off"},
    "plastic, full": PLASTIC | {"atom_style": "full"},
    "plastic, faces shrink": PLASTIC | {"boundary": "s m p"},
    "plastic, tilted": PLASTIC | {"shape": "prism 0 3 0 3 0 3 0.4 -0.2 0.3"},
    "plastic, overlaid": PLASTIC | {"newton": "on on", "bond": "bpm/spring/plastic overlay/pair yes", "special": "lj/coul 1 1 1"},
    "quartic": QUARTIC,
    "quartic, newton on on": QUARTIC | {"newton": "on on"},
    "hybrid": HYBRID,
}


def ran(script: str, folder: Path, dump: str) -> dict[str, object]:
    """What a run leaves: frames of both dumps, lines of the table."""
    _, screen = simulate(script, folder)
    tables = [part.split("\nLoop time")[0] for part in screen.split("Per MPI rank memory allocation")[1:]]
    found = {f"{name} {k}": rows for name in (dump, f"{dump}.bonds") for k, (_, _, rows) in enumerate(frames(folder / name))}
    return {**found, "tables": [table.split("\n")[1:] for table in tables]}


@pytest.mark.parametrize("name", SCENES)
def test_goes_on_exactly(name: str, tmp_path: Path) -> None:
    scene = SCENES[name]
    local = str(scene["local"])
    first = (HEAD + MAKE + FORCES).format(**scene | {"dump": "whole", "local": local.format(dump="whole")})
    whole = ran(f"{first}run 100\nwrite_data middle.data nocoeff bond/history\nrun 100\nwrite_data end.data nocoeff bond/history\n", tmp_path, "whole")
    again = (HEAD + "read_data middle.data bond/history\n" + FORCES).format(
        **scene | {"dump": "rest", "local": local.format(dump="rest")}
    )
    rest = ran(f"{again}run 100\nwrite_data other.data nocoeff bond/history\n", tmp_path, "rest")
    assert whole["tables"][1] == rest["tables"][0]  # type: ignore[index]
    before = len(frames(tmp_path / "whole")) - len(frames(tmp_path / "rest"))
    assert before == 5
    for k in range(1, 6):  # the frame of step 100 was written before its atoms were wrapped and sorted
        for dump in ("", ".bonds"):
            assert np.array_equal(whole[f"whole{dump} {before + k}"], rest[f"rest{dump} {k}"]), f"{dump} frame {k}"
    assert (tmp_path / "end.data").read_text() == (tmp_path / "other.data").read_text()
    if "overlaid" not in name:
        assert whole["tables"][0][1] != whole["tables"][1][-1]  # type: ignore[index]


def test_lammps_reads_the_file(tmp_path: Path) -> None:
    """The same atoms and bonds as in the file without the lines, which it passes over."""
    script = (HEAD + MAKE + FORCES).format(**PLASTIC | {"dump": "a", "local": ""})
    simulate(f"{script}run 40\nwrite_data plain.data nocoeff\nwrite_data history.data nocoeff bond/history\n", tmp_path)
    made = [
        on_lammps(f"{HEAD.format(**PLASTIC)}read_data {tmp_path}/{name}.data\nwrite_data {tmp_path}/{name}.again\n", tmp_path)
        for name in ("plain", "history")
    ]
    assert not made[0].error and not made[1].error
    assert (tmp_path / "plain.again").read_text() == (tmp_path / "history.again").read_text()
    for name, values in made[0].arrays.items():
        assert np.array_equal(values, made[1].arrays[name]), name
    assert (tmp_path / "history.data").read_text().startswith((tmp_path / "plain.data").read_text())


def test_other_readers_pass_over_it(tmp_path: Path) -> None:
    from ase.io.lammpsdata import read_lammps_data
    from MDAnalysis import Universe

    script = (HEAD + MAKE + FORCES).format(**PLASTIC | {"dump": "a", "local": ""})
    simulate(f"{script}run 40\nwrite_data plain.data nocoeff\nwrite_data history.data nocoeff bond/history\n", tmp_path)
    atoms = [read_lammps_data(tmp_path / f"{name}.data", units="metal") for name in ("plain", "history")]
    assert np.array_equal(atoms[0].positions, atoms[1].positions)
    assert (atoms[0].arrays["bonds"] == atoms[1].arrays["bonds"]).all()
    seen = [Universe(tmp_path / f"{name}.data", topology_format="DATA") for name in ("plain", "history")]
    assert np.array_equal(seen[0].atoms.positions, seen[1].atoms.positions)
    assert np.array_equal(seen[0].bonds.indices, seen[1].bonds.indices)


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    folder = tmp_path_factory.mktemp("history")
    script = (HEAD + MAKE + FORCES).format(**PLASTIC | {"dump": "a", "local": "", "shape": "block 0 2 0 2 0 2"})
    simulate(f"{script}run 10\nwrite_data it.data nocoeff bond/history\n", folder)
    return (folder / "it.data").read_text().splitlines()


def wrong(lines: list[str], folder: Path, newton: str = "on off") -> ScriptError | None:
    (folder / "it.data").write_text("\n".join(lines) + "\n")
    head = HEAD.format(**PLASTIC | {"newton": newton})
    try:
        simulate(f"{head}read_data it.data bond/history\nbond_style bpm/spring/plastic\n", folder)
    except ScriptError as error:
        return error
    return None


def test_edited_files_are_refused(written: list[str], tmp_path: Path) -> None:
    title = written.index("# Bond History")
    rows = next(k for k, line in enumerate(written) if line.startswith("# atom partner")) + 1
    assert wrong(written, tmp_path) is None
    cases = {
        "No bond history in data file": written[:title],
        "Unexpected end of bond history in data file": written[:-1],
        "Bond history of data file does not fit its bonds": [*written[:rows], written[rows + 1], *written[rows + 1 :]],
        "Expected integer parameter instead of 'x'": [*written[:rows], "# 1 x 1 1 0", *written[rows + 1 :]],
        "Expected floating point parameter instead of 'nan'": [*written[:rows], "# 1 2 1 nan 0", *written[rows + 1 :]],
        "Incorrect format in bond history of data file: # 1 2": [*written[:rows], "# 1 2", *written[rows + 1 :]],
        "Invalid atom ID or bond type in bond history of data file: # 1 999": [*written[:rows], "# 1 999 1 1 0", *written[rows + 1 :]],
        "Unknown identifier in data file: 1 2 1": [*written[:rows], "1 2 1 1 0", *written[rows + 1 :]],
        "Invalid line in bond history of data file: #": [*written[:rows], "#", *written[rows + 1 :]],
        "Unknown line in bond history of data file: # stepp": [*written[: title + 2], "# stepp 3", *written[title + 3 :]],
    }
    for sentence, lines in cases.items():
        error = wrong(lines, tmp_path)
        assert error is not None, sentence
        assert error.diagnostic.message.startswith(sentence), error.diagnostic
        assert error.diagnostic.span is not None and error.diagnostic.span.file == "it.data"
    error = wrong(written, tmp_path, newton="on on")
    assert error is not None and error.diagnostic.message == "Bond history of data file does not fit its bonds"


def test_garbled_files_give_a_sentence(written: list[str], tmp_path: Path) -> None:
    draw, title = random.Random(11), written.index("# Bond History")
    for _ in range(60):
        lines = list(written)
        at = draw.randrange(title, len(lines))
        text = lines[at]
        cut = draw.randrange(len(text) + 1)
        lines[at] = draw.choice([text[:cut], text[cut:], text[:cut] + draw.choice("0x-# .") + text[cut:], ""])
        if draw.random() < 0.3:
            del lines[draw.randrange(title, len(lines)) :]
        wrong(lines, tmp_path)  # a ScriptError or nothing


def test_needs_a_run(tmp_path: Path) -> None:
    script = (HEAD + MAKE + FORCES).format(**PLASTIC | {"dump": "a", "local": ""})
    with pytest.raises(ScriptError, match="remember nothing yet"):
        simulate(f"{script}write_data it.data nocoeff bond/history\n", tmp_path)
