"""Files that are either complete or not there."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path


def write_whole(path: Path, content: str | bytes, sync: bool = True) -> None:
    """Write content under a temporary name in the same folder, then give it its name. Raises OSError.

    Whoever reads path sees the old file or the new one, also after a crash. An existing file keeps its permissions;
    without sync the system chooses when the bytes reach the disk; what is no ordinary file (/dev/stdout, a pipe) is written to directly.
    """
    path = Path(path)
    if path.exists() and not path.is_file():
        path.write_bytes(_bytes(content))
        return
    path = path.resolve()
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(_bytes(content))
            stream.flush()
            if sync:
                os.fsync(stream.fileno())
        os.chmod(name, path.stat().st_mode & 0o7777 if path.exists() else 0o666 & ~_umask())
        os.replace(name, path)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


def _bytes(content: str | bytes) -> bytes:
    return content.encode("utf-8") if isinstance(content, str) else content


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
