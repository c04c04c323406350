"""Wrong bond and pair commands: the same first sentence from LAMMPS and from pylmp, also when several things are wrong."""

from __future__ import annotations

import re

import pytest

from pylmp.text.diagnostic import ScriptError
from tests.support import lammps, simulate

BOX = """units lj
atom_style bond
newton on {newton}
comm_modify vel yes cutoff 3.0
region b block 0 6 0 6 0 6
create_box 2 b bond/types 2 extra/bond/per/atom 4 extra/special/per/atom 10
create_atoms 1 single 2.0 3 3
create_atoms 2 single 3.0 3 3
mass * 1.0
"""
PAIR = "pair_style lj/cut 2.0; pair_coeff * * 1.0 1.0; "
ONES = "special_bonds lj/coul 1 1 1; "
WEIGHTS = "special_bonds lj 0 1 1 coul 1 1 1; "
PLASTIC = "bond_style bpm/spring/plastic"
COEFFS = "; bond_coeff * 10 0.3 0.5 0.02"
RUN = "; fix 1 all nve; run 0"
QUARTIC = "bond_style quartic; bond_coeff * 1 2 3 4 5"
HYBRID = "bond_style hybrid quartic bpm/spring/plastic overlay/pair yes store/local f 5 time; "

KEYWORDS = [
    f"{PLASTIC} {words}"
    for words in (
        "smooth no overlay/pair maybe", "smoth no overlay/pair maybe", "smooth overlay/pair yes", "smooth maybe break foo",
        "smooth", "normalize", "break", "break no", "overlay/pair", "store/local f 10 time foo", "store/local f 10 smooth no",
        "store/local f 10", "store/local f", "store/local f 10 foo", "store/local f -1 time", "store/local f 1.5 time",
        "store/local f-x 10 time", "smooth Yes", "smooth no no", "yes", "0", "overlay/pair yes foo break maybe",
        "foo smooth maybe", "smooth maybe foo", "smooth foo break", "normalize smooth yes",
    )
]  # fmt: skip
STYLES = [
    "bond_style", "bond_style zero foo", "bond_style zero nocoeff nocoeff", "bond_style harmonic foo",
    "bond_style quartic foo", "bond_style zero/omp", "bond_style bpm/spring/plastic/omp", "bond_style foo",
    "bond_style hybrid", "bond_style hybrid foo", "bond_style hybrid none", "bond_style hybrid hybrid",
    "bond_style hybrid quartic quartic", "bond_style hybrid quartic harmonic", "bond_style hybrid harmonic zero foo",
    "bond_style hybrid quartic bpm/spring/plastic foo", "bond_style hybrid bpm/spring/plastic harmonic",
    "bond_style hybrid quartic none",
]  # fmt: skip
COEFFICIENTS = [
    "bond_style quartic; bond_coeff 1", "bond_style quartic; bond_coeff 3 1 2 3 4 5",
    "bond_style quartic; bond_coeff 1 1 2 3 4 5 6", "bond_style quartic; bond_coeff 1*2 1 2 3 4 x",
    "bond_style quartic; bond_coeff 0 1 2 3 4 5", "bond_style quartic; bond_coeff -1 1 2 3 4 5",
    "bond_style quartic; bond_coeff a 1 2 3 4 5", "bond_style quartic; bond_coeff 0*1 1 2 3 4 5",
    "bond_style quartic; bond_coeff 1*3 1 2 3 4 5", "bond_style quartic; bond_coeff 2*1 1 2 3 4 5",
    "bond_style zero; bond_coeff * 1.0 2.0", "bond_style zero; bond_coeff * a", "bond_style harmonic; bond_coeff * 1",
    "bond_style harmonic; bond_coeff * 1 2 3", "bond_style none; bond_coeff * 1",
    HYBRID + "bond_coeff 1 1 2 3 4 5", HYBRID + "bond_coeff 1 zz 1 2 3 4 5", HYBRID + "bond_coeff 1 quartic 1",
    HYBRID + "bond_coeff 1 skip", HYBRID + "bond_coeff 3 quartic 1 2 3 4 5", HYBRID + "bond_coeff 1 bpm/spring/plastic 1",
    f"{PLASTIC}; bond_coeff * 10 0.3 0.5", f"{PLASTIC}; bond_coeff * 10 0.3 0.5 0.1 2",
]  # fmt: skip
PAIRS = [
    "pair_style", "pair_style lj/cut", "pair_style lj/cut a", "pair_style lj/cut 2 3", "pair_style zero", "pair_style foo",
    "pair_style zero 1.0 foo", "pair_style zero nocoeff", "pair_style zero a", "pair_style bpm/spring anharmonic",
    "pair_style bpm/spring anharmonic maybe", "pair_style bpm/spring foo", "pair_style bpm/spring 2.0",
    "pair_modify shift yes", "pair_coeff * * 1 1", "pair_style none; pair_coeff * * 1 1",
    "pair_style zero 1.0; pair_coeff * * 2.0 3", "pair_style zero 1.0; pair_coeff * * a",
    "pair_style bpm/spring; pair_coeff * * 1 1", "pair_style bpm/spring; pair_coeff * * 1 1 1 1",
    "pair_style bpm/spring; pair_coeff * * 1 1 x", "pair_style bpm/spring anharmonic yes; pair_coeff * * 1 1 1",
    "pair_style bpm/spring; comm_modify vel no" + RUN,
    "pair_style bpm/spring; pair_coeff * * 1 1 1; comm_modify vel no" + RUN,
    "pair_style bpm/spring; pair_modify shift yes tail yes" + RUN,
] + [
    "pair_style lj/cut 2.0; " + words
    for words in (
        "pair_coeff", "pair_coeff 1", "pair_coeff 1 1", "pair_coeff 1 1 1", "pair_coeff 1 1 1 1 1 1", "pair_coeff 3 1 1 1",
        "pair_coeff 1 3 1 1", "pair_coeff 2* 1 1 1", "pair_coeff 2*2 1 1 1", "pair_coeff 0 1 1 1", "pair_coeff a 1 1 1",
        "pair_coeff * a 1 1", "pair_coeff * * x 1", "pair_coeff * * 1 x", "pair_coeff * * 1 1 x", "pair_modify",
        "pair_modify foo", "pair_modify mix", "pair_modify mix foo", "pair_modify shift", "pair_modify shift maybe",
        "pair_modify tail", "pair_modify shift yes mix", "pair_modify shift yes no",
        "pair_modify tail yes shift yes; pair_coeff * * 1 1" + RUN, "fix 1 all nve; run 0", "pair_coeff 1 1 1 1" + RUN,
        "pair_coeff 1 2 1 1" + RUN,
    )
]  # fmt: skip
BROKEN = [
    HYBRID + "bond_coeff 1 quartic 1 2 3 4 5" + RUN,
    ONES + HYBRID + "bond_coeff 1 quartic 1 2 3 4 5; bond_coeff 2 none" + RUN,
    HYBRID + "bond_coeff 1 quartic 1 2 3 4 5; bond_coeff 2 bpm/spring/plastic 1 2 3 4" + RUN,
    "bond_style hybrid bpm/spring/plastic quartic; bond_coeff 2 quartic 1 2 3 4 5; "
    "bond_coeff 1 bpm/spring/plastic 1 2 3 4" + RUN,
    WEIGHTS + "bond_style hybrid bpm/spring/plastic quartic; bond_coeff * quartic 1 2 3 4 5" + RUN,
    "bond_style hybrid quartic" + RUN, "bond_style zero nocoeff" + RUN,
    WEIGHTS + PLASTIC + RUN, WEIGHTS + PLASTIC + "; bond_coeff 1 10 0.3 0.5 0.02" + RUN,
    PLASTIC + COEFFS + RUN, "special_bonds lj 0 1 1; " + PLASTIC + COEFFS + RUN,
    "special_bonds lj 1 1 1; " + PLASTIC + " overlay/pair yes" + COEFFS + RUN,
    WEIGHTS + PLASTIC + " overlay/pair yes break no smooth no" + COEFFS + RUN,
    WEIGHTS + "comm_modify vel no; " + PLASTIC + COEFFS + RUN,
    PLASTIC + " break no smooth no; comm_modify vel no" + COEFFS + RUN,
    PLASTIC + " store/local brk 5 time" + COEFFS + "; unfix brk" + RUN,
    WEIGHTS + "fix brk all nve; " + PLASTIC + " store/local brk 5 time" + COEFFS + "; run 0",
    WEIGHTS + PLASTIC + " store/local brk 5 time; " + PLASTIC + "; unfix brk",
    WEIGHTS + PLASTIC + " store/local brk 5 time; bond_style none; unfix brk",
    QUARTIC + RUN, "special_bonds lj 1 1 0.5 coul 1 1 1; " + QUARTIC + RUN,
    ONES + "bond_style quartic; bond_coeff 2 1 2 3 4 5" + RUN,
]  # fmt: skip
NEWTON_ON = [WEIGHTS + PLASTIC + COEFFS + RUN, PLASTIC + COEFFS + RUN]

