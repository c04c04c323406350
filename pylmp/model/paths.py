"""Where a script may write: below the working directory, unless more is allowed."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


def writable(sim: Simulation, word: Word) -> Path:
    """The path a word names, if a script may write there. Raises ScriptError."""
    path = Path(word.text)
    allowed = sim.script is not None and "write" in sim.script.allow
    if not allowed and not path.resolve().is_relative_to(Path.cwd().resolve()):
        raise ScriptError(
            f"Cannot write {word.text}: it is outside the working directory", word.span,
            hint="--allow write lets scripts write anywhere", code="S101",
        )  # fmt: skip
    return path
