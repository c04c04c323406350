"""Seconds by section of a run, as LAMMPS's table of timings names them."""

from __future__ import annotations

import time

SECTIONS = ("Pair", "Bond", "Neigh", "Comm", "Output", "Modify")


class Timers:
    """stamp(section) books the time since the last stamp."""

    def __init__(self) -> None:
        self.sections = dict.fromkeys(SECTIONS, 0.0)
        self._start = self._last = time.perf_counter()

    def clear(self) -> None:
        self.sections = dict.fromkeys(SECTIONS, 0.0)
        self._start = self._last = time.perf_counter()

    def stamp(self, section: str) -> None:
        now = time.perf_counter()
        self.sections[section] += now - self._last
        self._last = now

    def total(self) -> float:
        return time.perf_counter() - self._start
