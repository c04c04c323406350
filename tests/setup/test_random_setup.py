"""Random set-up scripts: lattices, boxes, regions, atoms, groups, and what changes atoms, on LAMMPS and on pylmp; every bit and word equal."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.setup.both import difference

ORIENTS = (
    "", "orient x 1 1 0 orient y -1 1 0", "orient x 1 -1 0 orient y 1 1 -2 orient z 1 1 1", "orient x 0 1 0 orient y 0 0 1 orient z 1 0 0",
)  # fmt: skip
FLAT_ORIENTS = ("", "orient x 1 1 0 orient y -1 1 0", "orient x 0 1 0 orient y -1 0 0")


class Writer:
    """Writes one script. Numbers have few digits, so that sites fall on faces and atoms on surfaces now and then."""

    def __init__(self, seed: int) -> None:
        self.draw = random.Random(seed)
        self.flat = self.draw.random() < 0.25
        self.bonded = self.draw.random() < 0.3
        self.regions = ["cell"]
        self.groups = ["all"]
        self.names = 0

    def n(self, low: float, high: float) -> str:
        return f"{round(self.draw.uniform(low, high), self.draw.choice([0, 1, 3])):g}"

    def seed(self) -> int:
        return self.draw.randint(1, 99999)

    def name(self) -> str:
        self.names += 1
        return f"n{self.names}"

    def lattice(self) -> str:
        draw = self.draw
        style = draw.choice(["sq", "sq2", "hex"] if self.flat else ["sc", "bcc", "fcc", "hcp", "diamond", "custom"])
        words = ["lattice", style, f"{draw.uniform(0.6, 1.1):.3g}"]
        if style == "custom":
            words += [
                "a1 1 0 0 a2",
                draw.choice(["0", "0.4"]),
                "1.2 0 a3 0 0 0.8 basis 0 0 0",
                draw.choice(["", "basis 0.5 0.25 0.5"]),
            ]
        words.append(draw.choice(FLAT_ORIENTS if self.flat else ORIENTS))
        if draw.random() < 0.4:
            words.append(f"origin {self.n(0, 0.4)} {self.n(0, 0.4)} {0 if self.flat else self.n(0, 0.4)}")
        if draw.random() < 0.2:
            words.append("spacing 0.8 1 1.3")
        return " ".join(words)

    def box(self) -> list[str]:
        draw = self.draw
        faces = [f"{self.n(-1, 0)} {self.n(2.5, 4)}" for _ in range(2)] + [
            "-0.3 0.3" if self.flat else f"{self.n(-1, 0)} {self.n(2, 4)}"
        ]
        style, tilts = "block", ""
        if draw.random() < 0.3:
            style, tilts = (
                "prism",
                f" {self.n(-0.9, 0.9)} 0 0"
                if self.flat
                else f" {self.n(-0.9, 0.9)} {self.n(-0.5, 0.5)} {self.n(-0.5, 0.5)}",
            )
        more = "bond/types 1 extra/bond/per/atom 30 extra/special/per/atom 60" if self.bonded else ""
        return [f"region cell {style} {' '.join(faces)}{tilts}", f"create_box 3 cell {more}"]

    def region(self) -> str:
        draw = self.draw
        c, r = [self.n(0, 4) for _ in range(2)] + ["0" if self.flat else self.n(0, 3)], self.n(1, 2.5)
        axis, low, high = draw.choice("xyz"), draw.choice(["INF", "EDGE", "-0.5"]), draw.choice(["INF", "EDGE", "3"])
        style = draw.choice(["block", "sphere", "cylinder", "cone", "plane", "ellipsoid", "union", "intersect"])
        if style in ("union", "intersect"):
            some = [draw.choice(self.regions) for _ in range(draw.randint(2, 3))]
            words = f"{len(some)} {' '.join(some)}"
        else:
            words = {
                "block": f"{low} {high} {self.n(0, 1)} {self.n(1, 4)} {low} {high}",
                "sphere": f"{' '.join(c)} {r}",
                "cylinder": f"{axis} {c[0]} {c[1]} {r} {low} {high}",
                "cone": f"{axis} {c[0]} {c[1]} {r} {self.n(0, 1)} -0.5 3",
                "plane": f"{' '.join(c)} {self.n(-1, 1)} {self.n(-1, 1)} 0.7",
                "ellipsoid": f"{' '.join(c)} {r} {self.n(1, 2)} 1.5",
            }[style]
        name = self.name()
        keywords = draw.choice(["", "", " side out", " units box", " side in units lattice"])
        line = f"region {name} {style} {words}{keywords if style not in ('union', 'intersect') else keywords.replace(' units box', '')}"
        self.regions.append(name)
        return line

    def create(self) -> str:
        draw = self.draw
        kind, region = draw.randint(1, 3), draw.choice(self.regions)
        style = draw.choice(["box", "region", "region", "single", "random"])
        if style == "single":
            z = "0" if self.flat else self.n(-1, 4)
            return f"create_atoms {kind} single {self.n(-1, 5)} {self.n(-1, 5)} {z} {draw.choice(['', 'remap yes', 'units box'])}"
        if style == "random":
            overlap = draw.choice(["", f"overlap {draw.uniform(0.1, 0.5):.2g} maxtry 20"])
            return f"create_atoms {kind} random {draw.randint(1, 40)} {self.seed()} {draw.choice([region, 'NULL'])} {overlap}"
        words = draw.choice(
            ["", "", "basis 1 2", f"ratio {draw.uniform(0.1, 0.9):.2g} {self.seed()}", f"subset 1 {self.seed()}"]
        )
        return f"create_atoms {kind} {style} {region if style == 'region' else ''} {words}"

    def group(self) -> str:
        draw, name = self.draw, self.name()
        other, third = draw.choice(self.groups), draw.choice(self.groups)
        words = draw.choice([
            f"type {draw.randint(1, 3)}", f"id {draw.choice(['<', '>=', '!='])} {draw.randint(1, 40)}", "id 1:60:7 3 9",
            f"region {draw.choice(self.regions)}", f"union {other} {third}", f"subtract {other} {third}", f"intersect {other} {third}",
        ])  # fmt: skip
        self.groups.append(name)
        return f"group {name} {words}"

    def set(self) -> str:
        draw = self.draw
        who = draw.choice(
            [f"group {draw.choice(self.groups)}", f"region {draw.choice(self.regions)}", "type 1*2", "atom 3*20"]
        )
        what = draw.choice([
            f"type {draw.randint(1, 3)}", f"type/fraction 2 {draw.random():.2g} {self.seed()}",
            f"type/ratio 3 {draw.random():.2g} {self.seed()}", f"vx {self.n(-1, 1)} vy 0.3", "image NULL NULL 0",
        ])  # fmt: skip
        return f"set {who} {what}"

    def displace(self) -> str:
        draw, z = self.draw, "0" if self.flat else self.n(-2, 2)
        axes = "xy" if self.flat else "xyz"
        turn = "0 0 1" if self.flat else f"{self.n(-1, 1)} 0.4 {self.n(-1, 1)}"
        words = draw.choice([
            f"move {self.n(-3, 3)} {self.n(-3, 3)} {z}", f"random 0.1 0.2 {0 if self.flat else 0.1} {self.seed()}",
            f"ramp {draw.choice(axes)} -0.2 {self.n(0, 1)} {draw.choice(axes)} 0 {self.n(1, 4)}",
            f"rotate {self.n(0, 2)} {self.n(0, 2)} 0 {turn} {self.n(-180, 180)}",
        ])  # fmt: skip
        return f"displace_atoms {draw.choice(self.groups)} {words} {draw.choice(['', 'units box'])}"

    def velocity(self) -> str:
        draw = self.draw
        options = " ".join(
            f"{key} {draw.choice(['yes', 'no'])}" for key in ("mom", "rot", "sum") if draw.random() < 0.4
        )
        loop = draw.choice(["all", "local", "geom"])
        words = draw.choice([
            f"create {draw.uniform(0.5, 2):.3g} {self.seed()} loop {loop} dist {draw.choice(['uniform', 'gaussian'])} {options}",
            f"set {self.n(-1, 1)} NULL {0 if self.flat else self.n(-1, 1)} sum yes", f"scale {draw.uniform(0.5, 2):.3g}",
            "zero linear", "zero angular", f"ramp v{draw.choice('xy')} -0.3 {self.n(0, 1)} {draw.choice('xy')} 0 {self.n(1, 4)}",
        ])  # fmt: skip
        return f"velocity {draw.choice(self.groups)} {words}"

    def delete(self) -> str:
        draw = self.draw
        group, region = draw.choice(self.groups[1:] or ["none"]), draw.choice(self.regions[1:] or ["cell"])
        words = draw.choice([
            f"group {group}", f"region {region}", f"random fraction {draw.uniform(0, 0.5):.2g} {draw.choice(['yes', 'no'])} all NULL {self.seed()}",
            f"random count {draw.randint(0, 9)} no {group} {draw.choice([region, 'NULL'])} {self.seed()}",
            f"overlap {draw.uniform(0.3, 1):.2g} all {group}",
        ])  # fmt: skip
        return f"delete_atoms {words} {draw.choice(['', 'compress no'])} {'bond yes' if self.bonded else ''}"

    def larger(self) -> str:
        copies = [self.draw.choice([1, 1, 2]) for _ in range(2)] + [1 if self.flat else self.draw.choice([1, 1, 2])]
        return f"replicate {' '.join(map(str, copies))} {self.draw.choice(['', 'bbox', 'bond/periodic'])}"

    def number(self) -> str:
        words = ["id", "id sort yes"]
        if self.bonded:
            words += ["mol all", f"mol {self.draw.choice(self.groups)} single yes offset 3", "image all"]
        return f"reset_atoms {self.draw.choice(words)}"

    def script(self) -> str:
        draw = self.draw
        boundary = [draw.choice(["p", "p", "p", "f", "s", "fs"]) for _ in range(2)] + [
            "p" if self.flat else draw.choice("ppfsm")
        ]
        lines = [
            "units lj", f"dimension {2 if self.flat else 3}", f"boundary {' '.join(boundary)}", f"atom_style {'bond' if self.bonded else 'atomic'}",
            self.lattice(), *self.box(), self.region(), "create_atoms 1 box", draw.choice(["create_atoms 2 single 1 1 0", self.create()]),
            "group none empty", "mass 1 1.0", "mass 2 1.7", "mass 3 0.3", "pair_style zero 1.5", "pair_coeff * *",
        ]  # fmt: skip
        if self.bonded:
            lines.append("create_bonds many all all 1 0.3 1.1")
        steps = (
            self.lattice, self.region, self.region, self.create, self.group, self.group, self.set, self.set, self.displace, self.velocity,
            self.velocity, self.delete, self.larger, self.number,
        )  # fmt: skip
        lines += [draw.choice(steps)() for _ in range(draw.randint(4, 14))]
        return "\n".join(" ".join(line.split()) for line in lines) + "\n"


@pytest.mark.parametrize("seed", range(150))
def test_random_script(seed: int, tmp_path: Path) -> None:
    """An error must come from the same line with the same sentence."""
    script = Writer(seed).script()
    assert not difference(script, tmp_path), script
