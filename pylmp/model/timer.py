"""How much the log says about time, and how long runs may take. Source: LAMMPS manual, timer.html."""

from __future__ import annotations

import time
from dataclasses import dataclass

STYLES = ("off", "loop", "normal", "full")


@dataclass
class Timer:
    """style: off, loop, normal or full: what the log says after a run. sync: LAMMPS would make processes wait for each other.

    limit    seconds that all runs together may take from now on, None: no limit; looked at every so many steps
    passed   the limit is over, or a fix asked for the end: runs stop and further ones are skipped, until a new limit is set
    """

    style: str = "normal"
    sync: bool = False
    limit: float | None = None
    every: int = 10
    passed: bool = False
    started: float = 0.0

    def set_limit(self, seconds: float | None) -> None:
        self.limit, self.started = seconds, time.monotonic()
        self.passed = seconds == 0.0

    @property
    def left(self) -> float:
        """Seconds until the limit; 0 without one."""
        return 0.0 if self.limit is None else max(0.0, self.limit - (time.monotonic() - self.started))

    def stops(self, step: int) -> bool:
        """Must a run stop at this step?"""
        if self.limit is not None and step % self.every == 0 and self.left == 0.0:
            self.passed = True
        return self.passed

    @property
    def notice(self) -> str:
        """What the set-up of a run says of the limit."""
        if self.limit is None:
            return ""
        left = self.left
        return f"  Walltime left : {int(left) // 3600}:{int(left) // 60 % 60:02d}:{left % 60:05.2f}\n"

    def __str__(self) -> str:
        """As LAMMPS states it."""
        return f"style={self.style}  mode={'sync' if self.sync else 'nosync'}  timeout={self._limit()}"

    def _limit(self) -> str:
        if self.limit is None:
            return "off"
        whole = int(self.limit)
        return f"{whole // 3600:02d}:{whole // 60 % 60:02d}:{whole % 60:02d}"
