"""Many steps at once, where Python has nothing to do in them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.kernels.fast import driver
from pylmp.kernels.kinds import Function
from pylmp.kernels.machine import clock
from pylmp.kernels.store import entry, kernel
from pylmp.model.fix import STEP_HOOKS

if TYPE_CHECKING:
    from pylmp.engines.fast import FastRun

_ATOM_STEPS = 1_000_000  # of one leap: an interrupt is heard within a fraction of a second
_ELSEWHERE = {"pre_exchange", "post_neighbor", "post_run"}  # hooks that Python calls between leaps
_SECTIONS = ("Modify", "Neigh", "Pair")


class Leap:
    """Goes from one event to the next: output, tallies, new lists, broken bonds, the end of the run.

    It takes all fixes to say what they do in bound kernels (Fix.calls); with timer full or timeout steps are counted one by one.
    """

    def __init__(self) -> None:
        self._plan = np.zeros(driver.PLAN, np.int64)
        self._times, self._room = np.zeros(3), np.zeros(2, np.int64)
        self._bound: list[Callable[[], float]] = []  # what the driver calls
        self._call: Callable[[], float] | None = None
        self._able: bool | None = None
        self._pauses: list[int] = []  # on multiples of these a fix does more than call kernels
        self._drive: Function = driver.drive

    def forget(self) -> None:
        """Kernels may have been bound anew."""
        self._able = None

    def go(self, run: FastRun, end: int) -> bool:
        """Advance to the step before the next event, or into the step end; False: there is nothing to leap over."""
        sim = run.sim
        if not (self._able if self._able is not None else self._bind(run)):
            return False
        events = [sim.output.due_step, *sim.asking.steps, *(fix.next_rebuild for fix in sim.fixes)]
        events += [(sim.step // every + 1) * every for every in self._pauses]
        steps = min([end + 1, *(at for at in events if at > sim.step)]) - 1 - sim.step
        if steps <= 0:
            return False
        steps = min(steps, max(1, sim.team.threads * _ATOM_STEPS // max(1, sim.atoms.n)))
        self._leap(run, steps)
        return True

    def _leap(self, run: FastRun, steps: int) -> None:
        sim, plan, settings = run.sim, self._plan, run.sim.neighbor
        checks = driver.NEVER if settings.once else driver.IF_MOVED if settings.check else driver.ALWAYS
        plan[driver.EVERY], plan[driver.DELAY], plan[driver.REBUILDS] = settings.every, settings.delay, checks
        plan[driver.STEPS], plan[driver.STAGE] = steps, driver.START
        run.forces.may_break()
        last = sim.step + steps
        sim.ticks[0] = sim.step
        sim.team.gather()
        while True:
            plan[driver.AGO], plan[driver.DANGEROUS], plan[driver.BUILDS] = run.ago, run.dangerous, 0
            plan[driver.QUIET] = max(last + 1 - run.renewal.until, 0) if run.renewal.call else steps
            assert self._call is not None
            why = self._call()
            run.timers.book(_SECTIONS, self._times)
            if plan[driver.BUILDS]:
                run.renewed(int(plan[driver.BUILDS]))
            run.ago, run.dangerous = int(plan[driver.AGO]), int(plan[driver.DANGEROUS])
            if why == driver.DONE:
                sim.step = last
                return
            sim.step = last + 1 - int(plan[driver.STEPS])
            if why == driver.BOOK:
                run.forces.book(sim, int(plan[driver.BROKEN]))
                run.timers.stamp("Pair")
            else:
                run.timers.stamp("Neigh")
                run._rebuild(setup=False)
                self._bind(run)

    def _bind(self, run: FastRun) -> bool:
        """Find out what the hooks of the run call, and where that is."""
        sim = run.sim
        first: list[Callable[[], float]] = []
        behind: list[Callable[[], float]] = []
        self._pauses = []
        self._able = bool(clock()) and sim.timer.limit is None and not run.timers.full and not sim.timer.passed
        for name in STEP_HOOKS:
            for hook in run.hooks[name] if name not in _ELSEWHERE else ():
                fix = hook.__self__
                calls = fix.calls(sim, name)
                if calls is None and (pause := fix.every if name == "end_of_step" else fix.pause) > 1:
                    self._pauses.append(pause)
                    continue
                if calls is None or (calls and name in ("pre_force", "end_of_step")):
                    self._able = False
                    return False
                (behind if name in ("post_force", "final_integrate") else first).extend(calls)
        if (quiet := run.forces.quiet()) is None:
            self._able = False
            return False
        bound = [*first, *quiet, *behind, *([run.renewal.call] if run.renewal.call else [])]
        if len(bound) != len(self._bound) or any(a is not b for a, b in zip(bound, self._bound, strict=True)):
            self._bound = bound
            self._plan[driver.FIRST], self._plan[driver.LAST] = len(first), len(behind)
            self._plan[driver.CLOCK], self._plan[driver.NUMBER] = clock() or (0, 0)
            table = np.array([entry(call) for call in bound], np.int64).ravel()
            self._call = kernel(self._drive).bind(self._plan, table, self._times, self._room, sim.ticks)
        return self._able
