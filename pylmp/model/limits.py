"""What a script may take: jumps, memory. Asked before it is taken, so that the answer is a sentence and not a machine that stands still."""

from __future__ import annotations

import contextlib
import math
import os
from collections.abc import Iterator
from pathlib import Path

from pylmp.text.diagnostic import ScriptError
from pylmp.text.span import Span

JUMPS = 200_000  # in a row, with nothing but variables changing
ATOM_BYTES = 400  # of an atom without its neighbors: 335 in a run of the exact engine, 480 of the fast one, measured with 256000 atoms
_RESERVE = 0.9  # of what is free


def room(needed: float, what: str, span: Span | None, manual: str = "") -> None:
    """Raises ScriptError if needed bytes are more than this machine has free. what: "2000000000 atoms"."""
    free = available()
    if needed > _RESERVE * free:
        raise ScriptError(
            f"There is no memory for {what}: about {size(needed)} would be needed, {size(free)} are free", span,
            hint="a smaller number", code="S109", manual=manual,
        )  # fmt: skip


def available() -> float:
    """Bytes this process may still take: of the machine, of its control group, of ulimit -v."""
    free = [float("inf")]
    with contextlib.suppress(OSError, ValueError, StopIteration):
        lines = Path("/proc/meminfo").read_text().splitlines()
        free.append(sum(1024.0 * int(line.split()[1]) for line in lines if line.startswith(("MemAvailable:", "SwapFree:"))))
    with contextlib.suppress(OSError, ValueError):
        group = Path("/sys/fs/cgroup")
        free.append(float((group / "memory.max").read_text()) - float((group / "memory.current").read_text()))
    with contextlib.suppress(ImportError, OSError, ValueError):
        import resource

        most = resource.getrlimit(resource.RLIMIT_AS)[0]
        if most != resource.RLIM_INFINITY:
            free.append(most - float(Path("/proc/self/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE"))
    return max(0.0, min(free))


@contextlib.contextmanager
def bounded() -> Iterator[None]:
    """Inside, the system refuses memory that the machine does not have (a MemoryError) where it would end the process later."""
    try:
        import resource
    except ImportError:  # not on this system
        yield
        return
    before = resource.getrlimit(resource.RLIMIT_DATA)
    free = available()
    if free < float("inf"):
        with contextlib.suppress(OSError, ValueError, IndexError):
            taken = int(Path("/proc/self/statm").read_text().split()[5]) * os.sysconf("SC_PAGE_SIZE")
            most = taken + int(free)
            if before[0] == resource.RLIM_INFINITY or most < before[0]:
                resource.setrlimit(resource.RLIMIT_DATA, (most, before[1]))
    try:
        yield
    finally:
        with contextlib.suppress(OSError, ValueError):
            resource.setrlimit(resource.RLIMIT_DATA, before)


def size(count: float) -> str:
    """Bytes as a person reads them: 480 MB."""
    power = min(4, max(0, int(math.log10(max(count, 1.0)) / 3.0)))
    return f"{count / 1000.0**power:.3g} {('bytes', 'kB', 'MB', 'GB', 'TB')[power]}"
