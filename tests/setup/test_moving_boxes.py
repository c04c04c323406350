"""Random short runs in boxes that are tilted, follow their atoms, or change: same atoms, same thermo table, to the last bit."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.setup.both import all_agree

SCRIPTS = 12  # a seed


def deform(r: random.Random, tilted: bool, periodic: list[bool]) -> str:
    words, driven = [], []
    for k, axis in enumerate("xyz"):
        if r.random() < 0.4 and periodic[k]:
            driven.append(axis)
            words.append(axis + " " + r.choice([
                f"erate {r.uniform(-0.5, 0.5)!r}", f"trate {r.uniform(-0.5, 0.5)!r}", f"vel {r.uniform(-1, 1)!r}",
                f"scale {r.uniform(0.95, 1.1)!r}", f"delta {r.uniform(-0.1, 0.1)!r} {r.uniform(-0.1, 0.1)!r}",
                f"wiggle {r.uniform(-0.2, 0.2)!r} {r.uniform(0.1, 1)!r}", "variable v_grow v_pace",
            ]))  # fmt: skip
    if driven and r.random() < 0.4:
        words += [f"{axis} volume" for k, axis in enumerate("xyz") if axis not in driven and periodic[k]]
    for tilt in ("xy", "xz", "yz") if tilted else ():
        if r.random() < 0.5:
            words.append(tilt + " " + r.choice([
                f"erate {r.uniform(-3, 3)!r}", f"vel {r.uniform(-9, 9)!r}", f"final {r.uniform(-2, 2)!r}", f"delta {r.uniform(-2, 2)!r}",
                f"wiggle {r.uniform(-1, 1)!r} {r.uniform(0.1, 1)!r}", f"trate {r.uniform(-1, 1)!r}", "variable v_grow v_pace",
            ]))  # fmt: skip
    keywords = f"remap {r.choice(['x', 'x', 'v', 'none'])} flip {r.choice(['yes', 'yes', 'no'])} units {r.choice(['box', 'lattice'])}"
    return f"fix 3 {r.choice(['all', 'all', 'some'])} deform {r.choice([1, 1, 2, 5])} {' '.join(words)} {keywords}"


def script(seed: int) -> str:
    r = random.Random(seed)
    tilted = r.random() < 0.75
    letters = [r.choice(["p", "p", "p", "f", "s", "m", "fs"]) for _ in range(3)]
    lengths = [r.uniform(2.5, 7) for _ in range(3)]
    low = [round(r.uniform(-1, 1), 2) for _ in range(3)]
    sides = " ".join(f"{a!r} {a + length!r}" for a, length in zip(low, lengths, strict=True))
    tilts = " ".join(repr(r.uniform(-1.5, 1.5)) for _ in range(3))
    cutoff = r.choice([1.122462048309373, 1.6, 2.5])
    count = int(0.5 * lengths[0] * lengths[1] * lengths[2])
    lines = [
        "units lj", f"boundary {' '.join(letters)}", f"newton {r.choice(['on', 'off'])}", "lattice none 1.1",
        f"region b {f'prism {sides} {tilts}' if tilted else f'block {sides}'} units box", "create_box 2 b",
        f"create_atoms 1 random {count} {r.randint(1, 9999)} NULL overlap 0.85 maxtry 200 units box",
        "group some id 1 3 4 6 8:14", f"set group all type/fraction 2 0.4 {r.randint(1, 99)}", "mass 1 1.0", "mass 2 1.7",
        f"comm_modify vel {r.choice(['yes', 'no'])} cutoff {r.choice([0.5, 3.0])}",
        f"pair_style lj/cut {cutoff}", "pair_coeff * * 1.0 0.9", f"pair_coeff 1 2 0.8 0.95 {cutoff * 0.9!r}",
        f"neighbor {r.choice([0.1, 0.3, 0.6])} bin",
        f"neigh_modify {r.choice(['every 1 delay 0', 'every 2 delay 4', 'every 5 check no', 'delay 10'])}",
        f"atom_modify sort {r.choice([0, 7, 1000])} {r.choice([0.0, 0.0, 0.4])}",
        f"velocity all create {r.choice([0.5, 2.0, 6.0])} {r.randint(1, 999)}", "variable grow equal 0.03*elapsed*dt",
        "variable pace equal 0.03", "fix 1 all nve", "fix 2 all langevin 1.0 2.0 0.5 771", "thermo 10",
        "thermo_style custom step temp pe press pxx pxy pyz xlo xhi ylo yhi zlo zhi xy xz yz nbuild ndanger",
        "thermo_modify lost warn format float %.17g",
    ]  # fmt: skip
    if r.random() < 0.7:
        lines.append(deform(r, tilted, [letter == "p" for letter in letters]))
    lines += [f"run {r.randint(5, 30)} post no", f"run {r.randint(1, 20)} {r.choice(['pre no ', ''])}post no"]
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("seed", range(8))
def test_runs(seed: int, tmp_path: Path) -> None:
    all_agree(script, range(1000 * seed, 1000 * seed + SCRIPTS), tmp_path)
