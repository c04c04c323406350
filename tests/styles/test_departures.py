"""Syntax of the manual that the release lacks: accepted with a warning that names the departure, refused under --strict."""

from __future__ import annotations

import io

import pytest

from pylmp.engines.exact import Exact
from pylmp.interpreter import run_text
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from tests.styles.test_errors import BOX, HYBRID, ONES, PAIR, RUN, both
from tests.support import lammps, simulate

DEPARTURES = {
    "bond_style bpm/spring/plastic myfix 1000 time id1 id2": (
        "D001",
        "Illegal bond bpm command, invalid argument myfix",
    ),
    "bond_style hybrid quartic bpm/spring/plastic brk 5 time": (
        "D001",
        "Illegal bond bpm command, invalid argument brk",
    ),
    "bond_style quartic/breakable": ("D004", "Unrecognized bond style 'quartic/breakable'"),
    "bond_style quartic/unbreakable": ("D004", "Unrecognized bond style 'quartic/unbreakable'"),
    "bond_style quartic/breakable/omp": ("D004", "Unrecognized bond style 'quartic/breakable/omp'"),
    "bond_style hybrid quartic/breakable quartic/unbreakable": ("D004", "Unrecognized bond style 'quartic/breakable'"),
}


def hear(script: str, *, strict: bool) -> str:
    screen = io.StringIO()
    sim = Simulation(Console(screen), Exact())
    sim.strict = strict
    run_text(sim, script)
    return screen.getvalue()


@pytest.mark.parametrize("line", DEPARTURES)
def test_accepted_with_a_warning_and_refused_when_strict(line: str, tmp_path) -> None:
    code, sentence = DEPARTURES[line]
    script = BOX.format(newton="off") + line + "\n"
    assert f"WARNING: [{code}] " in hear(script, strict=False)
    with pytest.raises(ScriptError) as caught:
        hear(script, strict=True)
    assert caught.value.diagnostic.message == sentence
    assert caught.value.diagnostic.hint
    assert f"ERROR: {sentence}" in lammps(script, tmp_path).screen


@pytest.mark.parametrize(
    "line", ["bond_style bpm/spring/plastic store/local myfix 1000 time id1 id2", "bond_style quartic"]
)
def test_what_the_release_accepts_is_no_departure(line: str) -> None:
    for strict in (False, True):
        assert "WARNING" not in hear(BOX.format(newton="off") + line + "\n", strict=strict)


def test_a_type_without_style_has_no_length(tmp_path) -> None:
    """bond_coeff N none is taken and then stops every run, in LAMMPS too."""
    coeffs = "bond_coeff 1 quartic 1 2 3 4 5; bond_coeff 2 bpm/spring/plastic 1 2 3 4; bond_coeff 1 none; bond_coeff 1 quartic 1 2 3 4 5"
    three = BOX.format(newton="off").replace("bond/types 2", "bond/types 3")
    script = three + (PAIR + ONES + HYBRID + coeffs + "; bond_coeff 3 none" + RUN).replace("; ", "\n") + "\n"
    said, ours = both(script, tmp_path)
    assert ours == said == "Invoked bond equil distance on bond style none"


CHAINS = """units lj
atom_style bond
region b block 0 20 0 10 0 10
create_box 1 b bond/types 2 extra/bond/per/atom 2 extra/special/per/atom 6
create_atoms 1 single 5.00 3 5
create_atoms 1 single 5.93 3 5
create_atoms 1 single 6.91 3 5
create_atoms 1 single 5.00 7 5
create_atoms 1 single 5.95 7 5
create_atoms 1 single 6.90 7 5
mass * 1.0
pair_style lj/cut 1.122462048309373
pair_modify shift yes
pair_coeff * * 1.0 1.0
special_bonds lj/coul 1 1 1
create_bonds single/bond 1 1 2
create_bonds single/bond 1 2 3
create_bonds single/bond 2 4 5
create_bonds single/bond 2 5 6
bond_style {style}
bond_coeff 1 {first} 1200 -0.55 0.25 1.3 34.6878
bond_coeff 2 {second} 1200 -0.55 0.25 1.3 34.6878
velocity all create 1.0 5 loop geom
fix 1 all nve
{more}
timestep 0.002
dump 1 all custom 20 atoms id x y z vx vy vz
dump_modify 1 format float "%.17g" sort id
thermo_style custom step bonds c_types
run 400
"""
TYPES = "compute types all count/type bond"


def test_breakable_and_unbreakable_side_by_side(tmp_path) -> None:
    """The breakable chain moves as it does alone; pulled apart, its bonds break and those of the other chain do not."""
    simulate(CHAINS.format(style="quartic", first="", second="", more=TYPES), tmp_path / "alone")
    mixed = {
        "style": "hybrid quartic/breakable quartic/unbreakable",
        "first": "quartic/breakable",
        "second": "quartic/unbreakable",
    }
    simulate(CHAINS.format(**mixed, more=TYPES), tmp_path / "mixed")
    rows = [
        [line for line in (tmp_path / name / "atoms").read_text().splitlines() if line[:2] in ("1 ", "2 ", "3 ")]
        for name in ("alone", "mixed")
    ]
    assert len(rows[0]) > 60
    assert rows[0] == rows[1]
    pull = TYPES + "\ngroup end id 3 6\nvelocity end set 15.0 0 0\nfix 2 end setforce 0 NULL NULL"
    sim, _ = simulate(CHAINS.format(**mixed, more=pull), tmp_path / "pulled")
    kinds = sim.atoms.bond_type[: sim.atoms.n].ravel().tolist()
    assert kinds.count(2) == 2
    assert kinds.count(1) < 2
