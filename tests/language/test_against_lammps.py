"""Flow, quotes, variables, formulas, conditions: the same text on screen and in the log as LAMMPS, good or bad."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.language.both import differences
from tests.language.random_scripts import script

CORPUS = Path(__file__).parents[1] / "corpus"


def _cases(name: str) -> list[str]:
    return [case.strip("\n") + "\n" for case in (CORPUS / name).read_text().split("\n==\n")[1:]]


CASES = _cases("language.cases")
WITH_ATOMS = _cases("language_atoms.cases")
FORMULAS = (CORPUS / "formulas.txt").read_text().splitlines()
VARIABLES = (
    "variable a equal 3\nvariable b string 4.5\nvariable c string foo\nvariable d index 7 8\nvariable l loop 2 5\n"
)
BOX = """units lj
atom_style bond
region b block 0 4 0 4 0 4
lattice sc 1.0
create_box 1 b bond/types 1 extra/bond/per/atom 2 extra/special/per/atom 2
create_atoms 1 box
mass 1 1.0
pair_style lj/cut 1.5
pair_coeff 1 1 1 1
velocity all create 1.0 123
fix 1 all nve
run 2
"""
AFTER_A_RUN = [
    'compute t all temp\nprint "$(c_t)"',
    'compute t all temp\nrun 0\nprint "$(c_t) $(c_t[1])"',
    'compute t all temp\nrun 0\nprint "$(c_t[7])"',
    'compute t all temp\nrun 0\nprint "$(c_t[1][2])"',
    'print "$(c_thermo_temp) $(c_thermo_press) $(c_thermo_pe)"',
    'print "$(c_thermo_press[1]) $(c_thermo_press[6])"',
    'print "$(f_1)"',
    'variable p equal pe\nrun 3\nprint "$p $(pe) $(etotal) $(step)"',
    'thermo_style custom step temp\nprint "$(pe)"',
    'thermo_style custom step temp\nrun 1\nprint "$(press)"',
    'variable k equal step*2\nthermo_style custom step v_k\nrun 2\nprint "$k"',
    "run 2 every 1 \"print 'at $(step)'\"",
    "variable k equal ramp(1,2)\nthermo_style custom step v_k\nthermo 1\nrun 4",
    "variable k equal vdisplace(1,2)\nthermo_style custom step v_k\nthermo 1\nrun 4",
    "variable k equal swiggle(1,2,3)\nvariable j equal cwiggle(1,2,3)\nthermo_style custom step v_k v_j\nthermo 1\nrun 4",
    "variable k equal stride(2,20,3)\nvariable j equal stagger(10,3)\nvariable m equal logfreq(1,4,10)\n"
    "thermo_style custom step v_k v_j v_m\nthermo 1\nrun 9",
    "clear\nunits lj\nprint \"$(version)\"\nregion b block 0 1 0 1 0 1",
]  # fmt: skip


def _report(wrong: list[str], count: int) -> None:
    assert not wrong, f"{len(wrong)} of {count} differ\n\n" + "\n======\n".join(wrong[:10])


def test_the_language_prints_what_lammps_prints(tmp_path: Path) -> None:
    assert len(set(CASES)) == len(CASES) >= 250
    _report(differences(CASES, tmp_path), len(CASES))


def test_the_language_after_a_run(tmp_path: Path) -> None:
    scripts = [BOX + case for case in WITH_ATOMS]
    _report(differences(scripts, tmp_path), len(scripts))


@pytest.mark.parametrize(
    "shape", ['print "$({})"\n', 'variable q equal "{}"\nprint "${{q}}"\n'], ids=["immediate", "equal"]
)
def test_formulas_before_there_is_a_box(shape: str, tmp_path: Path) -> None:
    scripts = [VARIABLES + shape.format(formula) for formula in FORMULAS]
    _report(differences(scripts, tmp_path), len(scripts))


def test_formulas_after_a_run(tmp_path: Path) -> None:
    named = [f'{VARIABLES}print "$({formula})"\n' for formula in FORMULAS if formula[:1].isalpha()]
    scripts = [BOX + script for script in (*named, *AFTER_A_RUN)]
    _report(differences(scripts, tmp_path), len(scripts))


def _expression(source: random.Random, depth: int) -> str:
    if depth == 0 or source.random() < 0.2:
        return source.choice(["1", "2.5", "0", "3e-2", ".5", "7", "PI", "v_a", "v_b", "1e10"])
    inner = [_expression(source, depth - 1) for _ in range(3)]
    kind = source.random()
    if kind < 0.5:
        signs = ["+", "-", "*", "/", "%", "^", "==", "!=", "<", "<=", ">", ">=", "&&", "||", "|^"]
        return f"{inner[0]}{source.choice(signs)}{inner[1]}"
    if kind < 0.65:
        return f"({inner[0]})"
    if kind < 0.8:
        return f"{source.choice('-!')}{inner[0]}"
    name = source.choice(
        ["sqrt", "exp", "ln", "log", "abs", "sign", "sin", "cos", "tan", "atan", "ceil", "floor", "round", "ternary"]
    )
    return f"{name}({inner[0]},{inner[1]},{inner[2]})" if name == "ternary" else f"{name}({inner[0]})"


def test_random_formulas(tmp_path: Path) -> None:
    source = random.Random(20250722)
    scripts = [f'{VARIABLES}print "$({_expression(source, 5)})"\n' for _ in range(600)]
    _report(differences(scripts, tmp_path), len(scripts))


def test_random_lines(tmp_path: Path) -> None:
    """Quotes, comments, continuations and variables in any order: the same words, or the same complaint."""
    source = random.Random(7)
    parts = [
        "x",
        "y ",
        "  ",
        "\t",
        '"',
        "'",
        '"""',
        "#",
        "&",
        "&\n",
        " &  \n",
        "$a",
        "${a}",
        "$b",
        "${c}",
        "$(1+2*3)",
        "z",
        "1.0",
    ]
    often = [6, 6, 4, 1, 3, 2, 1, 1, 1, 2, 2, 1, 1, 1, 1, 1, 4, 3]
    head = 'variable a string "A B"\nvariable b string \'q "r" s\'\nvariable c string "#z"\n'
    tail = '\nlabel l\nprint "<${v}>"\nnext v\njump SELF l\n'
    lines = ["variable v index k " + "".join(source.choices(parts, often, k=source.randint(1, 10))) for _ in range(800)]
    scripts = [head + line + tail for line in lines if not line.rstrip().endswith("&")]
    _report(differences(scripts, tmp_path), len(scripts))


def test_random_scripts(tmp_path: Path) -> None:
    scripts = [script(seed) for seed in range(600)]
    _report(differences(scripts, tmp_path), len(scripts))
