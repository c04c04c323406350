"""Random scripts about boxes, with tilts and without: LAMMPS and pylmp make the same box and the same atoms, to the last bit."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.setup.both import all_agree

SCRIPTS = 25  # a seed


def box(r: random.Random) -> list[str]:
    """From units to the box."""
    letters = [r.choice("ppppfsm") + r.choice(["", "", "f", "s", "m"]) for _ in range(3)]
    letters = [("p" if word[0] == "p" else word.replace("p", "f")) for word in letters]
    flat = r.random() < 0.15
    if flat:
        letters[2] = "p"
    lo = [round(r.uniform(-2, 1), 2) for _ in range(3)]
    hi = [a + round(r.uniform(3, 6), r.choice([0, 1, 3])) for a in lo]
    if flat:
        lo[2], hi[2] = -0.5, 0.5
    sides = " ".join(f"{a!r} {b!r}" for a, b in zip(lo, hi, strict=True))
    tilts = [round(r.uniform(-1.4, 1.4), r.choice([1, 4])) * (not flat or k == 0) for k in range(3)]
    style = f"prism {sides} {' '.join(map(str, tilts))}" if r.random() < 0.6 else f"block {sides}"
    lattice = r.choice(["lattice none 1.1", "lattice fcc 0.9", "lattice bcc 0.8 origin 0.1 0.2 0.1", "lattice sc 1.3 orient x 1 1 0 orient y -1 1 0"])
    if flat:
        lattice = r.choice(["lattice none 1.1", "lattice sq 0.9", "lattice hex 0.7"])
    return [
        "units lj", *(["dimension 2"] if flat else []), f"boundary {' '.join(letters)}", lattice,
        f"region b {style} units {r.choice(['box', 'lattice'])}", "create_box 2 b",
        f"region part prism EDGE 1 0 EDGE EDGE EDGE {'0.3 0 0' if flat else '0.3 -0.2 0.1'} side {r.choice(['in', 'out'])}",
    ]  # fmt: skip


def atoms(r: random.Random) -> list[str]:
    lines = []
    for _ in range(r.randint(1, 3)):
        lines.append(
            r.choice([
                f"create_atoms {r.randint(1, 2)} random {r.randint(1, 20)} {r.randint(1, 9999)} {r.choice(['NULL', 'part'])}",
                f"create_atoms {r.randint(1, 2)} random 20 {r.randint(1, 9999)} NULL overlap 0.7 maxtry 50 units {r.choice(['box', 'lattice'])}",
                f"create_atoms 1 single {r.uniform(-3, 6)!r} {r.uniform(-3, 6)!r} 0.0 remap {r.choice(['yes', 'no'])} units box",
            ])
        )  # fmt: skip
    return lines


def change(r: random.Random) -> str:
    words, volume = [], False
    for _ in range(r.randint(1, 4)):
        axis, tilt = r.choice("xyz"), r.choice(["xy", "xz", "yz"])
        operation = r.choice([
            f"{axis} final {r.uniform(-2, 0)!r} {r.uniform(2, 5)!r}", f"{axis} delta {r.uniform(-0.4, 0.4)!r} {r.uniform(-0.4, 0.4)!r}",
            f"{axis} scale {r.uniform(0.7, 1.4)!r}", f"{tilt} final {r.uniform(-1, 1)!r}", f"{tilt} delta {r.uniform(-1, 1)!r}",
            "remap", "remap", "set", "triclinic", "ortho", f"xy final 0 xz final 0 yz final 0 {r.choice(['ortho', ''])}",
            f"boundary {' '.join(r.choice(['p', 'p', 'f', 's', 'm', 'sm', 'fs']) for _ in range(3))}",
        ])  # fmt: skip
        words.append(operation)
        volume = operation.startswith(("x ", "y ", "z "))
        if volume and r.random() < 0.4:
            others = [d for d in "xyz" if d != axis]
            words += [f"{d} volume" for d in r.sample(others, r.randint(1, 2))]
    return f"change_box {r.choice(['all', 'all', 'some'])} {' '.join(words)} units {r.choice(['box', 'lattice'])}"


def action(r: random.Random) -> str:
    return r.choice([
        change(r), change(r), change(r),
        f"displace_atoms {r.choice(['all', 'some'])} move {r.uniform(-9, 9)!r} {r.uniform(-9, 9)!r} 0.0",
        f"displace_atoms {r.choice(['all', 'some'])} random 0.3 0.3 0 {r.randint(1, 999)}",
        f"displace_atoms all ramp x {r.uniform(-1, 0)!r} {r.uniform(0, 1)!r} y 0.2 3.1",
        f"displace_atoms some rotate 1 2 0 0 0 1 {r.uniform(-90, 90)!r}",
        f"velocity all create 1.5 {r.randint(1, 999)} rot {r.choice(['yes', 'no'])} loop {r.choice(['geom', 'all'])}",
        f"velocity some ramp vy 0 {r.uniform(0, 2)!r} x 0 3",
        f"set group some image {r.choice(['1', 'NULL'])} NULL {r.choice(['-2', 'NULL'])}",
        f"create_atoms 1 single {r.uniform(-1, 4)!r} {r.uniform(-1, 4)!r} 0.0",
        "write_data *.data",
    ])  # fmt: skip


def script(seed: int) -> str:
    r = random.Random(seed)
    lines = [*box(r), *atoms(r), "group some id 1 3 4 6 8:14", "mass * 1.3", *(action(r) for _ in range(r.randint(1, 4)))]
    return "\n".join([*lines, 'print "$(xlo) $(xhi) $(ylo) $(yhi) $(zlo) $(zhi) $(xy) $(xz) $(yz)"']) + "\n"


@pytest.mark.parametrize("seed", range(8))
def test_boxes(seed: int, tmp_path: Path) -> None:
    all_agree(script, range(1000 * seed, 1000 * seed + SCRIPTS), tmp_path)
