"""The alphabet of laws: what a formula may call besides ``+ - * /`` and comparisons.

A law is written once, without branches, and means the same at every width: one ``float`` (plain Python),
numpy arrays, mpmath numbers (the tests' 50-digit oracle), and what the compiler makes of it. The
compiler's side of these three names is in ``pylmp/kernels/alphabet.py``.
"""

from __future__ import annotations

import math
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
