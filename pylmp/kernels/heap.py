"""Memory that is freed goes back to the system, where the C library has words for that."""

from __future__ import annotations

import contextlib
import ctypes

_THRESHOLD, _LARGE = -3, 2**22  # of mallopt; numpy asks for huge pages from here on


def part_with_large() -> None:
    """From now on arrays of megabytes are mappings of their own. glibc keeps ever larger ones in its heap, with holes, as soon as some
    were freed."""
    with contextlib.suppress(AttributeError, OSError, TypeError):
        ctypes.CDLL(None).mallopt(_THRESHOLD, _LARGE)


def trim() -> None:
    """Pages of the heap that nobody uses."""
    with contextlib.suppress(AttributeError, OSError, TypeError):
        ctypes.CDLL(None).malloc_trim(0)
