"""delete_bonds, create_bonds, special_bonds, force styles of angles, dihedrals, impropers: random scripts against LAMMPS."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.topology.support import SIZES, STORED, Network, difference

STYLES = "bond", "angle", "molecular", "full"


class Commands:
    """Random commands for a network: seeded, so that a failure can be repeated."""

    def __init__(self, seed: int, network: Network) -> None:
        self.random = random.Random(seed)
        self.network = network
        self.kinds = STORED[network.style]

    def line(self) -> str:
        kinds = [self.delete, self.delete, self.create, self.create, self.special, self.coefficients, self.group]
        return self.random.choice(kinds)()

    def delete(self) -> str:
        draw = self.random
        style = draw.choice(["multi", "atom", "stats", *self.kinds])
        words = ["delete_bonds", draw.choice(["all", "some", "all"]), style]
        if style not in ("multi", "stats"):
            words.append(draw.choice(["1", "2", "1*2", "2*"]))
        words += draw.sample(["any", "undo", "remove", "special"], draw.choice([0, 1, 2]))
        return " ".join(words)

    def create(self) -> str:
        draw = self.random
        kind = draw.choice(self.kinds)
        tags = draw.sample(self.network.tags, SIZES[kind])
        return f"create_bonds single/{kind} {draw.randint(1, 2)} {' '.join(map(str, tags))}" + draw.choice(["", " special no"])

    def special(self) -> str:
        draw = self.random
        words = ["special_bonds", draw.choice(["lj/coul 0 0 0", "lj/coul 0 0.5 1", "fene", "charmm", "lj 0 1 1 coul 0 0 1"])]
        words += [f"{key} {draw.choice(['yes', 'no'])}" for key in draw.sample(["angle", "dihedral"], draw.randint(0, 2))]
        return " ".join(words)

    def coefficients(self) -> str:
        draw = self.random
        kind = draw.choice(self.kinds)
        value = f" {draw.randint(1, 180)}" if kind in ("bond", "angle") and draw.random() < 0.5 else ""
        return f"{kind}_coeff {draw.choice(['1', '2', '*'])}{value}"

    def group(self) -> str:
        tags = self.random.sample(self.network.tags, min(12, self.network.count))
        return f"group some id {' '.join(map(str, tags))}"


@pytest.mark.parametrize("seed", range(80))
def test_random_commands(seed: int, tmp_path: Path) -> None:
    network = Network(seed, STYLES[seed % 4], 3, "ppp")
    commands = Commands(seed, network)
    styled = [kind for kind in commands.kinds if seed % 3]
    lines = [
        "units lj", f"atom_style {network.style}", f"newton on {'off' if seed // 4 % 2 else 'on'}",
        f"special_bonds lj/coul 0 0.5 0.5 angle {'yes' if seed % 5 < 2 else 'no'} dihedral {'yes' if seed % 7 < 3 else 'no'}",
        "pair_style zero 1.0", *(f"{kind}_style zero" for kind in commands.kinds),
        "read_data in.data " + " ".join(f"extra/{kind}/per/atom 20" for kind in commands.kinds) + " extra/special/per/atom 40",
        "pair_coeff * *", *(f"{kind}_coeff * 1" if kind == "angle" else f"{kind}_coeff *" for kind in commands.kinds),
        "group some id 1", *(f"{kind}_style none" for kind in commands.kinds if kind not in styled),
    ]  # fmt: skip
    if not styled:
        commands.coefficients = commands.create  # type: ignore[method-assign]
    lines += [commands.line() for _ in range(12)]
    lines += ["thermo_style custom step bonds angles dihedrals impropers", "run 0", "delete_bonds all stats", "write_data out.data"]
    assert not difference("\n".join(lines) + "\n", tmp_path, {"in.data": network.text()}, ("out.data",))
