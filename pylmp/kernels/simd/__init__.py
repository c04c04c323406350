"""Words for kernels that work on several numbers at once (SIMD: single instruction, multiple data).

A vector has a fixed number of lanes: 8 doubles, 16 singles, 8 or 16 whole numbers, as many truths. ``+ - * /`` and
comparisons work lane by lane, between vectors of the same kind and between a vector and a number; ``& |`` join masks.
``laws.select``, ``laws.sqrt`` and ``laws.fabs`` take vectors too, so that a law is written once for both widths.

The words below are plain Python over numpy arrays, so that a kernel can be read, called and tested without a compiler. What
the compiler makes of them is in ``memory.py`` and ``emit.py``: a processor without such wide registers does the same in several narrower ones.
Arithmetic is strict IEEE, so that a lane has the bits a lone number would have.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

LANES = 8  # doubles
WIDE = 16  # singles, and the whole numbers that go with them


def load(array: Any, at: int, lanes: int) -> Any:
    """array[at : at + lanes]"""
    return array[at : at + lanes].copy()


def store(array: Any, at: int, vector: Any) -> None:
    """array[at : at + lanes] = vector"""
    array[at : at + len(vector)] = vector


def gather(array: Any, index: Any, offset: int) -> Any:
    """array[index + offset], lane by lane."""
    return array[index + offset]


def gather_rows(array: Any, index: Any) -> Any:
    """Three vectors: array[index], array[index + 1], array[index + 2]. The array has one element more behind the last of these.

    Whole rows are read and turned, which is faster than three times gather.
    """
    return array[index], array[index + 1], array[index + 2]


def scatter(array: Any, index: Any, offset: int, vector: Any) -> None:
    """array[index + offset] = vector, lane by lane; no index twice."""
    array[index + offset] = vector


def splat(value: float, lanes: int) -> Any:
    """A vector of doubles that are all value."""
    return np.full(lanes, float(value))


def splat_single(value: float, lanes: int) -> Any:
    """A vector of singles that are all value."""
    return np.full(lanes, np.float32(value))


def splat_whole(value: int, lanes: int) -> Any:
    """A vector of 32-bit whole numbers that are all value."""
    return np.full(lanes, value, np.int32)


def count_up(start: int, lanes: int) -> Any:
    """start, start + 1, ... as 32-bit whole numbers."""
    return np.arange(start, start + lanes, dtype=np.int32)


def single(vector: Any) -> Any:
    """Doubles rounded to singles."""
    return vector.astype(np.float32)


def double(vector: Any) -> Any:
    """Singles or whole numbers as doubles."""
    return vector.astype(np.float64)


def some(mask: Any) -> bool:
    """Does any lane hold?"""
    return bool(mask.any())


def count(mask: Any) -> int:
    """In how many lanes it holds."""
    return int(mask.sum())


def compress(array: Any, at: int, vector: Any, mask: Any) -> int:
    """Store the lanes of vector that mask chooses one behind the other from array[at] on; returns how many.

    The array needs room for all lanes: those behind the chosen ones are overwritten with anything.
    """
    chosen = vector[mask]
    array[at : at + len(chosen)] = chosen
    return len(chosen)


def total(vector: Any) -> float:
    """The sum of all lanes, from the first to the last."""
    result = 0.0
    for value in vector:
        result += float(value)
    return result


def largest(vector: Any) -> float:
    """The largest lane; nan where one is nan."""
    return float(vector.max())


WORDS: frozenset[Callable[..., Any]] = frozenset(
    {load, store, gather, gather_rows, scatter, splat, splat_single, splat_whole, count_up, single, double, some, count, compress, total, largest}
)
