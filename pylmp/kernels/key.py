"""What a kernel is: a digest of everything that shapes its machine code.

The walk goes over a function's bytecode, constants, annotations, captured values and every function it reaches. Comments,
doc strings and line numbers stay out. What cannot be described exactly is refused.
"""

from __future__ import annotations

import hashlib
import importlib.machinery
import os
import platform
import struct
import sys
import types
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

_SUPPORT = ("alphabet.py", "atomic.py", "compile.py", "simd/vector.py", "simd/word.py", "simd/memory.py", "simd/emit.py")  # they teach the compiler the alphabet: every byte counts
_UNDERSTOOD = {"builtins", "math", "operator"}  # what numba itself compiles; its version is in the key

Put = Callable[[bytes | str], None]


def key(function: types.FunctionType) -> str:
    """Content key of a kernel. Raises TypeError when it captures something that has no exact description."""
    digest = hashlib.blake2b(digest_size=20)

    def put(part: bytes | str) -> None:
        data = part if isinstance(part, bytes) else part.encode()
        digest.update(struct.pack("<q", len(data)) + data)

    for part in _machine():
        put(part)
    try:
        _describe(function, put, {})
    except TypeError as error:
        raise TypeError(f"kernel {function.__name__}: {error}") from None
    return digest.hexdigest()


def reached(code: types.CodeType, function: types.FunctionType) -> Iterator[tuple[str, Any]]:
    """Globals, captured cells and defaults that code (of function) names."""
    for name in code.co_names:
        if name in function.__globals__:
            yield name, function.__globals__[name]
    if code is function.__code__:
        for name, cell in zip(code.co_freevars, function.__closure__ or (), strict=True):
            yield name, cell.cell_contents
        yield "defaults", function.__defaults__


def _describe(value: Any, put: Put, seen: dict[int, int]) -> None:
    if isinstance(value, types.FunctionType):
        if id(value) in seen:
            put(f"again {seen[id(value)]}")
            return
        seen[id(value)] = len(seen)
        put(f"def {value.__name__} {sorted((k, str(v)) for k, v in value.__annotations__.items())}")
        _describe_code(value.__code__, value, put, seen)
    elif isinstance(value, tuple):
        put(f"tuple {len(value)}")
        for item in value:
            _describe(item, put, seen)
    elif value is None or isinstance(value, (bool, int, float, str)):
        put(f"{type(value).__name__} {value!r}")
    elif isinstance(value, types.ModuleType) and value.__name__ in (*_UNDERSTOOD, "numpy"):
        put(f"module {value.__name__}")
    elif isinstance(value, (types.BuiltinFunctionType, type)) and value.__module__ in _UNDERSTOOD:
        put(f"{value.__module__}.{value.__name__}")
    else:
        raise TypeError(f"code cannot be kept that captures {value!r}")


def _describe_code(code: types.CodeType, function: types.FunctionType, put: Put, seen: dict[int, int]) -> None:
    put(f"{code.co_argcount} {code.co_names} {code.co_varnames} {code.co_freevars}")
    put(code.co_code)
    for position, constant in enumerate(code.co_consts):
        if position == 0 and constant == function.__doc__:
            continue
        if isinstance(constant, types.CodeType):
            _describe_code(constant, function, put, seen)
        else:
            _describe(constant, put, seen)
    for name, value in reached(code, function):
        put(name)
        _describe(value, put, seen)


@cache
def _machine() -> tuple[bytes, ...]:
    """Processor, Python, compiler: what the same function may compile differently for."""
    parts = [sys.implementation.cache_tag or "", sys.platform, _processor()]
    parts.append(repr(sorted(item for item in os.environ.items() if item[0].startswith("NUMBA_"))))
    for package in ("numba", "llvmlite"):
        found = importlib.machinery.PathFinder.find_spec(package)  # finds, does not import
        home = Path(found.origin).parent if found and found.origin else None
        parts.append((home / "_version.py").read_text() if home else "absent")
    here = Path(__file__).parent
    return (*(part.encode() for part in parts), *((here / name).read_bytes() for name in _SUPPORT))


def _processor() -> str:
    wanted = ("vendor", "cpu family", "model", "stepping", "flags", "CPU", "Features")
    try:
        block = Path("/proc/cpuinfo").read_text().split("\n\n")[0].split("\n")
        return "\n".join(line for line in block if line.startswith(wanted))
    except OSError:
        return " ".join(platform.uname()) + platform.processor()
