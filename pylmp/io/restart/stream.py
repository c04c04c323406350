"""Numbers and strings of a binary file, little-endian, as C writes them. Reading never goes beyond the end."""

from __future__ import annotations

import struct
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from pylmp.text.diagnostic import ScriptError

CORRUPT = "Illegal size string or corrupt restart"  # LAMMPS's sentence
MANUAL = "read_restart.html"


class Packer:
    """Values to bytes."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []

    def raw(self, data: bytes) -> None:
        self._parts.append(data)

    def integer(self, value: int) -> None:
        self._parts.append(struct.pack("<i", value))

    def big(self, value: int) -> None:
        self._parts.append(struct.pack("<q", value))

    def number(self, value: float) -> None:
        self._parts.append(struct.pack("<d", value))

    def text(self, value: str) -> None:
        """Its length with the closing zero, then itself."""
        data = value.encode("utf-8", "surrogateescape") + b"\0"
        self.integer(len(data))
        self.raw(data)

    def integers(self, values: list[int]) -> None:
        """Their count, then themselves."""
        self.integer(len(values))
        self.raw(struct.pack(f"<{len(values)}i", *values))

    def numbers(self, values: list[float]) -> None:
        """Their count, then themselves."""
        self.integer(len(values))
        self.raw(struct.pack(f"<{len(values)}d", *values))

    def whole(self) -> bytes:
        return b"".join(self._parts)


class Unpacker:
    """Bytes to values. name: the file, for errors; part: what is being read, in words; at: the next byte."""

    def __init__(self, data: bytes, name: str) -> None:
        self.data = data
        self.name = name
        self.part = "the header"
        self.at = 0

    def fail(self, message: str = CORRUPT, why: str = "") -> NoReturn:
        """Raise ScriptError: LAMMPS's sentence, and where in which file."""
        where = f"{self.name}, byte {self.at}, in {self.part}"
        raise ScriptError(message, hint=f"{where}: {why}" if why else where, manual=MANUAL)

    def raw(self, size: int) -> bytes:
        if size < 0 or size > len(self.data) - self.at:
            left = len(self.data) - self.at
            self.fail(CORRUPT, f"{size} bytes should follow, {left} are left" if size >= 0 else "a negative size")
        self.at += size
        return self.data[self.at - size : self.at]

    def integer(self) -> int:
        return int(struct.unpack("<i", self.raw(4))[0])

    def big(self) -> int:
        return int(struct.unpack("<q", self.raw(8))[0])

    def number(self) -> float:
        return float(struct.unpack("<d", self.raw(8))[0])

    def text(self) -> str:
        size = self.integer()
        data = self.raw(size)
        if not data.endswith(b"\0") or b"\0" in data[:-1]:
            self.fail(CORRUPT, "a string without its end")
        return data[:-1].decode("utf-8", "surrogateescape")

    def integers(self) -> list[int]:
        size = self.integer()
        return [self.integer() for _ in range(self._count(size, 4))]

    def numbers(self) -> list[float]:
        size = self.integer()
        return self.array(self._count(size, 8)).tolist()

    def array(self, count: int) -> NDArray[np.float64]:
        """The next count numbers."""
        return np.frombuffer(self.raw(8 * count), "<f8").copy()

    def _count(self, count: int, size: int) -> int:
        if count < 0 or count * size > len(self.data) - self.at:
            self.fail(CORRUPT, f"a list of {count} numbers")
        return count
