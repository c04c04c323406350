"""Restart files on disk: their names, and writing and reading them whole."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from pylmp.io.restart.content import Content
from pylmp.io.restart.decode import decode
from pylmp.io.restart.encode import encode
from pylmp.io.restart.gather import gather
from pylmp.io.whole_file import write_whole
from pylmp.model.paths import writable
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Word

MANUAL = "read_restart.html"


def write_restart(sim: Simulation, name: Word) -> None:
    """Write the state of sim; % in the name: one file without the atoms (base) and one with them (0), as LAMMPS on one process.

    Raises ScriptError if it cannot be written, Unsupported for what cannot be stored.
    """
    writable(sim, name)
    if sim.atoms.n != sim.natoms and sim.output.thermo.lost == "error":
        raise ScriptError(
            f"Atom count is inconsistent: {sim.atoms.n} vs {sim.natoms}, cannot write restart file", name.span,
            hint="atoms were lost: they are outside the box", manual="write_restart.html",
        )  # fmt: skip
    if sim.script.dry:
        return
    for listed in sim.bond_lists:
        listed.copy_back(sim)
    whole = encode(gather(sim, files=1 if "%" in name.text else 0))
    names = [name.text.replace("%", part, 1) for part in ("base", "0")] if len(whole) > 1 else [name.text]
    for path, data in reversed(list(zip(names, whole, strict=True))):
        writable(sim, replace(name, text=path))
        try:
            write_whole(Path(path), data)
        except OSError as error:
            raise ScriptError(
                f"Cannot open restart file {path}: {error.strerror}", name.span,
                hint="an existing folder that may be written to", manual="write_restart.html",
            ) from None  # fmt: skip


def read_restart(name: str, look: Callable[[str], object] = str) -> Content:
    """The content of a file, or of a set of files where % is base, 0, 1, ...; look refuses what may not be read. Raises ScriptError."""
    base = name.replace("%", "base", 1)
    if base == name:
        return decode(_read(name, look), name)

    def piece(number: int) -> tuple[bytes, str]:
        path = name.replace("%", str(number), 1)
        return _read(path, look), path

    return decode(_read(base, look), base, piece)


def _read(path: str, look: Callable[[str], object]) -> bytes:
    look(path)
    try:
        return Path(path).read_bytes()
    except OSError as error:
        says = f"Cannot open restart file {path}: {error.strerror}"
        raise ScriptError(says, hint="the path is relative to the working directory", manual=MANUAL) from None


def latest(name: str) -> str:
    """The name with * replaced by the largest step of those files that are there."""
    path = Path(name)
    pattern = re.escape(path.name.replace("%", "base", 1)).replace(r"\*", "([0-9]+)", 1)
    try:
        there = [found for each in path.parent.iterdir() if (found := re.fullmatch(pattern, each.name))]
    except OSError as error:
        says = f"Cannot open directory {path.parent} to search for restart file: {error.strerror}"
        raise ScriptError(says, manual=MANUAL) from None
    if not there:
        says = "Found no restart file matching pattern"
        raise ScriptError(says, hint="* stands for a step number", manual=MANUAL)
    largest = max(there, key=lambda found: int(found[1]))
    return name.replace("*", largest[1], 1)
