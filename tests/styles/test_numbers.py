"""Forces and energies of every style against LAMMPS, to the last bit, over random separations, types and settings."""

from __future__ import annotations

import re

import numpy as np
import pytest

from pylmp.bonds.quartic import WALL2
from pylmp.pairs.lj_cut import lj, mix, row
from tests.styles.measure import SETUP, measure, shifts, squared
from tests.support import lammps, simulate

V = (0.7, -0.31, 0.23)


def force_field(commands: str, folder, newton: str = "on"):
    """The simulation that has heard these commands, its pair coefficients mixed."""
    sim, _ = simulate(SETUP.format(commands=commands, newton=newton), folder)
    sim.pair.init(sim)
    return sim


PAIRS = {
    "cut": "pair_style lj/cut 2.5\npair_coeff * * 1.3 0.9",
    "shift": "pair_style lj/cut 2.5\npair_modify shift yes\npair_coeff * * 1.3 0.9",
    "explicit": "pair_style lj/cut 2.5\npair_modify shift yes\npair_coeff * * 1.3 0.9\npair_coeff 1 2 0.7 1.1 1.9",
    **{
        rule: f"pair_style lj/cut 2.5\npair_modify shift yes mix {rule}\npair_coeff 1 1 1.3 0.9 2.1\npair_coeff 2 2 0.77 1.3 2.6"
        for rule in ("geometric", "arithmetic", "sixthpower")
    },
    "again": "pair_style lj/cut 2.5\npair_coeff * * 1.3 0.9\npair_coeff 2 2 1 1 3\npair_style lj/cut 1.7",
    "spring": "pair_style bpm/spring\npair_coeff * * 2.3 1.9 0.4",
    "cubic": "pair_style bpm/spring anharmonic yes\npair_coeff * * 2.3 1.9 0.4 5.1",
    **{
        "spring " + rule: f"pair_style bpm/spring\npair_modify mix {rule}\npair_coeff 1 1 2.3 1.9 0.4\npair_coeff 2 2 1.1 2.7 0.9"
        for rule in ("geometric", "arithmetic", "sixthpower")
    },
    "cubic mixed": "pair_style bpm/spring anharmonic yes\npair_coeff 1 1 2.3 1.9 0.4 3\npair_coeff 2 2 1.1 2.7 0.9 4",
    "soft": "pair_style soft 2.1\npair_coeff * * 1.3 1.9",
    "soft mixed": "pair_style soft 2.1\npair_modify mix sixthpower\npair_coeff 1 1 1.3 1.9\npair_coeff 2 2 0.7",
    "morse": "pair_style morse 2.1\npair_coeff * * 1.3 1.7 1.15 1.9",
    "morse shift": "pair_style morse 2.1\npair_modify shift yes\npair_coeff * * 1.3 1.7 1.15",
    "expand": "pair_style lj/expand 2.1\npair_coeff * * 1.3 0.9 0.17 1.9",
    "expand mixed": "pair_style lj/expand 1.9\npair_modify shift yes mix arithmetic\npair_coeff 1 1 1.3 0.8 0.17 1.7\n"
    "pair_coeff 2 2 0.7 0.95 -0.06",
    "zero": "pair_style zero 2.0\npair_coeff * *",
}  # fmt: skip


@pytest.mark.parametrize("name", PAIRS)
def test_pair(name: str, tmp_path) -> None:
    places = shifts(60, 0.8, 2.9)
    there = measure(PAIRS[name], places, V, tmp_path)
    (part,) = force_field(PAIRS[name], tmp_path).pair.parts
    if part.law is None:
        assert not there["force"].any()
        return
    assert np.count_nonzero(there["force"][:, 0]) > 10
    numbers = tuple(part.table[1, 2].tolist())
    for r2, d, dot, force, energy in zip(squared(there["d"]).tolist(), *lists(there, "epair"), strict=True):
        over_r, e = part.law(r2, dot, 1.0, numbers)
        assert [over_r * x + 0.0 for x in d] == force
        assert e == energy


