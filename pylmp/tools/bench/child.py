"""One program run as a child process: its exit code, its time, the most memory it held."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

_KILO = 1 if sys.platform == "darwin" else 1024  # the unit of ru_maxrss


@dataclass(frozen=True)
class Child:
    """How it ended. seconds: from start to end. said: what it wrote to both streams.

    peak: bytes, never below what the starting process itself holds (a system counts a child from its fork on).
    """

    code: int
    seconds: float
    peak: int
    said: str


def run(command: Sequence[str], folder: Path, environment: Mapping[str, str], timeout: float | None) -> Child:
    """Run command in folder and wait for it.

    Raises subprocess.TimeoutExpired after timeout seconds; nothing it started is left behind, then or at an interrupt.
    """
    with tempfile.TemporaryFile() as out:
        start = time.perf_counter()
        process = subprocess.Popen(
            command, cwd=folder, env=dict(environment), stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
            start_new_session=True,
        )  # fmt: skip
        late = threading.Event()

        def stop() -> None:
            late.set()
            _end(process)

        timer = threading.Timer(timeout, stop) if timeout is not None else None
        if timer is not None:
            timer.start()
        try:
            _, status, usage = os.wait4(process.pid, 0)
        except BaseException:
            _end(process)
            process.wait()
            raise
        finally:
            if timer is not None:
                timer.cancel()
        seconds = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if late.is_set():
            raise subprocess.TimeoutExpired(list(command), timeout or 0.0)
        out.seek(0)
        return Child(process.returncode, seconds, usage.ru_maxrss * _KILO, out.read().decode(errors="replace"))


def _end(process: subprocess.Popen[bytes]) -> None:
    """The process and all it started (mpiexec's ranks)."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
