"""Types of kernels and laws, for readers and the type checker."""

from __future__ import annotations

from types import FunctionType
from typing import Any

Function = Any  # a plain annotated function; FunctionType at run time
__all__ = ["Function", "FunctionType"]