def lists(there: dict[str, np.ndarray], energy: str) -> list[list[float]]:
    return [there[name].tolist() for name in ("d", "dot", "force", energy)]


BOND = "create_bonds single/bond 1 1 2\npair_style zero 2.0\npair_coeff * *\n"
SPRINGS = {
    "harmonic": ("bond_style harmonic\nbond_coeff 1 32.5 1.13", 0.7, 2.0),
    "zero": ("bond_style zero\nbond_coeff 1 1.0", 0.7, 2.0),
    "fene": ("bond_style fene\nbond_coeff 1 30 1.5 1.1 1.05", 0.7, 2.9),
    "fene/expand": ("bond_style fene/expand\nbond_coeff 1 30 1.5 1.1 0.95 0.13", 0.7, 3.0),
    "morse": ("bond_style morse\nbond_coeff 1 10.3 2.1 1.07", 0.7, 2.0),
    "nonlinear": ("bond_style nonlinear\nbond_coeff 1 10.3 1.07 1.9", 0.7, 2.0),
    "gromos": ("bond_style gromos\nbond_coeff 1 10.3 1.07", 0.7, 2.0),
    "harmonic/shift": ("bond_style harmonic/shift\nbond_coeff 1 10.3 1.07 2.1", 0.7, 2.5),
    "harmonic/shift/cut": ("bond_style harmonic/shift/cut\nbond_coeff 1 10.3 1.07 2.1", 0.7, 2.5),
    "quartic": ("bond_style quartic\nbond_coeff 1 1200 -0.55 0.25 1.3 34.6878", 0.8, 1.2999),
    "quartic long": ("bond_style quartic\nbond_coeff 1 81.7 -0.71 0.33 2.6 9.7", 0.8, 2.5999),
}


@pytest.mark.parametrize("name", SPRINGS)
@pytest.mark.parametrize("newton", ["on", "off"])
def test_bond(name: str, newton: str, tmp_path) -> None:
    commands, low, high = SPRINGS[name]
    there = measure(BOND + commands, shifts(60, low, high, 2), V, tmp_path, newton=newton)
    (part,) = force_field(BOND + commands, tmp_path, newton).bond.parts
    c = tuple(part.table[1].tolist())
    for r2, d, dot, force, energy in zip(squared(there["d"]).tolist(), *lists(there, "ebond"), strict=True):
        over_r, e, _, alive = part.law(r2, dot, (), c)
        assert [over_r * x + 0.0 for x in d] == force
        assert (e, alive) == (energy, True)


def test_quartic_takes_the_pair_interaction_out(tmp_path) -> None:
    """Order of rounding: pair force, bond force, minus pair force; energy of pairs: e, then -e."""
    bond, _, high = SPRINGS["quartic long"]
    commands = "create_bonds single/bond 1 1 2\npair_style lj/cut 2.0\npair_coeff * * 1.1 0.9\n" + bond
    there = measure(commands, shifts(60, 0.8, high, 3), V, tmp_path)
    sim = force_field(commands, tmp_path)
    (part,) = sim.bond.parts
    (lj,) = sim.pair.parts
    c, row = tuple(part.table[1].tolist()), tuple(lj.table[1, 2].tolist())
    for r2, d, dot, force, energy in zip(squared(there["d"]).tolist(), *lists(there, "ebond"), strict=True):
        over_r, e, _, _ = part.law(r2, dot, (), c)
        pair, _ = lj.law(r2, 0.0, 1.0, row)
        assert [(x * pair + x * over_r) + x * -pair for x in d] == force
        assert e == energy
    assert not there["epair"].any()


