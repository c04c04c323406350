"""Run a script with its data files on LAMMPS and on pylmp; compare arrays, log lines, error sentences and written files."""

from __future__ import annotations

import random
from pathlib import Path

import numpy as np

from pylmp.text.diagnostic import Diagnostic
from tests.garbled import refusal
from tests.setup.both import Made, on_lammps, on_pylmp, second_opinion


def run_both(script: str, folder: Path, files: dict[str, str]) -> tuple[Made, Made]:
    """Each program in a folder of its own (folder/reference, folder/ours)."""
    return on_lammps(script, _home(folder / "reference", files)), on_pylmp(script, _home(folder / "ours", files))


def _home(folder: Path, files: dict[str, str]) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / name).write_text(text)
    return folder


def difference(script: str, folder: Path, files: dict[str, str] | None = None, written: tuple[str, ...] = ()) -> str:
    """Empty if both agree in every bit, line and sentence; written: files to compare as text."""
    home = _home(folder / "reference", files or {})
    ours = on_pylmp(script, _home(folder / "ours", files or {}))

    def wrong(reference: Made) -> list[str]:
        found = []
        if reference.error != ours.error:
            found.append(f"LAMMPS: {reference.error or 'no error'}\n pylmp: {ours.error or 'no error'}")
        found += _lines("log", _said(reference), _said(ours))
        if not reference.error:
            for name, values in reference.arrays.items():
                other = ours.arrays.get(name, np.zeros(0))
                if values.shape != other.shape or not np.array_equal(values, other):
                    found.append(f"{name}:\n{values}\n{other}")
            for name in written:
                found += _lines(name, *((folder / at / name).read_text().split("\n") for at in ("reference", "ours")))
        return found

    return "\n".join(second_opinion(script, home, wrong))


def refused(script: str, text: str, folder: Path) -> Diagnostic | None:
    """What pylmp has against a data file, wrong.data, that script reads."""
    (folder / "wrong.data").write_bytes(text.encode("utf-8", "surrogateescape"))
    return refusal(script, folder)


def _said(made: Made) -> list[str]:
    """The log without empty lines (the library does not echo them) and pylmp's note about compiling."""
    return [line.rstrip() for line in made.log if line and not line.startswith("Compiling")]


def _lines(what: str, reference: list[str], ours: list[str]) -> list[str]:
    if reference == ours:
        return []
    pairs = [(a, b) for a, b in zip(reference, ours, strict=False) if a != b]
    return [f"{what}: {pairs[:3]} ({len(reference)}, {len(ours)} lines)"]


SIZES = {"bond": 2, "angle": 3, "dihedral": 4, "improper": 4}
STORED = {
    "atomic": (), "charge": (), "bond": ("bond",), "angle": ("bond", "angle"), "molecular": tuple(SIZES), "full": tuple(SIZES),
}  # fmt: skip


class Network:
    """A random network of bonds, angles, ... in a random box, as a data file: seeded, so that a failure can be repeated.

    labeled: types have labels, which stand in rows here and there.
    """

    def __init__(self, seed: int, style: str, dimension: int, boundary: str, labeled: bool = False) -> None:
        self.random = random.Random(seed)
        draw = self.random
        self.style, self.dimension, self.boundary = style, dimension, boundary
        self.count = draw.randint(5, 40)
        self.lo = [draw.uniform(-3.0, 0.0) for _ in range(3)]
        self.hi = [low + draw.uniform(4.0, 9.0) for low in self.lo]
        if dimension == 2:
            self.lo[2], self.hi[2] = -0.5, 0.5
        self.tags = draw.sample(range(1, 3 * self.count), self.count)
        self.bonded = bool(STORED[style])
        self.labeled = labeled

    def coordinate(self, d: int) -> float:
        """Inside the box, or, where it is periodic, up to two lengths outside; sometimes on a face."""
        low, high = self.lo[d], self.hi[d]
        if d == 2 and self.dimension == 2:
            return 0.0
        if self.boundary[d] == "p":
            return self.random.choice([self.random.uniform(2 * low - high, 2 * high - low), low, high])
        return self.random.uniform(low, high)

    def type(self, kind: str, count: int) -> str:
        number = self.random.randint(1, count)
        return f"{kind}-{number}" if self.labeled and self.random.random() < 0.5 else str(number)

    def atom(self, tag: int, images: bool) -> str:
        draw = self.random
        words = [str(tag), str(draw.randint(0, 5)), self.type("atom", 3)] if self.bonded else [str(tag), self.type("atom", 3)]
        if self.style in ("charge", "full"):
            words.append(draw.choice(["0", f"{draw.gauss(0, 1):.12g}", "-1e-3", "+.5"]))
        words += [repr(self.coordinate(d)) for d in range(3)]
        if images:
            words += [str(draw.randint(-3, 3)) if d < self.dimension else "0" for d in range(3)]
        return draw.choice([" ", "  ", "\t"]).join(words) + draw.choice(["", "", " # note"])

    def rows(self, kind: str) -> list[str]:
        wanted = self.random.randint(1, 2 * self.count)
        size = SIZES[kind]
        return [
            " ".join([str(n), self.type(kind, 2), *map(str, self.random.sample(self.tags, size))]) for n in range(1, wanted + 1)
        ]

    def text(self) -> str:
        """The sections in a random order that read_data allows."""
        draw = self.random
        images = draw.random() < 0.5
        counts = [f"{self.count} atoms", "3 atom types"]
        after = []
        for kind in STORED[self.style]:
            rows = self.rows(kind) if draw.random() < 0.8 else []
            counts += [f"{len(rows)} {kind}s", f"2 {kind} types"]
            counts += draw.choice([[], [], [f"2 extra {kind} per atom"]])
            if rows:
                after.append((f"{kind.capitalize()}s", rows))
        if self.bonded:
            counts += draw.choice([[], ["3 extra special per atom"]])
        faces = [f"{self.lo[d]!r} {self.hi[d]!r} {axis}lo {axis}hi" for d, axis in enumerate("xyz")]
        draw.shuffle(counts)
        draw.shuffle(faces)
        masses = [("Masses", [f"{self.labeled * 'atom-'}{k} {draw.uniform(0.5, 3.0):.9g}" for k in (1, 2, 3)])]
        atoms = [("Atoms", [self.atom(tag, images) for tag in self.tags])]
        if draw.random() < 0.7:
            shuffled = draw.sample(self.tags, self.count)
            after.append(("Velocities", [f"{t} {draw.gauss(0, 1)!r} {draw.gauss(0, 1):.5f} 0" for t in shuffled]))
        draw.shuffle(after)
        sections = [*masses, *atoms, *after] if draw.random() < 0.5 else [*atoms, *after, *masses]
        body = [line for name, rows in [*self.labels(), *sections] for line in ("", name, "", *rows)]
        return "\n".join(["a random network", "", *counts, *faces, *body]) + "\n"

    def labels(self) -> list[tuple[str, list[str]]]:
        """The sections of type labels, in a random order, their rows too."""
        sections = []
        for kind in ("atom", *STORED[self.style]) if self.labeled else ():
            rows = [f"{k} {kind}-{k}" for k in range(1, 4 if kind == "atom" else 3)]
            sections.append((f"{kind.capitalize()} Type Labels", self.random.sample(rows, len(rows))))
        return self.random.sample(sections, len(sections))
