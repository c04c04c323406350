"""Cubic splines as LAMMPS makes and evaluates them.

The second derivatives solve the tridiagonal system of the natural continuity conditions with given end slopes (any book on
numerical analysis). Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats


def second_derivatives(x: Floats, y: Floats, first: float, last: float) -> Floats:
    """Of the spline through (x, y), at least two points, with slopes first and last at its ends."""
    n = len(x)
    with np.errstate(all="ignore"):
        h = x[1:] - x[:-1]
        d = (y[1:] - y[:-1]) / h
        wide = x[2:] - x[:-2]
        sig = (h[:-1] / wide).tolist()
        bend = (6.0 * (d[1:] - d[:-1]) / wide).tolist()
        begin, end = (3.0 / h[0]) * (d[0] - first), (3.0 / h[-1]) * (last - d[-1])
    y2, u = [-0.5], [float(begin)]
    for s, b in zip(sig, bend, strict=True):
        p = s * y2[-1] + 2.0
        u.append(_over(b - s * u[-1], p))
        y2.append(_over(s - 1.0, p))
    y2.append(_over(float(end) - 0.5 * u[-1], 0.5 * y2[-1] + 1.0))
    for k in range(n - 2, -1, -1):
        y2[k] = y2[k] * y2[k + 1] + u[k]
    return np.array(y2)


def _over(a: float, b: float) -> float:
    """a/b, as C divides: without an exception where b is 0."""
    if b != 0.0:
        return a / b
    with np.errstate(all="ignore"):
        return float(np.float64(a) / np.float64(b))


def evaluate(x: Floats, y: Floats, y2: Floats, at: Floats) -> Floats:
    """The spline's values at places."""
    low, high = np.zeros(len(at), np.int64), np.full(len(at), len(x) - 1)
    while (high - low > 1).any():
        middle = (high + low) // 2
        left = x[middle] > at
        high, low = np.where(left, middle, high), np.where(left, low, np.where(high - low > 1, middle, low))
    with np.errstate(all="ignore"):
        h = x[high] - x[low]
        a, b = (x[high] - at) / h, (at - x[low]) / h
        return a * y[low] + b * y[high] + ((a * a * a - a) * y2[low] + (b * b * b - b) * y2[high]) * (h * h) / 6.0
