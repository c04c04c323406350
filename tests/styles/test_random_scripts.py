"""Random mixtures of style, keywords, coefficients, newton and commands between two runs: every digit as on LAMMPS."""

from __future__ import annotations

import random
import re

import pytest

from pylmp.text.diagnostic import ScriptError
from tests.styles.test_runs import CELL, LOCAL, ONES, SPRING, WCA, WEIGHTS
from tests.styles.test_store_local import thermo
from tests.support import lammps, simulate

SIXTH = "pair_style lj/cut 1.3\npair_modify mix sixthpower\npair_coeff 1 1 0.9 1.0\npair_coeff 2 2 1.1 0.9 1.4"
PAIRS = (WCA, SPRING.format("", ""), SPRING.format(" anharmonic yes", " 60"), SIXTH)
NEWTON = ("on on", "off on", "on off", "off off")


def script(seed: int) -> str:
    dice = random.Random(seed)

    def plastic(kind: int) -> str:
        k, eps_c, gamma, eps_p = (dice.uniform(*range_) for range_ in ((20, 80), (0.1, 0.4), (0, 1), (0, 0.1)))
        return f"{k:.3f} {eps_c:.3f} {gamma:.3f} {eps_p:.3f}"

    def quartic(kind: int) -> str:
        return f"{dice.uniform(600, 1300):.1f} -0.55 0.25 {dice.uniform(1.2, 1.4):.3f} 34.7"

    def lines(name: str, coeffs, word: str = "", types=(1, 2, 3)) -> str:
        return name + "".join(f"\nbond_coeff {kind} {word} {coeffs(kind)}" for kind in types)

    style = dice.choice(("plastic", "plastic", "quartic", "hybrid", "harmonic"))
    newton = dice.choice(NEWTON)
    overlay, breaks, normalize = (dice.choice((True, False)) for _ in range(3))
    overlay = overlay or (style == "hybrid" and breaks)
    smooth = breaks and dice.choice((True, False))
    said = {"overlay/pair": overlay, "break": breaks, "smooth": smooth, "normalize": normalize}
    options = " ".join(f"{key} {'yes' if said[key] else 'no'}" for key in dice.sample(list(said), 4))
    weights = ONES
    between = dice.choice(("", "write_data x.data", "delete_bonds all stats"))
    if style == "plastic":
        if breaks and not overlay:
            newton, weights = dice.choice(NEWTON[2:]), WEIGHTS
        bond = lines(f"bond_style bpm/spring/plastic {options}", plastic)
    elif style == "quartic":
        bond = lines("bond_style quartic", quartic)
    elif style == "hybrid":
        parts = dice.sample(["quartic", f"bpm/spring/plastic {options}"], 2)
        bond = lines(f"bond_style hybrid {parts[0]} {parts[1]}", quartic, "quartic", (1, 3))
        bond += lines("", plastic, "bpm/spring/plastic", (2,))
        between = between.replace("delete_bonds all stats", "")
    else:
        weights = dice.choice(("lj/coul 0 1 1", "lj 0.3 0.5 1 coul 1 1 1", ONES))
        bond = lines("bond_style harmonic", lambda kind: f"{dice.uniform(20, 60):.2f} 1.0{kind}")
    after = "" if style == "hybrid" else LOCAL
    after += (
        f"neighbor {dice.uniform(0.2, 0.5):.2f} bin\nrun {dice.randint(20, 90)}\n{between}\nrun {dice.randint(20, 90)}"
    )
    return CELL.format(newton=newton, pair=dice.choice(PAIRS), weights=weights, bond=bond, after=after)


@pytest.mark.parametrize("seed", range(24))
def test_same_run(seed: int, tmp_path) -> None:
    text = script(seed)
    there = lammps(text, tmp_path / "lammps")
    if there.code:
        said = re.findall(r"^ERROR(?: on proc 0)?: (.*?)(?: \(src|$)", there.screen, re.M)[0]
        with pytest.raises(ScriptError, match=re.escape(said)):
            simulate(text, tmp_path / "pylmp")
        return
    assert thermo(simulate(text, tmp_path / "pylmp")[1]) == thermo(there.screen)
    for dump in ("atoms", "bonds"):
        if (tmp_path / "lammps" / dump).exists():
            assert (tmp_path / "pylmp" / dump).read_text() == (tmp_path / "lammps" / dump).read_text()
