"""The alphabet of laws: what a formula may call besides ``+ - * /`` and comparisons.

A law is written once, without branches, and means the same at every width: one ``float`` (plain Python),
numpy arrays, mpmath numbers (the tests' 50-digit oracle), and what the compiler makes of it. The
compiler's side of these names is in ``pylmp/kernels/alphabet.py``.

exp, log, sin, cos, power are the C library's, value by value (numpy's own round differently), and answer as C does
where Python's would raise: infinite beyond the range of doubles, nan outside the domain.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np


def select(mask: Any, a: Any, b: Any) -> Any:
    """a where mask holds, else b."""
    if isinstance(mask, np.ndarray):
        return np.where(mask, a, b)
    return a if mask else b


def sqrt(x: Any) -> Any:
    if isinstance(x, float):
        return math.sqrt(x)
    return np.sqrt(x) if isinstance(x, np.ndarray) else x**0.5


def fabs(x: Any) -> Any:
    return abs(x)


def exp(x: Any) -> Any:
    return _of_c("exp", x)


def log(x: Any) -> Any:
    return _of_c("log", x)


def sin(x: Any) -> Any:
    return _of_c("sin", x)


def cos(x: Any) -> Any:
    return _of_c("cos", x)


def power(x: Any, y: Any) -> Any:
    """x to the y, C's pow."""
    return _of_c("pow", x, y)


def whole(x: Any) -> Any:
    """x without its fraction, as an index; 0 where that is nothing (nan, beyond 2^62)."""
    if isinstance(x, np.ndarray):
        return np.where(np.abs(x) < 2.0**62, x, 0.0).astype(np.int64)
    return int(x) if abs(x) < 2.0**62 else 0


def single(x: Any) -> Any:
    """The single precision number next to x."""
    narrow = _narrow(x)
    return narrow.astype(np.float64) if isinstance(x, np.ndarray) else float(narrow)


def bits(x: Any) -> Any:
    """The bits of the single precision number next to x, as a number of 32 bits with a sign."""
    pattern = _narrow(x).view(np.int32)
    return pattern.astype(np.int64) if isinstance(x, np.ndarray) else int(pattern)


def _narrow(x: Any) -> Any:
    with np.errstate(over="ignore"):
        return x.astype(np.float32) if isinstance(x, np.ndarray) else np.float64(x).astype(np.float32)


def _of_c(name: str, *values: Any) -> Any:
    """A function of the C library, for any kind of number; others than floats and arrays bring their own."""
    if any(isinstance(value, np.ndarray) for value in values):
        arrays = np.broadcast_arrays(*values)
        each = zip(*(array.ravel().tolist() for array in arrays), strict=True)
        return np.array([_double(name, row) for row in each]).reshape(arrays[0].shape)
    if all(isinstance(value, (float, int)) for value in values):
        return _double(name, values)
    own = next(value for value in values if not isinstance(value, (float, int))).context
    function: Callable[..., Any] = getattr(own, {"pow": "power"}.get(name, name))
    return function(*values)


def _double(name: str, values: tuple[float, ...]) -> float:
    try:
        return float(getattr(math, name)(*values))
    except OverflowError:
        odd = name == "pow" and values[0] < 0.0 and values[1] % 2.0 == 1.0
        return -math.inf if odd else math.inf
    except ValueError:
        if name == "log" and values[0] == 0.0:
            return -math.inf
        return math.inf if name == "pow" and values[0] == 0.0 else math.nan