def test_a_quartic_bond_breaks_strictly_beyond_rc(tmp_path) -> None:
    """At r2 == Rc*Rc it holds; one bit more and it is gone, in the set-up already, for good."""
    rc = 1.25  # its square is a double, and so are the places
    places = np.array([[rc, 0, 0], [np.nextafter(rc, 2) - 2**-60, 0, 0], [rc + 2.0**-40, 0, 0], [1.0, 0, 0]])
    bond = f"bond_style quartic\nbond_coeff 1 1200 -0.55 0.25 {rc} 34.6878"
    there = measure(BOND + bond, places, (0, 0, 0), tmp_path)
    (part,) = force_field(BOND + bond, tmp_path).bond.parts
    alive = [part.law(r2, 0.0, (), tuple(part.table[1].tolist()))[3] for r2 in squared(there["d"]).tolist()]
    assert alive == [True, True, False, True]
    assert (there["ebond"] != 0.0).tolist() == [True, True, False, False]


OPTIONS = [
    "",
    "smooth no",
    "normalize yes",
    "normalize yes smooth no",
    "break no smooth no normalize on",
    "overlay/pair yes",
]


@pytest.mark.parametrize("options", OPTIONS)
def test_plastic_memory_over_a_random_history(options: str, tmp_path) -> None:
    """One bond is moved 120 times through both yield limits and past its breaking strain; set-up never breaks it."""
    weights = "" if "overlay" in options else "special_bonds lj 0 1 1 coul 1 1 1\n"
    style = f"{weights}bond_style bpm/spring/plastic {options}\nbond_coeff 1 10.3 0.3 0.51 0.021"
    random = np.random.default_rng(5)
    places = shifts(120, 1.0, 1.0, 4) * np.exp(np.cumsum(random.normal(0, 0.04, 120)))[:, None]
    there = measure(BOND + style, places, V, tmp_path, newton="off")
    (part,) = force_field(BOND + style, tmp_path, "off").bond.parts
    c = tuple(part.table[1].tolist())
    r2 = squared(there["d"]).tolist()
    h = (r2[0] ** 0.5, 0.0)
    yields = set()
    for q, (d, dot, force, energy) in enumerate(zip(*lists(there, "ebond"), strict=True)):
        before = h
        over_r, e, h, _ = part.law(r2[q], dot, h, c)
        yields.add((h[1] > before[1]) - (h[1] < before[1]))
        assert [over_r * x for x in d] == force
        assert e == energy == 0.0
    assert yields == {-1, 0, 1}


def test_plastic_vector(tmp_path) -> None:
    """Two atoms moved step by step: force on the first and equilibrium length, as LAMMPS prints them."""
    from pylmp.bonds.bpm_spring_plastic import plastic

    law = plastic({"smooth": True, "normalize": False})
    x, h = 5.5, (1.0, 0.0)
    moves = {
        0.0: (0.34999999999999998, 1.0), 0.1: (0.54991617131534842, 1.0799999999999996),
        0.25: (-1.3377175199569296, 1.3299999999999996), -0.65: (-2.9309887850104092e-15, 0.71999999999999931),
        0.30: (0.55000000000000016, 0.97999999999999909), 0.45: (-13.545898437499837, 1.4299999999999993),
    }  # fmt: skip
    for move, (force, length) in moves.items():
        x += move
        d = 4.5 - x
        over_r, _, h, _ = law(d * d, d * -0.7, h, (10.0, 0.3, 0.5, 0.02))
        assert (d * over_r, (1.0 + h[1]) * h[0]) == (force, length)


