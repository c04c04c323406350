"""What the fast engine runs beyond one pair style, one bond style and the nearest image: against the exact engine and LAMMPS."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pylmp.engines.fast_ghosts import GhostRun
from tests.engines.scenes import script
from tests.engines.test_fast import assert_same_hundred_steps, both, rows
from tests.support import frames, lammps

TWO_PAIRS = "pair_style {} lj/cut 1.3 morse 1.4\npair_coeff {}\n"
SHARES = (
    "compute e all pe/atom\ncompute ep all pe/atom pair\ncompute s all stress/atom NULL\ncompute sb all stress/atom NULL bond\n"
    "dump s all custom 10 shares id c_e c_ep c_s[*] c_sb[*]\ndump_modify s sort id format float %.17g\n"
)
LISTS = (
    "compute c all coord/atom cutoff 1.1\ncompute r all rdf 20\ncompute r2 all rdf 20 1 2 cutoff 1.9\ncompute g two group/group all\n"
    "compute l all pair/local dist eng force\ncompute m all reduce sum c_l[1] c_l[2] c_l[3] inputs local\n"
    "fix r all ave/time 5 2 10 c_r[*] c_r2[*] mode vector file rdf\nfix g all ave/time 10 1 10 c_g c_g[1] c_g[2] c_g[3] c_m[*] file group format \" %.12g\"\nthermo_style custom step temp pe c_g c_g[1] c_g[2] c_g[3] c_m[*]\n"
    "dump s all custom 10 shares id c_c\ndump_modify s sort id format float %.17g\nthermo 7\nthermo_modify format float %.13g\n"
)
# name: pair, bond, faces, what follows, run with ghosts
SCENES = {
    "weights": ("lj", "harmonic", "p p p", "special_bonds lj/coul 0.0 0.25 0.5\n", True),
    "weights of flat": ("morse", "morse", "p s p", "special_bonds lj/coul 0.3 0.0 1.0\n", True),
    "narrow": ("lj", "harmonic", "p p p", "pair_style lj/cut 3.4\npair_coeff * * 0.3 0.9\npair_coeff 2 2 0.2 0.85 4.1\n", True),
    "narrow and broken": ("spring", "plastic", "p p p", "pair_style bpm/spring\npair_coeff * * 2.0 3.3 0.4\nneighbor 0.1 bin\n", True),
    "tilted": ("lj", "plastic", "p p p", "change_box all triclinic\nchange_box all xy final 1.5 xz final -0.7 yz final 0.9 remap\n", True),
    "sheared": ("lj", "quartic", "p p p", "change_box all triclinic\nfix d all deform 1 xy erate 0.9 remap x\n", True),
    "flow": ("spring", "spring", "p p p", "fix d all deform 1 x erate 0.05 y erate -0.03 remap v\n", True),
    "excluded types": ("lj", "harmonic", "p p p", "neigh_modify exclude type 1 2\n", True),
    "excluded groups": ("soft", "quartic", "p s p", "group low id < 100\nneigh_modify exclude group low two\n", True),
    "all pairs": ("lj", "plastic", "f f f", "neighbor 0.3 nsq\n", True),
    "hybrid": ("lj", "harmonic", "p p p", "pair_style hybrid lj/cut 1.3 soft 1.2\npair_coeff 1 1 lj/cut 1.0 0.95\npair_coeff 1 2 soft 9.0\npair_coeff 2 2 lj/cut 0.8 0.9\n", False),
    "overlay": ("lj", "quartic", "p p p", TWO_PAIRS.format("hybrid/overlay", "* * lj/cut 1.0 0.95\npair_coeff * * morse 1.0 3.0 1.0"), False),
    "overlay of springs": ("lj", "plastic", "f f f", "pair_style hybrid/overlay lj/cut 1.2 bpm/spring\npair_coeff * * lj/cut 1.0 0.95\npair_coeff 1 * bpm/spring 20.0 1.1 0.4\n", False),
    "half of overlay": ("lj", "harmonic", "p p p", TWO_PAIRS.format("hybrid/overlay", "* * lj/cut 1.0 0.95\npair_coeff * * morse 1.0 3.0 1.0") + "pair_modify pair morse compute no\n", False),
    "no pairs": ("lj", "harmonic", "p p p", "pair_modify compute no\n", False),
    "bonds of two kinds": ("lj", "harmonic", "p p p", "special_bonds lj/coul 0 1 1\nbond_style hybrid harmonic fene\nbond_coeff 1 harmonic 40 1.1\nbond_coeff 2 fene 20 2.2 1.0 1.0\n", False),
    "some that break": ("lj", "harmonic", "p p p", "special_bonds lj/coul 1 1 1\nbond_style hybrid bpm/spring overlay/pair yes quartic\nbond_coeff 1 bpm/spring 60 0.15 0.8\nbond_coeff 2 quartic 900 -0.55 0.25 1.65 30\n", False),
    "shares": ("lj", "fene", "p p p", SHARES, False),
    "shares of broken": ("lj", "quartic", "p s p", SHARES, False),
    "shares of two kinds": ("lj", "harmonic", "p p p", "bond_style hybrid harmonic fene\nbond_coeff 1 harmonic 40 1.1\nbond_coeff 2 fene 20 2.2 1.0 1.0\n" + SHARES, False),
    "neighbors": ("lj", "harmonic", "p p p", LISTS, False),
    "neighbors of broken": ("lj", "quartic", "p s p", LISTS, False),
    "neighbors of plastic": ("lj", "plastic", "p p p", LISTS, False),
    "neighbors in a tilted box": ("lj", "plastic", "p p p", "change_box all triclinic\nchange_box all xy final 1.0 remap\n" + LISTS, True),
    "shares in a tilted box": ("lj", "plastic", "p p p", "change_box all triclinic\nchange_box all xy final 1.0 remap\n" + SHARES, True),
}  # fmt: skip


def scene(name: str, heat: float = 1.0) -> str:
    k = list(SCENES).index(name)
    pair, bond, faces, more, _ = SCENES[name]
    newton = "on on" if "quartic" in bond + more else "on off"
    return script(pair, bond, flat="flat" in name, boundary=faces, newton=newton, heat=heat, seed=k) + more


def numbers(text: str) -> np.ndarray:
    """What a file of fix ave/time holds."""
    lines = [line.split() for line in text.splitlines() if not line.startswith("#")]
    return np.array([float(word) for words in lines for word in words if words[0].isdigit()])


def tables(folder: Path) -> list[np.ndarray]:
    return [table for _, _, table in frames(folder / "shares")] if (folder / "shares").exists() else []


@pytest.mark.parametrize("name", SCENES)
def test_forces_energies_virials(name: str, tmp_path: Path) -> None:
    text = scene(name)
    apart = f"displace_atoms all random 0.03 0.03 {'0.0' if 'dimension 2' in text else '0.03'} 99\n"
    text = f"{text}run 0\n{apart}run 0\n"
    exact, fast = both(text, tmp_path)
    assert (type(fast.lists) is GhostRun) == SCENES[name][-1]
    f = rows(exact, "f")
    limit = 1e-12 * np.sqrt((f * f).mean())
    assert limit > 0.0
    assert np.abs(rows(fast, "f") - f).max() <= limit
    there = lammps(text + "write_dump all custom forces id fx fy fz modify sort id format float %.17g\n", tmp_path / "lammps")
    assert np.abs(frames(there.folder / "forces")[0][2][:, 1:] - rows(fast, "f")).max() <= limit
    for names in (("pair", "bond"), ("pair_virial", "bond_virial")):
        one, other = (np.array([getattr(sim.tally, name) for name in names]) for sim in (exact, fast))
        assert np.abs(one - other).max() <= 1e-12 * np.abs(one).max(), names
    reference = tables(tmp_path / "lammps")
    assert len(reference) == ("shares" in name or "neighbors" in name)
    for ours, theirs in zip(tables(tmp_path / "fast"), reference, strict=True):
        assert np.abs(ours - theirs).max() <= 1e-12 * np.abs(theirs[:, 1:]).max()


@pytest.mark.parametrize("name", SCENES)
def test_hundred_steps(name: str, tmp_path: Path) -> None:
    exact, fast = both(scene(name, heat=2.0) + "run 100\n", tmp_path)
    assert exact.report.builds > 1
    for file, limit in (("rdf", 1e-5), ("group", 1e-9)) if "neighbors" in name else ():  # six digits are written, twelve
        one, other = (numbers((tmp_path / engine / file).read_text()) for engine in ("exact", "fast"))
        assert np.abs(one - other).max() <= limit * np.abs(one).max()
    assert_same_hundred_steps(exact, fast)
    shown = [tables(tmp_path / engine) for engine in ("exact", "fast")]
    for one, other in zip(*shown, strict=True):
        assert np.abs(one - other).max() <= 1e-9 * np.abs(one[:, 1:]).max()


def test_energy_of_each_pair_style(tmp_path: Path) -> None:
    """compute pair of the styles of a hybrid, while bonds break and their atoms become pairs."""
    text = scene("overlay of springs", heat=6.0)
    text += "compute one all pair lj/cut\ncompute two all pair bpm/spring\nthermo_style custom step pe c_one c_two bonds\nthermo 1\nthermo_modify format float %.15g\nrun 40\n"
    exact, fast = both(text, tmp_path)
    assert exact.bonds == fast.bonds < 2000
    for mine, theirs in zip(fast.pair.parts, exact.pair.parts, strict=True):
        assert abs(mine.energy - theirs.energy) <= 1e-9 * abs(theirs.energy) > 0.0


MELT = """units lj
lattice fcc 0.8442
region b block 0 5 0 5 0 5
create_box 1 b
create_atoms 1 box
mass 1 1
velocity all create 1.44 87287 loop geom
pair_style lj/cut 2.0
pair_coeff 1 1 1 1
neigh_modify every 1 delay 0
fix 1 all nve
compute c all coord/atom cutoff 1.3
compute m all reduce ave c_c
"""


@pytest.mark.parametrize(
    "more",
    [
        "fix m all ave/time 10 1 10 c_m file group\n",
        "variable k equal c_m/12\nfix a all adapt 7 pair lj/cut epsilon * * v_k\nfix m all ave/time 10 1 10 c_m file group\n",
        "variable k equal c_m\nfix p all addforce v_k 0 0\nfix v all viscous 0.1\nfix m all ave/time 10 1 10 c_m file group\n",
    ],
    ids=["now and then", "before forces", "behind forces"],
)
def test_ghosts_come_and_go(more: str, tmp_path: Path) -> None:
    """Arrays of few atoms grow when a compute asks for ghosts for the first time: between steps, or amid one."""
    exact, fast = both(MELT + more + "run 60\n", tmp_path)
    assert exact.report.builds == fast.report.builds > 3
    assert np.abs(rows(fast, "x") - rows(exact, "x")).max() <= 1e-11
    assert (tmp_path / "exact" / "group").read_text() == (tmp_path / "fast" / "group").read_text()
