"""Files that fixes extend block by block: each block reaches the file in one write."""

from __future__ import annotations

import contextlib
import os
from typing import TYPE_CHECKING

from pylmp.model.paths import writable
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


class GrowingFile:
    """name: as the script says."""

    def __init__(self, sim: Simulation, args: Args, word: Word, *, append: bool, message: str) -> None:
        """Open the file. message: LAMMPS's sentence when that fails, with places for the name and the system's reason."""
        path = writable(sim, word)
        self.name = word.text
        try:
            self._file = os.open(path, os.O_WRONLY | os.O_CREAT | (os.O_APPEND if append else os.O_TRUNC), 0o666)
        except OSError as error:
            hint = "the folder does not exist" if not path.parent.is_dir() else ""
            args.fail(message.format(word.text, error.strerror), word, hint=hint)
        self._kept = 0

    def write(self, text: str) -> None:
        """Add text."""
        data = text.encode()
        written = 0
        try:
            while written < len(data):
                written += os.write(self._file, data[written:])
        except OSError as error:
            with contextlib.suppress(OSError):  # no part of a block stays
                os.ftruncate(self._file, os.lseek(self._file, 0, os.SEEK_CUR) - written)
            raise ScriptError(f"Error writing file {self.name}: {error.strerror}") from None

    def mark(self) -> None:
        """Keep what is there so far; replace() rewrites what comes after it."""
        self._kept = os.lseek(self._file, 0, os.SEEK_END)

    def replace(self, text: str) -> None:
        """Put text in the place of everything since mark()."""
        os.lseek(self._file, self._kept, os.SEEK_SET)
        self.write(text)
        os.ftruncate(self._file, os.lseek(self._file, 0, os.SEEK_CUR))

    def close(self) -> None:
        if self._file >= 0:
            os.close(self._file)
            self._file = -1

    def __del__(self) -> None:
        if getattr(self, "_file", -1) >= 0:
            os.close(self._file)
