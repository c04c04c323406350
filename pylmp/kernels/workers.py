"""Kernels compiled in forked children, which hand back machine code through a pipe.

Several are compiled at once, and this process never loads the compiler, so that it may fork again later.
"""

from __future__ import annotations

import gc
import os
import selectors
import struct
import sys
import threading
import types
import warnings
from collections.abc import Sequence

from pylmp.kernels.compile import compile_object
from pylmp.kernels.key import reached
from pylmp.kernels.load import check_allowed

_HEAD = struct.Struct("<qq")  # number of the function, bytes of its code
_TICKET = struct.Struct("<H")  # number of a function that nobody has taken yet
_MOST = 2000  # tickets that fit into a pipe before anybody reads


def compile_all(functions: Sequence[types.FunctionType]) -> list[bytes]:
    """Machine code of each function. Raises what the compiler raises, and Forbidden."""
    check_allowed()
    codes: list[bytes | None] = [None] * len(functions)
    workers = min(len(functions), os.cpu_count() or 1)
    if _may_fork():
        children = _children(functions, workers)
        _collect([pipe for _, pipe in children], codes)
        for child, _ in children:
            os.waitpid(child, 0)
    # What no child delivered is compiled here, where an error has somebody to tell.
    return [code or compile_object(function) for code, function in zip(codes, functions, strict=True)]


def _may_fork() -> bool:
    """A forked child inherits only one thread, so the locks of others would stay shut for ever."""
    safe = hasattr(os, "fork") and sys.platform != "darwin"
    return safe and "numba" not in sys.modules and threading.active_count() == 1


def _size(function: types.FunctionType) -> int:
    """Bytes of bytecode that a kernel reaches: about as long as these are, compiling takes."""
    seen, pending, size = {function}, [function], 0
    while pending:
        current = pending.pop()
        size += len(current.__code__.co_code)
        for _, value in reached(current.__code__, current):
            if isinstance(value, types.FunctionType) and value not in seen:
                seen.add(value)
                pending.append(value)
    return size


def _children(functions: Sequence[types.FunctionType], workers: int) -> list[tuple[int, int]]:
    """(process, reading end of its pipe); each child takes what is next, the longest work first."""
    started: list[tuple[int, int]] = []
    order = sorted(range(len(functions)), key=lambda number: -_size(functions[number]))
    try:
        tickets, counter = os.pipe()
    except OSError:
        return started
    os.write(counter, b"".join(_TICKET.pack(number) for number in order[:_MOST]))
    os.close(counter)
    for _ in range(workers):
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
            _deliver(functions, tickets, writing)
        os.close(writing)
        started.append((child, reading))
    os.close(tickets)
    return started


def _deliver(functions: Sequence[types.FunctionType], tickets: int, writing: int) -> None:
    """In the child: compile and write, then leave without the parent's clean-up. Errors are met again in the parent."""
    try:
        gc.disable()  # the child does not live long
        sys.modules.setdefault("scipy", None)  # type: ignore[arg-type]  # which numba would import, a third of a second, where it is installed
        with open(writing, "wb") as out:
            while ticket := os.read(tickets, _TICKET.size):
                (number,) = _TICKET.unpack(ticket)
                code = compile_object(functions[number])
                out.write(_HEAD.pack(number, len(code)) + code)
                out.flush()
    finally:
        os._exit(0)


def _collect(pipes: Sequence[int], codes: list[bytes | None]) -> None:
    """What the children deliver until they are gone."""
    delivered = {pipe: bytearray() for pipe in pipes}
    with selectors.DefaultSelector() as ready:
        for pipe in pipes:
            ready.register(pipe, selectors.EVENT_READ)
        while ready.get_map():
            for key, _ in ready.select():
                part = os.read(key.fd, 1 << 16)
                delivered[key.fd] += part
                if not part:
                    ready.unregister(key.fd)
                    os.close(key.fd)
    for data in delivered.values():
        at = 0
        while len(head := data[at : at + _HEAD.size]) == _HEAD.size:
            number, length = _HEAD.unpack(head)
            at += _HEAD.size
            if len(code := bytes(data[at : at + length])) == length:
                codes[number] = code
            at += length
