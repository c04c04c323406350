"""Where a script may read and write, unless more is allowed. docs/safety.md says it in words.

A script reads below the working directory and below its own folder, and writes below the working directory, but no hidden file
there (a script that runs in somebody's home must not write .profile). Links are followed before anything is compared.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

PERMISSIONS = ("shell", "read", "write", "env")  # what --allow takes
_NOTHING = Path("/dev/null")
_NOWHERE = ("/dev/null", "/dev/stdout", "/dev/stderr")  # what is written there changes no file


def writable(sim: Simulation, word: Word) -> Path:
    """The path a word names, if a script may write there; of a script that is only looked at, one where nothing stays. Raises ScriptError."""
    path = Path(word.text)
    if word.text in _NOWHERE or "write" in sim.script.allow:
        return _nothing(sim, path) if sim.script.dry else path
    home: Path = sim.script.folders[0]
    place = _resolved(path, word)
    if not place.is_relative_to(home):
        raise ScriptError(
            f"Cannot write {word.text}: it is outside the working directory", word.span,
            hint="--allow write lets scripts write anywhere", code="S101",
        )  # fmt: skip
    if any(part.startswith(".") for part in place.relative_to(home).parts):
        raise ScriptError(
            f"Cannot write {word.text}: its name is a hidden one", word.span,
            hint="a name without a dot in front; --allow write lets scripts write anywhere", code="S101",
        )  # fmt: skip
    return _nothing(sim, path) if sim.script.dry else path


def _nothing(sim: Simulation, path: Path) -> Path:
    """Where nothing stays; the path itself if it cannot be written: opening it then fails as it would in a run."""
    sim.script.writes.append(str(path))
    folder = path.parent
    possible = folder.is_dir() and os.access(folder, os.W_OK | os.X_OK) and not path.is_dir() and (not path.exists() or os.access(path, os.W_OK))
    return _NOTHING if possible else path


def readable(sim: Simulation, word: Word) -> Path:
    """The path a word names, if a script may read there. Raises ScriptError."""
    path = Path(word.text)
    if sim.script is None or "read" in sim.script.allow or word.text == "/dev/null":
        return path
    folders: Sequence[Path] = sim.script.folders
    place = _resolved(path, word)
    if not any(place.is_relative_to(folder) for folder in folders):
        raise ScriptError(
            f"Cannot read {word.text}: it is outside the working directory and the script's folder", word.span,
            hint="--allow read lets scripts read anywhere", code="S107",
        )  # fmt: skip
    return path


def _resolved(path: Path, word: Word) -> Path:
    try:
        return path.resolve()
    except (OSError, ValueError, RuntimeError) as error:  # a circle of links, a NUL
        raise ScriptError(f"Cannot find out where {word.text!r} is: {error}", word.span) from None
