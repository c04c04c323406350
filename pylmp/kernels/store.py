"""Kernels kept between runs as machine code, found by content.

A kernel is a plain Python function with annotated arguments (``x: "f8*", n: "i8", dt: "f8"``) composed by closing over
laws and constants. It is compiled once; a later run finds it by its key and never imports the compiler. A store that
cannot be read, written or trusted costs time, never the run.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import sys
import threading
import types
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from pylmp.kernels.compile import arguments, compile_object
from pylmp.kernels.key import key
from pylmp.kernels.load import place

_SCALARS = {"f8": ctypes.c_double, "i8": ctypes.c_int64}
_ARRAYS = {"f8*": np.float64, "i8*": np.int64, "i4*": np.int32, "u1*": np.uint8}
_SEAL = 20  # bytes of checksum in front of each entry

_placed: dict[str, Kernel] = {}


def folder() -> Path:
    """Where machine code is kept: PYLMP_CACHE, else pylmp in the user's cache folder."""
    if own := os.environ.get("PYLMP_CACHE"):
        return Path(own)
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "pylmp"


class Kernel:
    """A compiled function: ``bind`` fixes its arguments, the bound call runs it and returns its float."""

    def __init__(self, function: types.FunctionType, code: bytes) -> None:
        self.name = function.__name__
        self.kinds = arguments(function)
        self.owner, self.address = place(code)
        native = [_SCALARS[kind] if kind in _SCALARS else ctypes.c_void_p for kind in self.kinds]
        self._call = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p, *native)(self.address)

    def bind(self, *values: Any) -> Callable[[], float]:
        """A call with these arguments: arrays (kept alive, not copied) and numbers.

        Raises TypeError if an array is not C-contiguous or of another type than the kernel's annotation.
        """
        if len(values) != len(self.kinds):
            raise TypeError(f"{self.name} takes {len(self.kinds)} arguments, not {len(values)}")
        native = [self._native(kind, value) for kind, value in zip(self.kinds, values, strict=True)]
        result, error = ctypes.c_double(), ctypes.c_void_p()
        head = (ctypes.c_void_p(ctypes.addressof(result)), ctypes.c_void_p(ctypes.addressof(error)))
        call, whole, name = self._call, (*head, *native), self.name

        def bound(_alive: Any = (values, result, error)) -> float:
            if call(*whole):
                raise FloatingPointError(f"{name} failed")
            return result.value

        return bound

    def _native(self, kind: str, value: Any) -> Any:
        if kind in _SCALARS:
            return _SCALARS[kind](value)
        if not (isinstance(value, np.ndarray) and value.dtype == _ARRAYS[kind] and value.flags.c_contiguous):
            raise TypeError(f"{self.name} wants a contiguous {_ARRAYS[kind].__name__} array, not {value!r}")
        return ctypes.c_void_p(value.ctypes.data)


def kernel(function: types.FunctionType) -> Kernel:
    """The kernel of a function: from this process, from the store, or compiled now and stored."""
    name = key(function)
    if name not in _placed:
        found = _find(name, function)
        if found is None:
            code = compile_object(function)
            _keep(name, code)
            found = Kernel(function, code)
        _placed[name] = found
    return _placed[name]


def prepare(functions: Sequence[types.FunctionType], say: Callable[[str], None]) -> None:
    """Compile what is missing of these, in parallel where the system allows; say gets one line if anything is."""
    missing = {}
    for function in functions:
        name = key(function)
        if name not in _placed:
            found = _find(name, function)
            if found is None:
                missing[name] = function
            else:
                _placed[name] = found
    if not missing:
        return
    say(f"Compiling {len(missing)} kernels for this scene, once (some seconds) ...\n")
    workers = min(len(missing), os.cpu_count() or 1)
    may_fork = hasattr(os, "fork") and "numba" not in sys.modules and threading.active_count() == 1
    if workers > 1 and may_fork:
        _compile_in_children(list(missing.items()), workers)
    for function in missing.values():
        kernel(function)


def _compile_in_children(work: list[tuple[str, types.FunctionType]], workers: int) -> None:
    """Each child compiles every workers-th kernel into the store; what a child fails to leave is compiled here."""
    children = []
    for share in range(workers):
        child = os.fork()
        if child == 0:
            try:
                for name, function in work[share::workers]:
                    _keep(name, compile_object(function))
            finally:
                os._exit(0)
        children.append(child)
    for child in children:
        os.waitpid(child, 0)


def _find(name: str, function: types.FunctionType) -> Kernel | None:
    try:
        entry = (folder() / f"{name}.o").read_bytes()
    except OSError:
        return None
    code = entry[_SEAL:]
    if entry[:_SEAL] != _seal(code):
        return None
    try:
        return Kernel(function, code)
    except Exception:  # an entry that cannot be placed is no entry
        return None


def _keep(name: str, code: bytes) -> None:
    """Write an entry whole or not at all."""
    home = folder()
    private = home / f"{name}.{os.getpid()}.{os.urandom(4).hex()}"
    try:
        home.mkdir(mode=0o700, parents=True, exist_ok=True)
        try:
            private.write_bytes(_seal(code) + code)
            os.replace(private, home / f"{name}.o")
        finally:
            private.unlink(missing_ok=True)
    except OSError:
        pass


def _seal(code: bytes) -> bytes:
    return hashlib.blake2b(code, digest_size=_SEAL).digest()
