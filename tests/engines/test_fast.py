"""The fast engine against the exact one: forces, energies, virials, trajectories, broken bonds, rebuild steps."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest

from pylmp.engines.fast import Fast
from pylmp.text.diagnostic import ScriptError
from tests.engines.scenes import BONDS, PAIRS, script
from tests.support import simulate

FACES = ("p p p", "f f f", "s p m", "p s p")
NEWTON = ("on off", "off off")
SCENES = [(pair, bond, k) for k, (pair, bond) in enumerate([("lj", bond) for bond in BONDS] + [(pair, "plastic") for pair in PAIRS])]
NAMES = [f"{pair}-{bond}" for pair, bond, _ in SCENES]


def both(text: str, folder: Path):
    """(exact, fast) simulations after text, which the fast engine must be able to run."""
    exact, _ = simulate(text, folder / "exact")
    fast, screen = simulate(text, folder / "fast", Fast())
    assert "Engine exact" not in screen, screen
    return exact, fast


def rows(sim, name: str) -> np.ndarray:
    n = sim.atoms.n
    return getattr(sim.atoms, name)[:n][np.argsort(sim.atoms.tag[:n])]


def scene(pair: str, bond: str, k: int, heat: float = 1.0) -> str:
    newton = NEWTON[k % 2] if bond != "quartic" else ("on on", "off on")[k % 2]
    flat = k % 3 == 1
    faces = FACES[k % 4] if not flat else FACES[k % 4][:-1] + "p"
    return script(pair, bond, flat=flat, boundary=faces, newton=newton, heat=heat, seed=k)


@pytest.mark.parametrize(("pair", "bond", "k"), SCENES, ids=NAMES)
def test_forces_energies_virials(pair: str, bond: str, k: int, tmp_path: Path) -> None:
    """Bonds know their length of the first run 0, then all atoms are displaced alike."""
    text = scene(pair, bond, k)
    apart = f"displace_atoms all random 0.03 0.03 {'0.0' if 'dimension 2' in text else '0.03'} 99\n"
    exact, fast = both(f"{text}run 0\n{apart}run 0\n", tmp_path)
    f = rows(exact, "f")
    assert np.abs(rows(fast, "f") - f).max() <= 1e-12 * np.sqrt((f * f).mean())
    for names in (("pair", "bond"), ("pair_virial", "bond_virial")):
        one, other = (np.array([getattr(sim.tally, name) for name in names]) for sim in (exact, fast))
        assert np.abs(one).max() > 0.0 or names == ("pair", "bond")  # a plastic bond has no energy
        assert np.abs(one - other).max() <= 1e-12 * np.abs(one).max(), names


@pytest.mark.parametrize(("pair", "bond", "k"), SCENES, ids=NAMES)
def test_hundred_steps(pair: str, bond: str, k: int, tmp_path: Path) -> None:
    """Positions and velocities at step 100, the bonds that are left, what they remember, the steps of rebuilds."""
    exact, fast = both(scene(pair, bond, k, heat=2.0) + "run 100\n", tmp_path)
    assert exact.report.builds > 1
    assert_same_hundred_steps(exact, fast)
    assert (np.sort(rows(fast, "num_special")) == np.sort(rows(exact, "num_special"))).all()


def assert_same_hundred_steps(exact, fast) -> None:
    """Lists were built as often, atoms are where they are to round-off, and the same bonds hold."""
    assert (exact.report.builds, exact.report.dangerous) == (fast.report.builds, fast.report.dangerous)
    assert np.abs(rows(fast, "x") - rows(exact, "x")).max() <= 1e-11
    assert np.abs(rows(fast, "v") - rows(exact, "v")).max() <= 1e-10
    assert (rows(fast, "image") == rows(exact, "image")).all()
    assert exact.bonds == fast.bonds
    assert bonds(fast) == bonds(exact)


def bonds(sim) -> set[tuple[int, int, int]]:
    """(lower ID, higher ID, type) of the bonds that hold."""
    atoms, found = sim.atoms, set()
    for i in range(atoms.n):
        for q in range(int(atoms.num_bond[i])):
            a, b = int(atoms.tag[i]), int(atoms.bond_atom[i, q])
            if atoms.bond_type[i, q] > 0:
                found.add((min(a, b), max(a, b), int(atoms.bond_type[i, q])))
    return found


@pytest.mark.parametrize("boundary", ["f f f", "p p p"])
def test_bonds_break_in_the_same_steps(boundary: str, tmp_path: Path) -> None:
    """Impact: hundreds of bonds break; the fix that keeps records of them has the same lines in the end."""
    text = script("spring", "plastic", boundary=boundary, heat=6.0, seed=3)
    text = text.replace("normalize yes", "normalize yes store/local brk 1 time id1 id2 x y z")
    text = text.replace("fix 1 all nve", "fix 1 all nve\ndump 1 all local 1 broken.* index f_brk[1] f_brk[2] f_brk[3] f_brk[4] f_brk[5] f_brk[6]")
    exact, fast = both(text + "thermo_modify lost ignore lost/bond ignore\nrun 60\n", tmp_path)
    assert fast.bonds == exact.bonds < len(bonds(exact)) + 10_000
    total = 0
    for step in range(61):
        files = [sorted(_numbers(tmp_path / engine / f"broken.{step}")) for engine in ("exact", "fast")]
        assert [line[:3] for line in files[0]] == [line[:3] for line in files[1]], step
        total += len(files[0])
        if files[0]:
            assert np.abs(np.array(files[0]) - np.array(files[1])).max() < 1e-9
    assert total > 100


def _numbers(path: Path) -> list[tuple[float, ...]]:
    lines = path.read_text().splitlines()[9:]
    return [tuple(map(float, line.split()[1:])) for line in lines]


def test_the_same_bits_twice(tmp_path: Path) -> None:
    text = script("lj", "plastic", heat=2.0) + "fix 3 all langevin 1.0 1.0 1.0 77\nrun 40\n"
    first, _ = simulate(text, tmp_path / "a", Fast())
    second, _ = simulate(text, tmp_path / "b", Fast())
    for name in ("x", "v", "f"):
        assert rows(first, name).tobytes() == rows(second, name).tobytes()


@pytest.mark.parametrize("count", [*range(18), 31, 32, 33, 70])
def test_any_number_of_atoms(count: int, tmp_path: Path) -> None:
    """No number of padded rows makes a nan, and none of them is seen."""
    text = "units lj\natom_style bond\nregion b block 0 9 0 9 0 9\ncreate_box 1 b bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 9\n"
    if count:
        text += f"create_atoms 1 random {count} 4711 NULL overlap 0.9 maxtry 500\n"
    text += (
        "mass 1 1.0\npair_style lj/cut 2.5\npair_coeff 1 1 1.0 1.0\nspecial_bonds lj/coul 0 1 1\ncreate_bonds many all all 1 0.5 1.4\nspecial_bonds lj/coul 1 1 1\n"
        "bond_style quartic\nbond_coeff 1 1200 -0.55 0.25 1.5 34.7\nfix 1 all nve\ntimestep 0.002\nrun 30\n"
    )  # fmt: skip
    if count > 1:
        text = text.replace("fix 1", "velocity all create 1.0 99 loop geom\nfix 1")
    exact, fast = both(text, tmp_path)
    assert fast.atoms.n == exact.atoms.n
    for name, limit in (("x", 1e-12), ("v", 1e-11), ("f", 1e-8)):
        if count:
            assert np.abs(rows(fast, name) - rows(exact, name)).max() <= limit
    assert bonds(fast) == bonds(exact)


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("bond_style bpm/spring volume/factor yes\nbond_coeff * 60 0.15 0.8 0.5", "bond_style bpm/spring volume/factor yes"),
        ("special_bonds lj/coul 0.5 0.5 1\npair_style hybrid lj/cut 1.3 soft 1.0\npair_coeff 1 * lj/cut 1 1\npair_coeff 2 2 soft 9.0\npair_modify pair soft special lj 0 0.5 1", "pair_modify special"),
        (
            "special_bonds lj/coul 1 1 1\nbond_style hybrid quartic bpm/spring/plastic overlay/pair yes\nbond_coeff 1 quartic 1200 -0.55 0.25 1.5 34.7\n"
            "bond_coeff 2 bpm/spring/plastic 60 0.15 0.8 0.02",
            "what LAMMPS mixes up of bond_style bpm/spring/plastic under hybrid in the first run",
        ),
    ],
)
def test_says_why_not(line: str, reason: str, tmp_path: Path) -> None:
    """What the fast engine lacks, the exact one carries out, and the log says so."""
    newton = "on on" if "quartic" in line else "on off"
    text = script("lj", "harmonic", newton=newton) + "special_bonds lj 0 1 1 coul 1 1 1\n" + line + "\nrun 1\n"
    fast, screen = simulate(text, tmp_path / "fast", Fast())
    assert f"Engine exact for this run: engine fast lacks {reason}" in screen
    exact, _ = simulate(text, tmp_path / "exact")
    assert rows(fast, "x").tobytes() == rows(exact, "x").tobytes()


def test_goes_on_without_set_up(tmp_path: Path) -> None:
    text = script("lj", "plastic", heat=1.0) + "run 20\nrun 20 pre no\nrun 20 every 10 NULL\nvelocity all scale 0.5\nrun 20\n"
    exact, fast = both(text, tmp_path)
    assert np.abs(rows(fast, "x") - rows(exact, "x")).max() <= 1e-11
    assert bonds(fast) == bonds(exact)


@pytest.mark.parametrize("how", ["1 x erate 0.05", "3 x erate 0.1 y erate -0.05", "1 x trate 0.1 z scale 0.97 units box", "2 y wiggle 0.2 0.5"])
def test_box_that_changes(how: str, tmp_path: Path) -> None:
    text = script("lj", "plastic", heat=1.0, seed=2) + f"fix d all deform {how}\nrun 100\n"
    exact, fast = both(text, tmp_path)
    assert (exact.report.builds, exact.report.dangerous) == (fast.report.builds, fast.report.dangerous)
    assert (exact.box.length == fast.box.length).all()
    assert np.abs(rows(fast, "x") - rows(exact, "x")).max() <= 1e-11
    assert bonds(fast) == bonds(exact)


def test_reports_of_a_style(tmp_path: Path) -> None:
    """Bonds that bond_style fene finds too long are named in the same steps; each once, where LAMMPS names bonds across a face twice."""
    text = script("lj", "fene", heat=120.0, seed=4) + "timestep 0.006\nthermo_modify warn 1000\nrun 40\n"
    said = []
    for engine in (None, Fast()):
        with pytest.raises(ScriptError, match="Bad FENE bond"):
            simulate(text, tmp_path / f"{engine}", engine, screen := io.StringIO())
        lines = [line.split() for line in screen.getvalue().splitlines() if "FENE bond too long" in line]
        said.append({(int(step), frozenset((first, second))) for *_, step, first, second, _ in lines})
    assert said[0] == said[1]
    assert len(said[0]) > 100
