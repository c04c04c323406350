"""Placing machine code in memory: a small loader for x86-64 Linux objects, LLVM's linker for all else."""

from __future__ import annotations

import ctypes
import mmap
import os
import struct
from collections.abc import Callable
from typing import Any

Memory = mmap.mmap | bytearray
Fill = Callable[[Memory, int], None]
_PROGRAM_BITS, _RELOCATIONS_WITH_ADDEND, _SYMBOLS, _IN_MEMORY = 1, 4, 2, 2
_ABSOLUTE, _RELATIVE = 1, (2, 4)  # R_X86_64_64; R_X86_64_PC32 and PLT32
_READ_EXECUTE = 5
_JUMP = b"\xff\x25\0\0\0\0"  # jmp to the address in the eight bytes behind it
_STUB_SIZE = 16
_FROM_C = frozenset({"memset", "memcpy", "memmove", "exp", "log", "pow", "sin", "cos", "sincos"})


class Forbidden(Exception):
    """The system lets nobody run machine code that was just made."""

    def __init__(self) -> None:
        super().__init__("This system allows no executable memory to programs, and pylmp makes its kernels when a script needs them")


def place(code: bytes) -> tuple[Any, int]:
    """(owner, address) of the kernel in an object. The address is good as long as the owner lives. Raises Forbidden."""
    try:
        return _load_elf(code)
    except (ValueError, OSError, struct.error, StopIteration):
        return _load_llvm(code)


def _load_elf(code: bytes) -> tuple[Any, int]:
    if code[:6] != b"\x7fELF\x02\x01" or code[18:20] != b"\x3e\0" or os.name != "posix":
        raise ValueError("not a 64-bit x86 object")
    (table_at,) = struct.unpack_from("<Q", code, 40)
    (count,) = struct.unpack_from("<H", code, 60)
    sections = [struct.unpack_from("<IIQQQQIIQQ", code, table_at + 64 * k) for k in range(count)]
    offsets, size = {}, 0
    for k, (_, kind, flags, _, _, length, _, _, align, _) in enumerate(sections):
        if flags & _IN_MEMORY and kind == _PROGRAM_BITS and length:
            step = max(align, 64)
            size = -(-size // step) * step
            offsets[k] = size
            size += length
    symbols, entry, outside = _symbols(code, sections, offsets)
    stubs = {}
    for number, name in outside.items():
        size = -(-size // _STUB_SIZE) * _STUB_SIZE
        symbols[number] = size
        stubs[size] = _JUMP + struct.pack("<Q", _of_c(name))
        size += _STUB_SIZE

    def fill(memory: Memory, start: int) -> None:
        """What lies at address start."""
        for k, offset in offsets.items():
            memory[offset : offset + sections[k][5]] = code[sections[k][4] : sections[k][4] + sections[k][5]]
        for offset, stub in stubs.items():
            memory[offset : offset + len(stub)] = stub
        for section in sections:
            if section[1] == _RELOCATIONS_WITH_ADDEND and section[7] in offsets:
                _relocate(memory, start, code, section, offsets[section[7]], symbols)

    owner, start = _changed(size, fill) or _shared(size, fill)
    return owner, start + entry


def _changed(size: int, fill: Fill) -> tuple[Any, int] | None:
    """Memory that is writable while it is filled, then executable; None where that is not allowed."""
    memory = mmap.mmap(-1, size)
    start = ctypes.addressof(ctypes.c_char.from_buffer(memory))
    fill(memory, start)
    pages = -(-size // mmap.PAGESIZE) * mmap.PAGESIZE
    refused = ctypes.CDLL(None).mprotect(ctypes.c_void_p(start), ctypes.c_size_t(pages), _READ_EXECUTE)
    return None if refused else (memory, start)


def _shared(size: int, fill: Fill) -> tuple[Any, int]:
    """Memory of a file without a name, executable from the beginning and never writable: the file is written. Raises Forbidden."""
    import numpy as np

    try:
        file = os.memfd_create("pylmp")
        try:
            os.ftruncate(file, size)
            memory = mmap.mmap(file, size, mmap.MAP_SHARED, mmap.PROT_READ | mmap.PROT_EXEC)
            start = int(np.frombuffer(memory, np.uint8).ctypes.data)
            image = bytearray(size)
            fill(image, start)
            os.pwrite(file, image, 0)
        finally:
            os.close(file)
    except (OSError, AttributeError):
        raise Forbidden from None
    return memory, start


def check_allowed() -> None:
    """What the compiler needs, also for itself. Raises Forbidden."""
    if os.name == "posix" and _changed(mmap.PAGESIZE, lambda memory, start: None) is None:
        raise Forbidden


def _symbols(code: bytes, sections: list[Any], offsets: dict[int, int]) -> tuple[list[int | None], int, dict[int, str]]:
    """Where each symbol lies, where the kernel begins, and the names of symbols that lie outside, by number."""
    table = next(s for s in sections if s[1] == _SYMBOLS)
    names = sections[table[6]][4]
    values: list[int | None] = []
    entry, outside = None, {}
    for k in range(table[5] // 24):
        name_at, _, _, section, value, _ = struct.unpack_from("<IBBHQQ", code, table[4] + 24 * k)
        name = code[names + name_at : code.index(0, names + name_at)].decode("ascii")
        values.append(offsets[section] + value if section in offsets else None)
        if section == 0 and name:
            outside[k] = name
        if name == "kernel":
            entry = values[-1]
    if entry is None:
        raise ValueError("no kernel in the object")
    return values, entry, outside


def _of_c(name: str) -> int:
    """The address of a function of the C library: the compiler makes loops that fill or copy into calls of memset, ..."""
    if name not in _FROM_C:
        raise ValueError(f"{name} is not among the C library's functions a kernel may call")
    for library in (None, "libm.so.6"):
        try:
            return ctypes.cast(getattr(ctypes.CDLL(library), name), ctypes.c_void_p).value or 0
        except (AttributeError, OSError):
            continue
    raise ValueError(f"{name} is not found")


def _relocate(memory: Memory, start: int, code: bytes, section: Any, base: int, symbols: list[int | None]) -> None:
    for k in range(section[5] // 24):
        where, info, addend = struct.unpack_from("<QQq", code, section[4] + 24 * k)
        kind, value = info & 0xFFFFFFFF, symbols[info >> 32]
        where += base
        if value is None or kind not in (_ABSOLUTE, *_RELATIVE):
            raise ValueError("a relocation this loader does not know")
        if kind == _ABSOLUTE:
            struct.pack_into("<Q", memory, where, start + value + addend)
        else:
            struct.pack_into("<i", memory, where, value + addend - where)


def _load_llvm(code: bytes) -> tuple[Any, int]:
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    machine = llvm.Target.from_triple(llvm.get_process_triple()).create_target_machine(jit=True)
    jit = llvm.create_lljit_compiler(machine)
    linked = llvm.JITLibraryBuilder().add_object_img(code).export_symbol("kernel").link(jit, "kernel")
    return (jit, linked), linked["kernel"]