def test_unbreakable_is_the_manual_formula_as_lepton_evaluates_it(tmp_path) -> None:
    """LAMMPS has no quartic/unbreakable: its lepton style evaluates the manual's formula and differentiates it itself."""
    k, b1, b2, rc, u0 = 200.0, -0.55, -0.35, 1.9, 3.022
    quartic = f"{k}*(r-{rc})^2*(r-{rc}-{b1})*(r-{rc}-{b2})*step({rc}-r)+{u0}"
    wall = f"step({WALL2**0.5!r}-r)*(4*(1/r^12-1/r^6)+1)"
    lepton = f'bond_style lepton no_offset\nbond_coeff 1 1.0 "{quartic}+{wall}"'.replace("+-", "-").replace("--", "+")
    places = shifts(80, 0.75, 2.6, 6)
    there = measure(BOND + lepton.replace("1.0 ", "0.0 "), places, (0, 0, 0), tmp_path)
    commands = f"special_bonds lj/coul 0 1 1\nbond_style quartic/unbreakable\nbond_coeff 1 {k} {b1} {b2} {rc} {u0}"
    (part,) = force_field(BOND + commands, tmp_path).bond.parts
    c = tuple(part.table[1].tolist())
    r = np.sqrt(squared(there["d"]))
    assert (r > rc).any() and (r**2 < WALL2).any()
    for q, r2 in enumerate(squared(there["d"]).tolist()):
        over_r, e, _, alive = part.law(r2, 0.0, (), c)
        force = over_r * there["d"][q]
        assert alive or r[q] > rc
        assert np.abs(force - there["force"][q]).max() <= 1e-12 * max(1.0, np.abs(force).max())
        assert abs(e - there["ebond"][q]) <= 1e-12 * max(1.0, abs(e))
        if r[q] > rc:
            assert e == u0 and not force.any()


@pytest.mark.parametrize("rule", ["geometric", "arithmetic", "sixthpower"])
def test_mixing_over_random_coefficients(rule: str, tmp_path) -> None:
    """Forty pairs of coefficients, remixed at every init, with the offset of shift yes."""
    random = np.random.default_rng(11)
    sets = random.uniform(0.5, 2.0, (40, 4)).tolist()
    lines, places = [], shifts(1, 1.2, 1.2)
    x, y, z = (10.0 + places[0]).tolist()
    for e1, s1, e2, s2 in sets:
        lines += [
            f"pair_coeff 1 1 {e1!r} {s1!r} {s1 * 2.1!r}", f"pair_coeff 2 2 {e2!r} {s2!r} {s2 * 2.3!r}", "run 0 post no",
            'print "@ $(fx[1]:%.17g) $(epair:%.17g)"',
        ]  # fmt: skip
    commands = f"pair_style lj/cut 2.5\npair_modify shift yes mix {rule}"
    script = SETUP.format(commands=commands, newton="on") + f"set atom 2 x {x!r} y {y!r} z {z!r}\n" + "\n".join(lines)
    outcome = lammps(script + "\n", tmp_path, "-log", "none")
    found = [list(map(float, row.split())) for row in re.findall(r"^@ (.*)$", outcome.screen, re.M)]
    assert len(found) == len(sets)
    d = np.array([10.0, 10.0, 10.0]) - np.array([x, y, z])
    for values, (force, energy) in zip(sets, found, strict=True):
        e1, s1, e2, s2 = values
        (epsilon, sigma), cut = mix((e1, s1), s1 * 2.1, (e2, s2), s2 * 2.3, rule)
        over_r, e = lj(float(squared(d[None])[0]), 0.0, 1.0, row((epsilon, sigma), cut, True))
        assert (over_r * d[0], e) == (force, energy)


def test_tail_corrections(tmp_path) -> None:
    """Five atoms out of each other's reach: energy and pressure are those of the tails alone."""
    script = """units lj
region b block 0 13.1 0 12.3 0 11.7
create_box 3 b
create_atoms 1 single 1 1 1
create_atoms 2 single 5 5 5
create_atoms 2 single 9 9 9
create_atoms 2 single 9 1 9
create_atoms 3 single 1 9 9
mass * 1.0
pair_style lj/cut 2.5
pair_modify tail yes
pair_coeff 1 1 1.3 0.9 2.1
pair_coeff 2 2 0.7 1.17 2.6
pair_coeff 3 3 0.77 1.37
pair_coeff 2 3 0.6 1.23 2.2
fix 1 all nve
run 0
print "@ $(etail:%.17g) $(epair:%.17g) $(press:%.17g) $(pxx:%.17g)"
"""
    (there,) = re.findall(r"^@ .*$", lammps(script, tmp_path / "lammps").screen, re.M)
    (here,) = re.findall(r"^@ .*$", simulate(script, tmp_path / "pylmp")[1], re.M)
    assert here == there
    assert float(here.split()[1]) < 0.0
