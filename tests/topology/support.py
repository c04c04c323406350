"""Run a script with its data files on LAMMPS and on pylmp; compare arrays, log lines, error sentences and written files."""

from __future__ import annotations

import os
import random
from pathlib import Path

import numpy as np

from tests.setup.both import Made, library, on_lammps, on_pylmp


def run_both(script: str, folder: Path, files: dict[str, str]) -> tuple[Made, Made]:
    """Each program in a folder of its own (folder/reference, folder/ours)."""
    made = []
    library().command("thermo_modify warn reset")  # it falls silent after 100 warnings
    for name, program in (("reference", on_lammps), ("ours", on_pylmp)):
        home = folder / name
        home.mkdir(parents=True, exist_ok=True)
        for file, text in files.items():
            (home / file).write_text(text)
        before = Path.cwd()
        os.chdir(home)
        try:
            made.append(program(script, home))
        finally:
            os.chdir(before)
    return made[0], made[1]


def difference(script: str, folder: Path, files: dict[str, str] | None = None, written: tuple[str, ...] = ()) -> str:
    """Empty if both agree in every bit, line and sentence; written: files to compare as text."""
    reference, ours = run_both(script, folder, files or {})
    wrong = []
    if reference.error != ours.error:
        wrong.append(f"LAMMPS: {reference.error or 'no error'}\n pylmp: {ours.error or 'no error'}")
    wrong += _lines("log", _said(reference), _said(ours))
    if not reference.error:
        for name, values in reference.arrays.items():
            other = ours.arrays.get(name, np.zeros(0))
            if values.shape != other.shape or not np.array_equal(values, other):
                wrong.append(f"{name}:\n{values}\n{other}")
        for name in written:
            texts = [(folder / home / name).read_text().split("\n") for home in ("reference", "ours")]
            wrong += _lines(name, *texts)
    return "\n".join(wrong)


def _said(made: Made) -> list[str]:
    """The log without empty lines (the library does not echo them) and pylmp's note about compiling."""
    return [line.rstrip() for line in made.log if line and not line.startswith("Compiling")]


def _lines(what: str, reference: list[str], ours: list[str]) -> list[str]:
    if reference == ours:
        return []
    pairs = [(a, b) for a, b in zip(reference, ours, strict=False) if a != b]
    return [f"{what}: {pairs[:3]} ({len(reference)}, {len(ours)} lines)"]


class Network:
    """A random network of bonds in a random box, as a data file: seeded, so that a failure can be repeated."""

    def __init__(self, seed: int, style: str, dimension: int, boundary: str) -> None:
        self.random = random.Random(seed)
        draw = self.random
        self.style, self.dimension, self.boundary = style, dimension, boundary
        self.count = draw.randint(3, 40)
        self.lo = [draw.uniform(-3.0, 0.0) for _ in range(3)]
        self.hi = [low + draw.uniform(4.0, 9.0) for low in self.lo]
        if dimension == 2:
            self.lo[2], self.hi[2] = -0.5, 0.5
        self.tags = draw.sample(range(1, 3 * self.count), self.count)
        self.bonded = style != "atomic"

    def coordinate(self, d: int) -> float:
        """Inside the box, or, where it is periodic, up to two lengths outside; sometimes on a face."""
        low, high = self.lo[d], self.hi[d]
        if d == 2 and self.dimension == 2:
            return 0.0
        if self.boundary[d] == "p":
            return self.random.choice([self.random.uniform(2 * low - high, 2 * high - low), low, high])
        return self.random.uniform(low, high)

    def atom(self, tag: int, images: bool) -> str:
        draw = self.random
        numbers = [tag, draw.randint(0, 5), draw.randint(1, 3)] if self.bonded else [tag, draw.randint(1, 3)]
        words = [*map(str, numbers), *(repr(self.coordinate(d)) for d in range(3))]
        if images:
            words += [str(draw.randint(-3, 3)) if d < self.dimension else "0" for d in range(3)]
        return draw.choice([" ", "  ", "\t"]).join(words) + draw.choice(["", "", " # note"])

    def bonds(self) -> list[str]:
        wanted = self.random.randint(1, 2 * self.count)
        pairs = [self.random.sample(self.tags, 2) for _ in range(wanted)]
        return [f"{n} {self.random.randint(1, 2)} {a} {b}" for n, (a, b) in enumerate(pairs, 1)]

    def text(self) -> str:
        """The sections in a random order that read_data allows."""
        draw = self.random
        images = draw.random() < 0.5
        bonds = self.bonds() if self.bonded and draw.random() < 0.8 else []
        counts = [f"{self.count} atoms", "3 atom types"]
        if self.bonded:
            counts += [f"{len(bonds)} bonds", "2 bond types"]
            counts += draw.choice([[], ["2 extra bond per atom"], ["3 extra special per atom"]])
        faces = [f"{self.lo[d]!r} {self.hi[d]!r} {axis}lo {axis}hi" for d, axis in enumerate("xyz")]
        draw.shuffle(counts)
        draw.shuffle(faces)
        first = [("Masses", [f"{k} {draw.uniform(0.5, 3.0):.9g}" for k in (1, 2, 3)])]
        atoms = [("Atoms", [self.atom(tag, images) for tag in self.tags])]
        after = []
        if draw.random() < 0.7:
            shuffled = draw.sample(self.tags, self.count)
            after.append(("Velocities", [f"{t} {draw.gauss(0, 1)!r} {draw.gauss(0, 1):.5f} 0" for t in shuffled]))
        if bonds:
            after.append(("Bonds", bonds))
        draw.shuffle(after)
        sections = [*first, *atoms, *after] if draw.random() < 0.5 else [*atoms, *after, *first]
        body = [line for name, rows in sections for line in ("", name, "", *rows)]
        return "\n".join(["a random network", "", *counts, *faces, *body]) + "\n"
