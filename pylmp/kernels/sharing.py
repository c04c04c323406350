"""Words for numbers that threads share: what one thread wrote before it posted, another sees after it looked.

As for all words, the functions below are the plain Python meaning; what the compiler makes of them is in ``atomic.py``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


def look(shared: Any, at: int) -> int:
    """shared[at], and with it everything written before it was posted."""
    return int(shared[at])


def post(shared: Any, at: int, value: int) -> None:
    """shared[at] = value, after everything written before."""
    shared[at] = value


def add_to(shared: Any, at: int, value: int) -> None:
    """shared[at] += value at once, after everything written before."""
    shared[at] += value


def swap_if(shared: Any, at: int, old: int, new: int) -> bool:
    """shared[at] = new if it was old, at once: was it?"""
    if shared[at] != old:
        return False
    shared[at] = new
    return True


def give_way(address: int) -> None:
    """Let another thread have this core: the C library's sched_yield, at address."""
    import ctypes

    ctypes.CFUNCTYPE(ctypes.c_int32)(int(address))()


WORDS: frozenset[Callable[..., Any]] = frozenset({look, post, add_to, swap_if, give_way})
