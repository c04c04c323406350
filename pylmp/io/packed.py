"""Text files that may be gzip-compressed: by their suffix when written, by suffix and first bytes when read."""

from __future__ import annotations

import gzip
import zlib
from pathlib import Path

from pylmp.io.whole_file import write_whole

_MAGIC = b"\x1f\x8b"
_CHUNK = 1 << 20
_ALLOWED = 64 << 20  # bytes that any file may unpack to; beyond, so many times its own size:
_RATIO = 100


class Unpackable(Exception):
    """A compressed file that is damaged, or unpacks to far more than such files do."""


def read_packed(path: Path) -> str:
    """The text of a file; one that ends with .gz and begins like one is unpacked. Raises OSError, Unpackable.

    Of a file that was cut off, all that can be unpacked: whoever reads it says where it ends.
    """
    data = path.read_bytes()
    if path.suffix == ".gz" and data.startswith(_MAGIC):
        data = _unpack(data)
    return data.decode("utf-8", "replace")


def _unpack(data: bytes) -> bytes:
    limit = max(_ALLOWED, _RATIO * len(data))
    parts: list[bytes] = []
    size = 0
    while data.startswith(_MAGIC):  # a file may consist of several
        stream = zlib.decompressobj(zlib.MAX_WBITS | 16)
        while data and not stream.eof:
            try:
                parts.append(stream.decompress(data, _CHUNK))
            except zlib.error as error:
                raise Unpackable(f"it is damaged ({error})") from None
            size += len(parts[-1])
            if size > limit:
                raise Unpackable(f"it unpacks to more than {limit} bytes")
            data = stream.unconsumed_tail
        data = stream.unused_data
    return b"".join(parts)


def write_packed(path: Path, text: str) -> None:
    """Write text whole, compressed if the name ends with .gz. Raises OSError."""
    if path.suffix == ".gz":
        write_whole(path, gzip.compress(text.encode(), mtime=0))
    else:
        write_whole(path, text)