CASES = [
    *(("off", case) for case in (*KEYWORDS, *STYLES, *COEFFICIENTS, *PAIRS, QUARTIC + RUN)),
    *(("off", PAIR + case) for case in BROKEN),
    *(("on", PAIR + case) for case in NEWTON_ON),
]
SPECIAL = {
    "units lj\natom_style atomic\nbond_style quartic\n": "Bond_style command when no bonds allowed",
    "units lj\natom_style bond\nbond_style quartic\nbond_coeff 1 1\n": "Bond_coeff command before simulation box is defined",
    "units lj\npair_coeff 1 1\n": "Pair_coeff command before simulation box is defined",
    BOX.format(newton="on")
    .replace("0 6 0 6 0 6", "0 6 0 6 -0.5 0.5")
    .replace(" 3 3\n", " 3 0\n")
    .replace("units lj", "units lj\ndimension 2")
    + "pair_style lj/cut 2\npair_modify tail yes\nrun 0\n": "Cannot use pair tail corrections with 2d simulations",
}


def sentence(text: str) -> str:
    """LAMMPS's first error, without file name, link and blank ends."""
    found = re.search(r"^ERROR(?: on proc 0)?: ((?:.|\n)*?)(?: \(src|\nFor more|\Z)", text, re.M)
    assert found, text[-500:]
    return found[1].strip()


def both(script: str, folder) -> tuple[str, str]:
    said = sentence(lammps(script, folder, "-log", "none").screen)
    with pytest.raises(ScriptError) as caught:
        simulate(script, folder)
    return said, caught.value.diagnostic.message.strip()


@pytest.mark.parametrize(("newton", "case"), CASES)
def test_same_sentence(newton: str, case: str, tmp_path) -> None:
    said, ours = both(BOX.format(newton=newton) + case.replace("; ", "\n") + "\n", tmp_path)
    assert ours == said


@pytest.mark.parametrize("script", SPECIAL)
def test_same_sentence_elsewhere(script: str, tmp_path) -> None:
    said, ours = both(script, tmp_path)
    assert ours == said == SPECIAL[script]
