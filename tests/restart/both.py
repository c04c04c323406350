"""Run a script on LAMMPS and on pylmp in folders of their own, and say in words where their restart files differ."""

from __future__ import annotations

import difflib
import re
from pathlib import Path
from typing import Any

import numpy as np

from pylmp.io.restart.content import Content
from pylmp.io.restart.decode import decode
from tests.setup.both import Made, on_pylmp, second_opinion


class Pair:
    """lammps, pylmp: folders of the two programs."""

    def __init__(self, folder: Path) -> None:
        self.lammps, self.pylmp = folder / "lammps", folder / "pylmp"
        self.lammps.mkdir()
        self.pylmp.mkdir()

    def run(self, script: str, *files: str) -> None:
        """Both programs run script; they end alike, their logs are equal, and so are the restart files named."""
        ours = on_pylmp(script, self.pylmp)

        def wrong(reference: Made) -> list[str]:
            if reference.error or ours.error:
                return [f"{reference.error!r} {ours.error!r}"]
            found = list(difflib.unified_diff(words(reference), words(ours), "LAMMPS", "pylmp", lineterm="", n=0))
            return found + [f"{name}: {text}" for name in files for text in differences(*self.files(name))]

        found = second_opinion(script, self.lammps, wrong)
        assert not found, "\n".join(found)

    def files(self, name: str) -> tuple[bytes, bytes]:
        return (self.lammps / name).read_bytes(), (self.pylmp / name).read_bytes()


def words(made: Made) -> list[str]:
    """The log without what cannot be equal: memory, seconds."""
    left = (line for line in made.log if not line.startswith(("Per MPI rank", "Loop time", "For more information", "  using 1 OpenMP")))
    return [re.sub(r"\s+$", "", line) for line in left if line.strip()]


def differences(reference: bytes, ours: bytes) -> list[str]:
    """Empty if the files are equal, byte by byte."""
    if reference == ours:
        return []
    first, second = decode(reference, "LAMMPS's"), decode(ours, "pylmp's")
    found = [f"{k}: {first.header[k]} {second.header[k]}" for k in first.header if first.header[k] != second.header[k]]
    for name in ("groups", "mass", "labels", "forces", "fixes"):
        a, b = getattr(first, name), getattr(second, name)
        if a != b:
            found.append(f"{name}: {a} {b}")
    found += [text for name in first.atoms if (text := _array(name, first.atoms[name], second.atoms[name]))]
    return [*found, *_kept(first, second)] or ["the bytes"]


def _array(name: str, a: Any, b: Any) -> str:
    if a.shape != b.shape:
        return f"{name}: shapes {a.shape} {b.shape}"
    at = np.argwhere(a != b)
    return f"{name}: {len(at)} of {a.size}, first {at[0]} {a[tuple(at[0])]!r} {b[tuple(at[0])]!r}" if len(at) else ""


def _kept(a: Content, b: Content) -> list[str]:
    names = [[(kept.identity, kept.style, kept.width) for kept in content.kept] for content in (a, b)]
    if names[0] != names[1]:
        return [f"kept: {names}"]
    pairs = zip(a.kept, b.kept, strict=True)
    return [text for one, other in pairs if (text := _array(f"kept {one.identity}", one.values, other.values))]
