"""Seconds by section of a run, as LAMMPS's table of timings names them."""

from __future__ import annotations

import time
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

SECTIONS = ("Pair", "Bond", "Neigh", "Comm", "Output", "Modify")


class Timers:
    """stamp(section) books the time since the last stamp; with full that of the processor too."""

    def __init__(self, full: bool = False) -> None:
        self.full = full
        self.clear()

    def clear(self) -> None:
        self.sections = dict.fromkeys(SECTIONS, 0.0)
        self.processor = dict.fromkeys(SECTIONS, 0.0)
        self._start = self._last = time.perf_counter()
        self._busy = time.process_time() if self.full else 0.0

    def stamp(self, section: str) -> None:
        now = time.perf_counter()
        self.sections[section] += now - self._last
        self._last = now
        if self.full:
            busy = time.process_time()
            self.processor[section] += busy - self._busy
            self._busy = busy

    def book(self, sections: Sequence[str], seconds: NDArray[np.float64]) -> None:
        """Seconds that compiled code has measured since the last stamp; sets them to 0."""
        for section, spent in zip(sections, seconds.tolist(), strict=True):
            self.sections[section] += spent
            self._last += spent
        seconds[:] = 0.0

    def total(self) -> float:
        return time.perf_counter() - self._start
