"""Threads that help with kernels.

Each helper is a thread of Python that enters machine code (``fast/fork.py``) and looks for work there, without Python's lock. When there
was none for a while it comes back and waits in Python until it is called again. Helpers live as long as a run.
"""

from __future__ import annotations

import ctypes
import os
import threading
from collections.abc import Callable
from functools import cache
from itertools import pairwise

import numpy as np

from pylmp.kernels.fast import fork as loops
from pylmp.kernels.kinds import Function
from pylmp.kernels.machine import clock
from pylmp.kernels.store import entry, kernel

Call = Callable[[], float]
PARTS = 16  # of a job: more than threads, so that one that is late takes fewer
_LEAST = 64  # atoms in a part: where there would be fewer, a job is one part
_PATIENCE = 0.03  # seconds that a helper looks for work: longer than what the caller does alone between jobs


@cache
def way() -> int | None:
    """Address of sched_yield; None where the system has none."""
    try:
        return ctypes.cast(ctypes.CDLL(None).sched_yield, ctypes.c_void_p).value
    except (AttributeError, OSError, TypeError):
        return None


def threads(asked: int | None) -> int:
    """How many threads to use: as asked, else as the environment says to programs with threads, else one."""
    said = os.environ.get("OMP_NUM_THREADS", "").split(",")[0].strip()
    return asked or min(int(said) if said.isdigit() and int(said) else 1, os.cpu_count() or 1)


def cuts(count: int, atoms: int = 1) -> list[tuple[int, int]]:
    """From where to where the parts go of count things with so many atoms each. It depends on nothing else: neither do sums over parts."""
    parts = PARTS if count * atoms >= PARTS * _LEAST else 1
    return list(pairwise(count * k // parts for k in range(parts + 1)))


class Team:
    """threads: how many work, the caller among them. results: what the parts of the last job returned."""

    def __init__(self, threads: int = 1) -> None:
        self.threads = threads if clock() and way() else 1
        self.results = np.zeros(loops.MOST_PARTS)
        self._mailbox = np.zeros(loops.MAILBOX, np.int64)
        self._parts = np.zeros(2 * loops.MOST_PARTS, np.int64)
        self._bells: list[threading.Event] = []
        self._helpers: list[threading.Thread] = []
        self._fork: Function = loops.fork
        self._serve: Function = loops.serve

    def functions(self) -> list[Function]:
        return [self._fork, *([self._serve] if self.threads > 1 else [])]

    def job(self, calls: list[Call]) -> Call:
        """One call that makes all of these, in any order and at the same time; it returns the sum of what they return. Others than its kernels must not call it."""
        if len(calls) == 1:
            return calls[0]
        table = np.array([entry(call) for call in calls], np.int64).ravel()
        bound = kernel(self._fork).bind(self._mailbox, self._parts, self.results, table, len(calls), way() or 0)
        vars(bound)["parts"] = calls  # they live as long as it does
        return bound

    def split(self, count: int, bind: Callable[[int, int], Call], atoms: int = 1) -> Call:
        """The call bind(begin, end) in parts from 0 to count things of so many atoms each."""
        return self.job([bind(begin, end) for begin, end in (cuts(count, atoms) if self.threads > 1 else [(0, count)])])

    # ---- helpers ------------------------------------------------------------------------------------------------

    def gather(self) -> None:
        """Helpers look for work from now on."""
        if self.threads > 1 and not self._helpers:
            self._mailbox[loops.DISMISSED] = 0
            self._bells = [threading.Event() for _ in range(1, self.threads)]
            self._helpers = [threading.Thread(target=self._help, args=(bell,), daemon=True) for bell in self._bells]
            for helper in self._helpers:
                helper.start()
        for bell in self._bells:
            if not bell.is_set():
                bell.set()

    def dismiss(self) -> None:
        """Helpers end: this process may fork again, and none of them is in machine code when it ends."""
        self._mailbox[loops.DISMISSED] = 1
        for bell, helper in zip(self._bells, self._helpers, strict=True):
            bell.set()
            helper.join()
        self._bells, self._helpers = [], []

    def _help(self, bell: threading.Event) -> None:
        room = np.zeros(2, np.int64)
        given = [self._mailbox, self._parts, self.results, way() or 0, *(clock() or (0, 0)), room, _PATIENCE]
        serve = kernel(self._serve).bind(*given)
        while not self._mailbox[loops.DISMISSED]:
            serve()
            bell.clear()  # whoever rings between these two lines rings again before the next steps
            if not self._mailbox[loops.DISMISSED]:
                bell.wait()
