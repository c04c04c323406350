"""When a dump's frames are due: every so many steps, at steps or times that a variable names, or every so much simulated time."""

from __future__ import annotations

import math

from pylmp.model.quantity import Quantity
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest

_NEAR = 1.0e-6  # of a step: times closer than this are equal


class Schedule:
    """every    steps between frames; or a variable that names the step of the next frame
    time     time between frames, or a variable that names the time of the next frame; None: it goes by steps
    first    a frame also when the first run begins
    delay    no frame before this step
    skip     no frame where this variable is not 0
    """

    def __init__(self, every: int) -> None:
        self.every: int | Quantity = every
        self.time: Quantity | None = None
        self.first = False
        self.delay = 0
        self.skip: Quantity | None = None
        self._next_time = 0.0

    @property
    def varies(self) -> bool:
        """It evaluates a variable."""
        return isinstance(self.every, Quantity) or (self.time is not None and self.time.varies)

    def check(self, sim: Simulation) -> None:
        """When a run begins: the variables exist and are equal-style. Raises ScriptError."""
        missing, invalid = "Variable name for dump {1} does not exist", "Variable for dump {1} is invalid style"
        if isinstance(self.every, Quantity):
            self.every.check(sim, "every or delta", missing=missing, invalid=invalid)
        if self.time is not None:
            self.time.check(sim, "every or delta", missing=missing, invalid=invalid)
        if self.skip is not None:
            self.skip.check(
                sim, "skip", missing="Dump skip variable {} not found", invalid="Variable {} for dump skip is invalid style"
            )

    def starts(self, sim: Simulation, last: int) -> bool:
        """Is a frame due where a run begins? last: the step of the last frame, below 0 before any."""
        if self.first and last < 0:
            return True
        if self.time is not None:
            if self.time.varies:
                return False
            rest, near = math.fmod(sim.output.time(), self.time.value), _NEAR * sim.dt
            return rest < near or self.time.value - rest < near
        return isinstance(self.every, int) and sim.step % self.every == 0 and last != sim.step

    def skips(self, sim: Simulation) -> bool:
        """A frame that is due now is left out."""
        return sim.step < self.delay or (self.skip is not None and self.skip.number(sim) != 0.0)

    def following(self, sim: Simulation, identity: str, started: bool) -> int:
        """The step of the next frame; started: a run begins, else a frame was due now."""
        if self.time is not None:
            return self._in_time(sim, self.time, started)
        if isinstance(self.every, int):
            return (sim.step // self.every + 1) * self.every
        step = int(self.every.number(sim))
        if step <= sim.step:
            raise ScriptError(
                f"Dump {identity} every variable {self.every.name} returned a bad timestep: {step}", hint=f"above {sim.step}"
            )
        return step

    def _in_time(self, sim: Simulation, interval: Quantity, started: bool) -> int:
        now, dt = sim.output.time(), sim.dt
        if interval.varies:
            wanted = interval.number(sim)
            if wanted <= now:
                raise ScriptError("Dump every/time variable returned a bad time", hint=f"above {shortest(now)}")
        elif started:
            wanted = int(now / interval.value) * interval.value + interval.value
        else:
            wanted = self._next_time + interval.value
        step = self._reached(sim, wanted)
        if step <= sim.step:
            if interval.varies:
                raise ScriptError("Dump every/time variable too small for next timestep", hint=f"a step is {shortest(dt)}")
            later = now + dt
            wanted += (int((later - wanted) / interval.value) + 1) * interval.value
            step = self._reached(sim, wanted)
        self._next_time = wanted
        return step

    @staticmethod
    def _reached(sim: Simulation, time: float) -> int:
        """The first step at which time is reached."""
        return sim.step + int((time - sim.output.time() - _NEAR * sim.dt) / sim.dt) + 1
