"""Words for kernels that call machine code by its address: other kernels, the C library's clock.

As for all words, the functions below are the plain Python meaning; what the compiler makes of them is in ``alphabet.py``.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any


def invoke(address: int, block: int) -> float:
    """Call the kernel at address; block: where its arguments are. Both as store.entry gives them."""
    import ctypes

    result: float = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_int64)(int(address))(int(block))
    return result


def seconds(address: int, clock: int, room: Any) -> float:
    """What C's clock_gettime, at address, says of a clock. room: two whole numbers to write to."""
    import ctypes

    ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_int32, ctypes.c_int64)(int(address))(int(clock), room.ctypes.data)
    return float(room[0]) + 1.0e-9 * float(room[1])


@cache
def clock() -> tuple[int, int] | None:
    """Address of clock_gettime and its steady clock's number; None where the system has none."""
    import ctypes
    import time

    try:
        found = ctypes.CDLL(None).clock_gettime
        return ctypes.cast(found, ctypes.c_void_p).value or 0, time.CLOCK_MONOTONIC
    except (AttributeError, OSError, TypeError):
        return None


WORDS: frozenset[Callable[..., Any]] = frozenset({invoke, seconds})
