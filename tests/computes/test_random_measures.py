"""Random scripts that measure: which computes are evaluated when, by whom, how often, and what is still known between runs.

LAMMPS is its shared library, so that a script costs milliseconds. Lines with numbers, errors and dump frames must be the same.
"""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from tests.setup.both import Made, on_pylmp, second_opinion

START = """units {units}
atom_style bond
newton {newton}
boundary {faces}
lattice sc {lattice}
region b {box}
create_box 2 b bond/types 1 extra/bond/per/atom 6 extra/special/per/atom 40
create_atoms 1 box
set group all type/fraction 2 0.4 {seed}
mass 1 1.0
mass 2 2.5
group two type 2
group few id 1:20
region ball sphere 1 1 1 1.2
displace_atoms all random 0.03 0.03 0.03 {seed}
pair_style lj/cut {cut}
pair_coeff * * {energy} {sigma}
special_bonds lj/coul 0 1 1
create_bonds many two two 1 0.5 {reach}
special_bonds lj/coul 0.5 1 1
bond_style harmonic
bond_coeff 1 {energy} {sigma}
velocity all create {heat} {seed} loop geom
thermo_modify lost ignore
fix 1 all nve
"""
COMPUTES = {
    "tp": "all temp/partial 1 0 1", "tc": "two temp/com", "tr": "all temp/region ball", "pr": "all pressure tp", "pv": "all pressure NULL virial",
    "pb": "all pressure NULL bond", "ke": "two ke", "pe": "all pe bond", "co": "two com", "gy": "few gyration", "ms": "all msd com yes",
    "ma": "few msd average yes", "va": "two vacf", "gg": "two group/group few", "pa": "all pair lj/cut", "ea": "all pe/atom", "sa": "two stress/atom tp",
    "sb": "all stress/atom NULL virial", "ka": "all ke/atom", "da": "all displace/atom", "ca": "all coord/atom cutoff {near}", "pp": "all property/atom vx fx",
    "re": "all reduce sum c_ea c_ka c_ca", "rs": "two reduce max c_sa[1] c_sb[2] c_da[4]", "rr": "all reduce/region ball ave c_pp[1] c_pp[2] vx",
    "rv": "all reduce ave v_atoms", "ch": "all chunk/atom type", "cc": "all com/chunk ch", "cr": "all reduce/chunk ch sum c_ea",
}  # fmt: skip
COLUMNS = (
    "c_tp c_tp[2] c_tc c_tr c_tr[4] c_pr c_pr[3] c_pv c_pb[2] c_ke c_pe c_co[1] c_gy c_gy[5] c_ms[4] c_ma[4] c_va[4] c_gg c_gg[2] c_pa c_re[1] c_re[2] "
    "c_re[3] c_rs[1] c_rs[2] c_rs[3] c_rr[1] c_rr[3] c_rv c_cc[2][1] c_cr[1] v_eq v_sum temp press pe ke etotal pxx epair ebond c_thermo_temp "
    "c_thermo_press[1] enthalpy fmax density"
).split()
PER_ATOM = "c_ea c_sa[1] c_sb[3] c_ka c_da[4] c_ca c_pp[2] v_atoms c_ch".split()
VALUES = "c_tp c_pr c_ke c_pe c_gg c_re[1] c_rs[2] c_rr[2] c_rv c_ma[4] v_eq c_thermo_press c_cr[2]".split()


