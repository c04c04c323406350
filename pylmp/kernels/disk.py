"""The folder of machine code: one file a kernel, written whole or not at all, trusted only when it is ours and unharmed.

Nothing here raises for what a disk may do: an entry that cannot be read or kept costs a compilation, never the run.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
from pathlib import Path

_NAMES = re.compile(r"[0-9a-f]{40}(\.o|\.\d+\.[0-9a-f]{8})")  # entries, and what a killed process left
_SEAL = 32  # bytes of checksum in front of each entry


def folder() -> Path:
    """Where machine code is kept: PYLMP_CACHE, else pylmp in the user's cache folder."""
    if own := os.environ.get("PYLMP_CACHE"):
        return Path(own)
    return Path(os.environ.get("XDG_CACHE_HOME") or Path("~/.cache").expanduser()) / "pylmp"


def find(name: str) -> bytes | None:
    """The machine code kept under name; None when there is none, or none to be trusted."""
    try:
        with open(folder() / f"{name}.o", "rb") as file:
            if not _ours(os.fstat(file.fileno())):
                return None
            entry = file.read()
    except (OSError, RuntimeError):
        return None
    code = entry[_SEAL:]
    return code if code and entry[:_SEAL] == _seal(name, code) else None


def keep(name: str, code: bytes) -> None:
    """Keep code under name. Two processes may do so at once: each writes a private file and renames it."""
    try:
        home = folder()
        home.mkdir(mode=0o700, parents=True, exist_ok=True)
        private = home / f"{name}.{os.getpid()}.{os.urandom(4).hex()}"
        try:
            with open(os.open(private, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as file:
                file.write(_seal(name, code) + code)
            os.replace(private, home / f"{name}.o")
        finally:
            private.unlink(missing_ok=True)
    except (OSError, RuntimeError):
        pass


def contents() -> tuple[int, int]:
    """How many kernels are kept, and how many bytes they take."""
    sizes = []
    for path in _files():
        with contextlib.suppress(OSError):
            sizes.append(path.stat().st_size if path.suffix == ".o" else 0)
    return len([size for size in sizes if size]), sum(sizes)


def empty() -> int:
    """Delete all that keep made, and nothing else; returns how many files."""
    count = 0
    for path in _files():
        with contextlib.suppress(OSError):
            path.unlink()
            count += 1
    return count


def _files() -> list[Path]:
    try:
        return [path for path in folder().iterdir() if _NAMES.fullmatch(path.name)]
    except (OSError, RuntimeError):
        return []


def _ours(status: os.stat_result) -> bool:
    """Code that will be run must come from this user, and nobody else may have changed it."""
    return not hasattr(os, "getuid") or (status.st_uid == os.getuid() and not status.st_mode & 0o022)


def _seal(name: str, code: bytes) -> bytes:
    """Of content and name, so that an entry moved to another name is no entry."""
    return hashlib.blake2b(code, digest_size=_SEAL, key=name.encode()).digest()
