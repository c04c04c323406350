"""Kernels compiled in forked children, which hand back machine code through a pipe.

Several are compiled at once, and this process never loads the compiler, so that it may fork again later.
"""

from __future__ import annotations

import os
import struct
import sys
import threading
import types
import warnings
from collections.abc import Sequence

from pylmp.kernels.compile import compile_object

_HEAD = struct.Struct("<qq")  # number of the function, bytes of its code


def compile_all(functions: Sequence[types.FunctionType]) -> list[bytes]:
    """Machine code of each function. Raises what the compiler raises."""
    codes: list[bytes | None] = [None] * len(functions)
    workers = min(len(functions), os.cpu_count() or 1)
    if _may_fork():
        for child, pipe in _children(functions, workers):
            _collect(pipe, codes)
            os.waitpid(child, 0)
    # What no child delivered is compiled here, where an error has somebody to tell.
    return [code or compile_object(function) for code, function in zip(codes, functions, strict=True)]


def _may_fork() -> bool:
    """A forked child inherits only one thread, so the locks of others would stay shut for ever."""
    safe = hasattr(os, "fork") and sys.platform != "darwin"
    return safe and "numba" not in sys.modules and threading.active_count() == 1


def _children(functions: Sequence[types.FunctionType], workers: int) -> list[tuple[int, int]]:
    """(process, reading end of its pipe); child k compiles functions k, k + workers, ..."""
    started = []
    for share in range(workers):
        try:
            reading, writing = os.pipe()
        except OSError:
            break
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", DeprecationWarning)  # sleeping threads of a linear algebra library
                child = os.fork()
        except OSError:
            os.close(reading)
            os.close(writing)
            break
        if child == 0:
            _deliver(functions, share, workers, writing)
        os.close(writing)
        started.append((child, reading))
    return started


def _deliver(functions: Sequence[types.FunctionType], share: int, workers: int, writing: int) -> None:
    """In the child: compile and write, then leave without the parent's clean-up. Errors are met again in the parent."""
    try:
        with open(writing, "wb") as out:
            for number in range(share, len(functions), workers):
                code = compile_object(functions[number])
                out.write(_HEAD.pack(number, len(code)) + code)
    finally:
        os._exit(0)


def _collect(pipe: int, codes: list[bytes | None]) -> None:
    with open(pipe, "rb") as source:
        while len(head := source.read(_HEAD.size)) == _HEAD.size:
            number, length = _HEAD.unpack(head)
            code = source.read(length)
            if len(code) == length:
                codes[number] = code
