"""Functions of the C library on arrays: the same bits as one value at a time, which numpy's own do not give."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from pylmp.kernels.exact import maps
from pylmp.kernels.store import kernel

_FEW = 5000  # values below which a kernel is not worth its making


def of_c(name: str, *values: Any) -> Any:
    """(n,) float64, or a float if no value is an array."""
    if not any(isinstance(value, np.ndarray) for value in values):
        return _one(name, values)
    arrays = [np.ascontiguousarray(array, float) for array in np.broadcast_arrays(*values)]
    if len(arrays[0]) < _FEW or name not in maps.NAMES:
        return np.array([_one(name, row) for row in zip(*(array.tolist() for array in arrays), strict=True)], float)
    out = np.empty(len(arrays[0]))
    kernel(maps.each(name)).bind(*arrays, out, len(out))()
    return out


def _one(name: str, values: tuple[float, ...]) -> float:
    """What C returns where Python raises."""
    try:
        return float(getattr(math, name)(*values))
    except OverflowError:
        odd = name == "pow" and values[0] < 0.0 and values[1] % 2.0 == 1.0
        return -math.inf if odd else math.inf
    except ValueError:
        return math.inf if name == "pow" and values[0] == 0.0 else -math.nan
