"""Contracts of the laws: close to 60 digits, the bits of LAMMPS on both engines, at any length.

Seen to fail: with r^2 - 2 r Rc + Rc^2 for (r - Rc)^2 in bond quartic (units); with r > Rc (1 + 1e-15) for its limit (bits).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pylmp.engines.exact import Exact
from pylmp.engines.fast import Fast
from tests.hard.alone import expected, forces, script
from tests.hard.laws import CASES, UNITS, Case, lengths, measure
from tests.support import lammps, simulate

SHORT = np.array([0.0, 1e-11, 1e-8, 1e-3])
RELEASED = [case for case in CASES if case.script]


def named(case: Case) -> str:
    return case.name


@pytest.mark.parametrize("case", CASES, ids=named)
def test_doubles_are_as_good_as_rounding_allows(case: Case) -> None:
    found = measure(case, 1500, 64)
    assert found.force.units <= UNITS
    assert found.energy is None or found.energy.units <= UNITS
    assert found.astray <= 1.0


def by_all(text: str, folder: Path) -> list[np.ndarray]:
    """Forces by LAMMPS, the exact and the fast engine."""
    done = lammps(text, folder)
    assert done.code == 0, done.screen
    found = [forces(folder)]
    for engine in (Exact(), Fast()):
        simulate(text, folder, engine)
        found.append(forces(folder))
    return found


@pytest.mark.parametrize("case", RELEASED, ids=named)
def test_all_programs_have_the_bits_of_the_law(case: Case, tmp_path: Path) -> None:
    """Around every limit one ulp at a time, and atoms on top of each other: what is not a number is so everywhere."""
    r = np.concatenate([lengths(case, 200, 64), SHORT])
    law = expected(case, r)
    for found in by_all(script(case, r, tmp_path), tmp_path):
        np.testing.assert_array_equal(found, law)


@pytest.mark.parametrize("case", [case for case in RELEASED if case.memory], ids=named)
def test_bonds_that_were_short_at_first(case: Case, tmp_path: Path) -> None:
    """r0 = 0, 1e-11, 1e-8, 1e-3: both engines as LAMMPS."""
    before = np.repeat([*SHORT, 1.0], 5)
    r = np.tile([0.0, 1e-11, 1.1e-8, 1e-3, 1.1], 5)
    theirs, *ours = by_all(script(case, r, tmp_path, before), tmp_path)
    for found in ours:
        np.testing.assert_array_equal(found, theirs)
