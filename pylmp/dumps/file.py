"""Files that dumps grow frame by frame: each frame reaches the file in one write."""

from __future__ import annotations

import contextlib
import gzip
import os
from pathlib import Path
from typing import NoReturn

from pylmp.io.whole_file import write_whole
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args, Word

_ELSEWHERE = (".bin", ".lammpsbin", ".zst", ".bz2", ".xz", ".lz4", ".lzma")


class DumpFile:
    """One file, or one a frame where the name holds ``*`` (the step, padded with zeros to pad digits). ``.gz``: compressed."""

    def __init__(self, args: Args, word: Word) -> None:
        self.name = word.text
        self.split = "%" in self.name  # a file a process: here there is one, with number 0
        self.name = self.name.replace("%", "0", 1)
        if self.name.endswith(_ELSEWHERE):
            raise Unsupported(
                f"LAMMPS writes dump files like {self.name}, pylmp's native engines do not",
                word.span,
                hint="a plain name or .gz",
            )
        self.one_a_frame = "*" in self.name
        self.pad = 0
        self.append = False
        self.most = 0  # files kept, the oldest go; 0: all
        self._kept: list[str] = []
        self._file: int | None = None

    def vanish(self) -> None:
        """From now on nothing is written."""
        self.name = os.devnull

    def open(self) -> None:
        """Make the single file, once. Raises ScriptError when it cannot be."""
        if not self.one_a_frame and self._file is None:
            self._file = self._create(self.name, self.append)

    def write(self, step: int, frame: str) -> None:
        """Add a frame."""
        if self.name == os.devnull:
            return
        data = frame.encode()
        if self.name.endswith(".gz"):
            data = gzip.compress(data)
        if self.one_a_frame:
            path = self.name.replace("*", str(step).zfill(self.pad))
            try:
                write_whole(Path(path), data, sync=False)
            except OSError as error:
                self._cannot(path, error)
            self._forget(path)
        else:
            self.open()
            self._write(data)

    def _forget(self, path: str) -> None:
        """Remove the oldest file if there are too many."""
        if not self.most:
            return
        self._kept.append(path)
        if len(self._kept) > self.most:
            Path(self._kept.pop(0)).unlink(missing_ok=True)

    def _write(self, data: bytes) -> None:
        assert self._file is not None
        written = 0
        try:
            while written < len(data):
                written += os.write(self._file, data[written:])
        except OSError as error:
            with contextlib.suppress(OSError):  # no part of a frame stays
                os.ftruncate(self._file, os.lseek(self._file, 0, os.SEEK_CUR) - written)
            raise ScriptError(f"Error writing dump {self.name}: {error.strerror}") from None

    def close(self) -> None:
        if self._file is not None:
            os.close(self._file)
            self._file = None

    @staticmethod
    def _create(path: str, append: bool) -> int:
        try:
            return os.open(path, os.O_WRONLY | os.O_CREAT | (os.O_APPEND if append else os.O_TRUNC), 0o666)
        except OSError as error:
            DumpFile._cannot(path, error)

    @staticmethod
    def _cannot(path: str, error: OSError) -> NoReturn:
        hint = "the folder does not exist" if not Path(path).parent.is_dir() else ""
        raise ScriptError(f"Cannot open dump file {path}:{error.strerror}", hint=hint, manual="dump.html") from None
