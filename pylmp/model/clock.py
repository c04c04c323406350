"""Simulated time: the sum of all steps taken, each with the step size of its run."""

from __future__ import annotations


class Clock:
    """LAMMPS's rule: time = (time booked last) + (steps since) * dt; where the step number was set back, time restarts at 0.

    It is booked when a run ends and when the step number or dt changes. What a restart file of the middle of a run did not book is
    lost when the next run begins.
    """

    def __init__(self) -> None:
        self._time = 0.0
        self._step = 0

    @property
    def booked(self) -> tuple[int, float]:
        """The step at which time was booked last, and that time."""
        return self._step, self._time

    def now(self, step: int, dt: float) -> float:
        """Time at step; dt is the step size in force."""
        return self._time + (step - self._step) * dt if step >= self._step else 0.0

    def book(self, step: int, dt: float) -> None:
        """Remember the time at step."""
        self._time = self.now(step, dt)
        self._step = step

    def begin(self, step: int) -> None:
        """A run begins at step."""
        self._step = step

    def set(self, step: int, time: float) -> None:
        """What a restart file, or reset_timestep's keyword time, says."""
        self._step, self._time = step, time
