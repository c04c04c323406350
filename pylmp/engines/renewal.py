"""New neighbor lists while the rows stay what they are: compiled calls in a row, which Python need not watch."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.engines.fast_list import Step
from pylmp.kernels.fast.renewal import renew
from pylmp.kernels.kinds import Function
from pylmp.kernels.store import entry, kernel
from pylmp.model.lost import looks_for_bonded

if TYPE_CHECKING:
    from pylmp.engines.fast import FastRun

Call = Callable[[], float]
_NEVER = np.iinfo(np.int64).max


class Renewal:
    """Lists built anew by one call, where all that a rebuild does is: wrap, list, remember where the atoms stood.

    call      returns 0.0 when it did so, else a rebuild in full must follow (which may begin from whatever it left); None: not in this scene
    until     the step on which a rebuild sorts the atoms: from there on it must not be called
    """

    def __init__(self) -> None:
        self.call: Call | None = None
        self.until = _NEVER
        self._steps: list[Step] = []
        self._renew: Function = renew

    def bind(self, run: FastRun) -> None:
        """After a rebuild in full: its kernels, bound as that left them."""
        sim = run.sim
        self.until = run.sorter.next if run.sorts else _NEVER
        if sim.box.changing or run.hooks["pre_exchange"] or looks_for_bonded(sim) or not sim.atoms.n:
            self.forget()
            return
        steps = run.forces.renewal(sim)
        if self.call is None or steps != self._steps:
            self._steps = steps
            calls = np.array([entry(call) for call, _, _ in steps], np.int64).ravel()
            results = np.array([between for _, *between in steps]).ravel()
            self.call = kernel(self._renew).bind(calls, results, len(steps))

    def forget(self) -> None:
        """The next rebuild is one in full."""
        self.call = None

    def go(self, step: int) -> bool:
        """New lists, if they are to be had this way at step."""
        return self.call is not None and step < self.until and self.call() == 0.0
