"""Kernels kept between runs as machine code, found by content.

A kernel is a plain Python function with annotated arguments (``x: "f8*", n: "i8", dt: "f8"``) composed by closing over
laws and constants. It is compiled once; a later run finds it by its key and never imports the compiler. A store that
cannot be read, written or trusted costs time, never the run.
"""

from __future__ import annotations

import ctypes
import struct
import types
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np

from pylmp.kernels import disk
from pylmp.kernels.compile import HEAD, arguments
from pylmp.kernels.key import key
from pylmp.kernels.load import place
from pylmp.kernels.workers import compile_all

_WORDS = {"f8": "d", "i8": "q"}  # of struct; arrays go in by their address
_ARRAYS = {"f8*": np.float64, "i8*": np.int64, "i4*": np.int32, "u1*": np.uint8, "f4*": np.float32}
_placed: dict[str, Kernel] = {}  # by content
_made: WeakKeyDictionary[types.FunctionType, Kernel] = WeakKeyDictionary()  # by function: saves walking it again


class Kernel:
    """A compiled function: ``bind`` fixes its arguments, the bound call runs it and returns its float."""

    def __init__(self, function: types.FunctionType, code: bytes) -> None:
        self.name = function.__name__
        self.kinds = arguments(function)
        self.owner, self.address = place(code)
        self._block = struct.Struct(f"={8 * HEAD}x" + "".join(_WORDS.get(kind, "Q") for kind in self.kinds))
        self._type = ctypes.c_char * self._block.size
        self.last: partial[float] | None = None  # the last bound call: most of what it knows is asked for again
        self._call = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_void_p)(self.address)

    def bind(self, *values: Any) -> Callable[[], float]:
        """A call with these arguments: arrays (kept alive, not copied) and numbers.

        Raises TypeError if an array is not C-contiguous or of another type than the kernel's annotation.
        """
        if len(values) != len(self.kinds):
            raise TypeError(f"{self.name} takes {len(self.kinds)} arguments, not {len(values)}")
        last = self.last
        before, known = vars(last)["alive"][:2] if last else (self.kinds, self.kinds)
        words = [
            value if kind in _WORDS else word if value is old else self._address(kind, value)
            for kind, value, old, word in zip(self.kinds, values, before, known, strict=True)
        ]
        if last and words == known:
            return last
        try:
            block = self._type.from_buffer_copy(self._block.pack(*words))
        except struct.error as error:
            raise TypeError(f"{self.name}: {error}") from None
        bound = partial(self._call, ctypes.c_void_p(ctypes.addressof(block)))
        vars(bound)["alive"] = values, words, block, self.owner
        vars(bound)["entry"] = self.address, ctypes.addressof(block)
        self.last = bound
        return bound

    def _address(self, kind: str, value: Any) -> int:
        if not (isinstance(value, np.ndarray) and value.dtype == _ARRAYS[kind] and value.flags.c_contiguous):
            raise TypeError(f"{self.name} wants a contiguous {_ARRAYS[kind].__name__} array, not {value!r}")
        if not value.size:
            return 0
        try:
            return ctypes.addressof(ctypes.c_char.from_buffer(value))  # type: ignore[arg-type]
        except (TypeError, ValueError):  # an array that may not be written to: asked the slow way
            return int(value.ctypes.data)


def entry(bound: Callable[[], float]) -> tuple[int, int]:
    """Address and block of a bound call, for a kernel that makes it (machine.invoke): valid as long as bound lives."""
    found: tuple[int, int] = vars(bound)["entry"]
    return found


def kernel(function: types.FunctionType) -> Kernel:
    """The kernel of a function: from this process, from the store, or compiled now and stored."""
    found = _made.get(function) or _found(function, key(function))
    if found is None:
        found = _new(function, key(function), *compile_all([function]))
    return found


def release() -> None:
    """Let go of the arrays that kernels were last bound to."""
    for placed in _placed.values():
        placed.last = None


def prepare(functions: Sequence[types.FunctionType], say: Callable[[str], None]) -> tuple[int, int]:
    """Compile what is missing of these, in parallel where the system allows; say gets one line if anything is.

    Returns how many different kernels they are, and how many of them were compiled.
    """
    missing = {}
    for function in functions:
        if function not in _made and _found(function, name := key(function)) is None:
            missing[name] = function
    known = len({id(_made[function]) for function in functions if function in _made})
    if not missing:
        return known, 0
    many = "1 kernel" if len(missing) == 1 else f"{len(missing)} kernels"
    say(f"Compiling {many} for this scene, once (some seconds) ...\n")
    codes = compile_all(list(missing.values()))
    for (name, function), code in zip(missing.items(), codes, strict=True):
        _new(function, name, code)
    return known + len(missing), len(missing)


def _found(function: types.FunctionType, name: str) -> Kernel | None:
    """The kernel called name, if this process or the store has it."""
    if name not in _placed:
        code = disk.find(name)
        if code is None:
            return None
        try:
            _placed[name] = Kernel(function, code)
        except Exception:  # an entry that cannot be placed is no entry
            return None
    _made[function] = _placed[name]
    return _placed[name]


def _new(function: types.FunctionType, name: str, code: bytes) -> Kernel:
    made = Kernel(function, code)
    disk.keep(name, code)
    _placed[name] = _made[function] = made
    return made
