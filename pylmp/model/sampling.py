"""What fixes that average over time share: which steps they sample, and how averages are averaged."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


@dataclass
class Schedule:
    """Nevery Nrepeat Nfreq: values of the steps Nfreq - k*Nevery, k < Nrepeat, count for the multiple Nfreq.

    due     the next step that is sampled
    taken   samples of the current average
    """

    every: int
    repeat: int
    period: int
    start: int = 0
    due: int = -1
    taken: int = 0

    @classmethod
    def read(cls, args: Args) -> Schedule:
        """Take the three numbers. Raises ScriptError."""
        words = [args.word() for _ in range(3)]
        schedule = cls(*(args.as_integer(word) for word in words))
        for name, word in zip(("nevery", "nrepeat", "nfreq"), words, strict=True):
            if args.as_integer(word) <= 0:
                args.fail(f"Illegal {args.what} {name} value: {word.text}", word, hint="a positive number")
        if schedule.period % schedule.every or schedule.repeat * schedule.every > schedule.period:
            args.fail(
                f"Inconsistent {args.what} nevery/nrepeat/nfreq values", words[0],
                hint="Nfreq is a multiple of Nevery, and not below Nrepeat*Nevery",
            )  # fmt: skip
        return schedule

    def first(self, step: int) -> int:
        """The first step from step on at which a sample is due."""
        due = step // self.period * self.period + self.period
        while due < self.start:
            due += self.period
        if due - self.period == step and self.repeat == 1:
            return step
        due -= (self.repeat - 1) * self.every
        return due if due >= step else due + self.period

    def begin(self, sim: Simulation) -> None:
        """Start anew from the current step."""
        self.taken = 0
        self.due = self.first(sim.step)
        sim.asking.everyone(self.due)

    def resume(self, sim: Simulation) -> None:
        """A run begins; steps may have gone by without it."""
        if self.due < sim.step:
            self.begin(sim)

    def following(self) -> int:
        """The due step after the current one, which was due."""
        if self.taken + 1 < self.repeat:
            return self.due + self.every
        return self.due + self.period - (self.repeat - 1) * self.every

    def advance(self) -> bool:
        """A sample was taken; True if the average is complete."""
        self.due = self.following()
        self.taken = (self.taken + 1) % self.repeat
        return self.taken == 0


@dataclass
class Average:
    """ave one, running or window M over arrays of one shape.

    off     (columns,) bool: these show the last value
    total   sum of what counts; count: how many; 0 before the first value
    """

    mode: str = "one"
    window: int = 0
    off: Floats = field(default_factory=lambda: np.zeros(0, bool))
    total: Floats = field(default_factory=lambda: np.zeros(0))
    count: int = 0
    _kept: deque[Floats] = field(default_factory=deque)

    def read(self, args: Args) -> None:
        """The words after the keyword ave."""
        args.need(1, "ave")
        mode = args.word()
        if mode.text not in ("one", "running", "window"):
            args.fail(f"Unknown {args.what} ave keyword {mode.text}", mode, hint="one, running or window")
        self.mode = mode.text
        if self.mode == "window":
            args.need(1, "ave window")
            self.window = args.integer()
            if self.window <= 0:
                args.fail(f"Illegal {args.what} ave window argument {self.window}; must be > 0", hint="how many averages")

    def add(self, value: Floats) -> None:
        """One more average; its last axis runs over columns."""
        if self.mode == "one" or self.total.shape != value.shape:
            self.total, self.count = np.zeros(value.shape), 0
            self._kept.clear()
        self.total = self.total + value
        self.count += 1
        if self.mode == "window":
            self._kept.append(value)
            if self.count > self.window:
                self.total = self.total - self._kept.popleft()
                self.count = self.window
        if self.off.any():
            self.total[..., self.off] = self.count * value[..., self.off]

    @property
    def value(self) -> Floats:
        return self.total / self.count if self.count else self.total
