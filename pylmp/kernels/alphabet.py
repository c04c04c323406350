"""What the compiler knows of the laws' alphabet. Only ``compile.py`` imports this file.

Overloads carry no annotations: numba compares their signature with the implementation's.
"""

# mypy: allow-untyped-defs, allow-untyped-calls, disable-error-code="no-untyped-call"

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from numba.extending import overload

from pylmp import laws

WORDS: frozenset[Callable[..., Any]] = frozenset({laws.select, laws.sqrt, laws.fabs})


@overload(laws.select)
def _select(mask, a, b):
    return lambda mask, a, b: a if mask else b


@overload(laws.sqrt)
def _sqrt(x):
    return lambda x: math.sqrt(x)


@overload(laws.fabs)
def _fabs(x):
    return lambda x: math.fabs(x)