def script(seed: int) -> str:
    """A script of a few runs with changing output and questions in between."""
    pick = random.Random(seed)
    lj = pick.random() < 0.7
    box = pick.choice(["block 0 4 0 4 0 4", "prism 0 4 0 4 0 4 0.3 0.0 0.2"])
    length = 1.0 if lj else 3.4
    lines = START.format(
        units="lj" if lj else "real", newton=pick.choice(["on on", "off on", "on off", "off off"]), faces=pick.choice(["p p p", "p p f"]),
        lattice=0.8 if lj else 3.9, box=box, seed=seed + 1, cut=1.5 * length, energy=1.0 if lj else 0.2, sigma=length, reach=1.13 * length,
        heat=1.5 if lj else 100,
    ).splitlines()  # fmt: skip
    lines += ["variable atoms atom x*vy+c_ka", "variable eq equal c_ke+step", "variable sum equal c_re[1]*2+temp"]
    lines += [f"compute {name} {words.format(near=1.3 * length)}" for name, words in COMPUTES.items()]
    if pick.random() < 0.5:
        lines.append(f"fix p all print {pick.randint(2, 4)} \"at $(step) {' '.join(f'$({v})' for v in pick.sample(VALUES, 2))}\"")
    if pick.random() < 0.5:
        lines.append(f"fix a all ave/time {pick.choice(['1 2 4', '2 1 2', '1 1 3'])} {' '.join(pick.sample(VALUES, 3))} file a.out")
    lines += [f"thermo {pick.choice([0, 1, 2, 3, 5])}"]
    dumps, moved = 0, False
    for _ in range(pick.randint(2, 4)):
        before = len(lines)
        if pick.random() < 0.7:
            lines.append("thermo_style custom step " + " ".join(pick.sample(COLUMNS, pick.randint(2, 8))))
            lines.append("thermo_modify lost ignore format float %.15g" + (f" temp {pick.choice(['tp', 'tc', 'thermo_temp'])}" if pick.random() < 0.3 else ""))
        if pick.random() < 0.5:
            dumps += 1
            fields = " ".join(pick.sample(PER_ATOM, pick.randint(1, 3)))
            lines.append(f"dump d{dumps} {pick.choice(['all', 'two'])} custom {pick.randint(1, 6)} d{dumps}.out id {fields}")
            lines.append(f"dump_modify d{dumps} sort id format float %.13g")
        run = f"run {pick.randint(0, 8)}"
        if pick.random() < 0.5 and len(lines) == before and not moved:  # LAMMPS crashes where a new dump or table was not readied
            run += " pre no"
        elif pick.random() < 0.2:
            run += f" every {pick.randint(1, 4)} \"print '{pick.choice(VALUES)}: $({pick.choice(VALUES)})'\""
        lines.append(run)
        moved = False
        for value in pick.sample(VALUES, pick.randint(0, 3)):
            lines.append(f'print "{value} $({value})"')
        if pick.random() < 0.4:
            moved = True
            lines.append(pick.choice(["displace_atoms two move 0.01 0 0.02 units box", "velocity few scale 0.9", "compute_modify tp dynamic/dof yes extra/dof 1"]))
            known = [value for value in VALUES if not value.startswith(("c_re", "c_rs", "c_cr"))]  # shares of ghosts that are gone
            lines.append(f'print "{(again := pick.choice(known))} $({again})"')
    return "\n".join(lines) + "\n"


def told(log: list[str]) -> list[str]:
    """Rows of numbers, printed values, warnings."""
    return [line for line in log if re.match(r" +\d|c_|v_|at \d|WARNING", line) and "CPU" not in line]


@pytest.mark.parametrize("seed", range(60))
def test_the_same_is_measured(seed: int, tmp_path: Path) -> None:
    text = script(seed)
    left, right = tmp_path / "lammps", tmp_path / "pylmp"
    for folder in (left, right):
        folder.mkdir()
    ours = on_pylmp(text, right)

    def wrong(reference: Made) -> list[str]:
        if ours.error != reference.error:
            return [f"{reference.error!r} {ours.error!r}"]
        found = [] if told(ours.log) == told(reference.log) else [f"{told(reference.log)}\n{told(ours.log)}"]
        names = sorted(path.name for path in left.glob("*.out"))
        return found + [name for name in names if (right / name).read_text() != (left / name).read_text()]

    assert not second_opinion(text, left, wrong), text
