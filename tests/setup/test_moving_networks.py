"""Random bonded networks that break in boxes that are tilted, follow their atoms, or change: LAMMPS and pylmp agree to the last bit."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.setup.both import all_agree, difference
from tests.setup.test_moving_boxes import deform

SCRIPTS = 5  # a seed


def script(seed: int) -> str:
    r = random.Random(seed)
    plastic = r.random() < 0.5
    flat = r.random() < 0.2
    newton = r.choice(["on off", "off off"] if plastic else ["on on", "on off", "off on", "off off"])
    letters = [r.choice(["p", "p", "p", "s", "m"]) for _ in range(3)]
    if flat:
        letters[2] = "p"
    cells = [r.randint(3, 5), r.randint(3, 5), 1 if flat else r.randint(2, 4)]
    sides = f"0 {cells[0]} 0 {cells[1]} " + ("-0.5 0.5" if flat else f"0 {cells[2]}")
    tilts = [round(r.uniform(-1.5, 1.5), 2) * (not flat or k == 0) for k in range(3)]
    lattice = "sq 1.0" if flat else "sc 1.0"
    lines = [
        "units lj", *(["dimension 2"] if flat else []), f"boundary {' '.join(letters)}", "atom_style bond", f"newton {newton}",
        "comm_modify vel yes cutoff 3.2", "special_bonds lj 0 1 1 coul 0 1 1", f"lattice {lattice}",
        f"region cell prism {sides} {' '.join(map(str, tilts))}",
        "create_box 2 cell bond/types 2 extra/bond/per/atom 14 extra/special/per/atom 60", "create_atoms 1 box",
        f"set group all type/fraction 2 0.4 {r.randint(1, 99)}", "mass 1 1.0", "mass 2 1.6", "group two type 2", "group some id < 12",
        f"displace_atoms all random 0.05 0.05 {0.0 if flat else 0.05} {r.randint(1, 999)}",
    ]  # fmt: skip
    if plastic:
        lines += ["pair_style bpm/spring", "pair_coeff * * 40 1.0 0.8", "pair_coeff 1 2 50 1.05 0.5"]
    else:
        lines += ["pair_style lj/cut 1.3", "pair_modify shift yes", "pair_coeff * * 1.0 0.95"]
    lines += ["create_bonds many two two 2 0.8 1.25", "create_bonds many all all 1 0.8 1.25"]
    if plastic:
        words = r.choice(["", " smooth no", " normalize yes", " store/local gone 20 time id1 id2"])
        style, limits = r.choice([("bpm/spring/plastic", (" 0.02", " 0.03")), ("bpm/spring", ("", ""))])
        lines += ["special_bonds lj 0 1 1 coul 1 1 1", f"bond_style {style}{words}", f"bond_coeff 1 80 0.12 0.5{limits[0]}", f"bond_coeff 2 60 0.1 0.3{limits[1]}"]
    else:
        lines += ["special_bonds lj/coul 1 1 1", "bond_style quartic", "bond_coeff 1 1200 -0.55 0.25 1.35 34.6878", "bond_coeff 2 900 -0.55 0.25 1.3 30.0"]
    lines += [
        f"velocity all create {r.choice([0.3, 1.0]) if plastic else r.choice([2.0, 8.0])} {r.randint(1, 999)}",
        f"velocity all set {r.uniform(-2, 2)!r} {r.uniform(-2, 2)!r} 0 sum yes", "fix 1 all nve", *(["fix 4 all enforce2d"] if flat else []),
        f"timestep {0.004 if plastic else 0.002}", f"neigh_modify {r.choice(['every 1 delay 0', 'every 2 delay 4', 'every 5 check no'])}",
        f"atom_modify sort {r.choice([0, 25, 1000])} 0.0", "variable grow equal 0.03*elapsed*dt", "variable pace equal 0.03", "thermo 25",
        "thermo_style custom step temp ebond pe press pxx pxy pyz bonds xlo xhi ylo yhi zlo zhi xy xz yz nbuild ndanger",
        "thermo_modify lost warn lost/bond ignore format float %.17g",
    ]  # fmt: skip
    if r.random() < 0.8:
        words = deform(r, not flat and not any(letter in "sm" for letter in letters), [x == "p" and not (flat and k == 2) for k, x in enumerate(letters)])
        lines.append(words)
    after = [f"delete_bonds all stats{r.choice(['', ' remove', ' remove special'])}"]
    if plastic and r.random() < 0.3:
        after.append("create_bonds many all all 1 0.8 1.35")
    if letters != ["p", "p", "p"]:
        after = []  # once atoms are lost there, LAMMPS finds what bonds remember in the rows of others
    lines += ["run 60 post no", *after, f"run {r.randint(20, 60)} post no"]
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("seed", range(6))
def test_networks(seed: int, tmp_path: Path) -> None:
    all_agree(script, range(1000 * seed, 1000 * seed + SCRIPTS), tmp_path)


@pytest.mark.parametrize("lost", [2, 3, 4])
@pytest.mark.parametrize("command", ["delete_bonds all stats special", "create_bonds single/bond 1 1 7"])
def test_bonds_to_lost_atoms_count(lost: int, command: str, tmp_path: Path) -> None:
    """With newton bond on, or 1-3 weights, LAMMPS crashes."""
    bonds = ["1 2", "2 3", "3 4", "4 5", "6 5", "3 6", "4 2"]
    lines = [
        "units lj", "boundary f f f", "atom_style bond", "newton off", "special_bonds lj/coul 0 1 1", "region b block 0 10 0 10 0 10",
        "create_box 1 b bond/types 1 extra/bond/per/atom 9 extra/special/per/atom 20",
        *(f"create_atoms 1 single {k} 5 5" for k in range(1, 8)), "mass * 1", "pair_style zero 3.0", "pair_coeff * *",
        "bond_style zero", "bond_coeff *", *(f"create_bonds single/bond 1 {pair} special {'no' if pair != bonds[-1] else 'yes'}" for pair in bonds),
        "fix 1 all nve", "timestep 0.01", "thermo_modify lost ignore lost/bond ignore", f"group g id {lost}", "velocity g set 0 0 1000",
        "neigh_modify every 1 delay 0", "run 4 post no", command, "run 1 post no",
    ]  # fmt: skip
    assert not difference("\n".join(lines) + "\n", tmp_path)
