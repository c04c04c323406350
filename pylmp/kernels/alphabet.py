"""What the compiler knows of the laws' alphabet. Only ``compile.py`` imports this file."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from numba.extending import overload

from pylmp import laws

WORDS: frozenset[Callable[..., Any]] = frozenset({laws.select, laws.sqrt, laws.fabs})


@overload(laws.select)
def _select(mask: Any, a: Any, b: Any) -> Any:
    return lambda mask, a, b: a if mask else b


@overload(laws.sqrt)
def _sqrt(x: Any) -> Any:
    return lambda x: math.sqrt(x)


@overload(laws.fabs)
def _fabs(x: Any) -> Any:
    return lambda x: math.fabs(x)
