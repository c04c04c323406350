"""Line searches of min_style cg and sd: how far to go along a direction h.

Source: LAMMPS manual, min_modify.html and min_style.html; decisions and their order as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.minimize import (
    ALPHA_IS_ZERO,
    ENERGY_TOLERANCE,
    FACTORS_ARE_ZERO,
    FORCES_ARE_ZERO,
    MAX_EVALUATIONS,
    NOT_DOWNHILL,
    Minimizer,
    dot,
)

_LARGEST_STEP = 1.0  # of the direction, whatever dmax allows
_SHRINK = 0.5
_SLOPE = 0.4  # of the decrease that the slope promises
_LEAST_DECREASE = 1.0e-8  # a promised decrease below this is none
_QUADRATIC = 0.1  # how well a parabola must fit before its minimum is tried
_ZERO = 1.0e-28
_FORCE_ZERO = 0.1  # of the slope at the start
_GROWTH = 4.0
_UPHILL = 1.0e-12
_SHORTEST = 1.0e-14


class LineMinimizer(Minimizer):
    """A minimizer that searches along directions; a style defines turn.

    h, the direction, and the start of a search ride along with the atoms when they are sorted.
    """

    def begin(self) -> None:
        for name in ("h", "start"):
            self.sim.atoms.extra[_key(name)] = np.zeros((self.sim.atoms.capacity, 3))
        self.store("h")[:] = self.f

    def end(self) -> None:
        for name in [key for key in self.sim.atoms.extra if key.startswith(_key(""))]:
            del self.sim.atoms.extra[name]

    def turn(self) -> None:
        """Choose the next direction."""
        raise NotImplementedError

    def iterate(self) -> str | None:
        failed = self.search()
        if failed:
            return failed
        if self.count >= self.plan.maxeval:
            return MAX_EVALUATIONS
        stop = self.converged()
        if stop is None:
            self.turn()
        return stop

    def store(self, name: str) -> Floats:
        """(n, 3) a vector of the search, in the atoms' order."""
        array = self.sim.atoms.extra[_key(name)]
        return np.asarray(array[: self.sim.atoms.n])

    def search(self) -> str | None:
        """Go along h; energy, alpha and positions are then those reached. Why it failed, or None."""
        self.previous = self.energy
        slope = self._slope()
        if slope <= 0.0:
            return NOT_DOWNHILL
        longest = float(np.abs(self.store("h")).max())
        if longest == 0.0:
            return FORCES_ARE_ZERO
        self.store("start")[:] = self.x
        searches: dict[str, Callable[[float, float], str | None]] = {
            "quadratic": self._quadratic, "backtrack": self._backtrack, "forcezero": self._force_zero,
        }  # fmt: skip
        return searches[self.settings.line](slope, longest)

    def _slope(self) -> float:
        """Decrease of energy along h at the present place, per atom if the energy is."""
        slope = dot(self.f, self.store("h"))
        return slope / self.sim.natoms if self.sim.output.thermo.normed else slope

    def _go(self, alpha: float) -> None:
        """Evaluate at alpha along h. Atoms that were wrapped take their start along."""
        self.x[:] = self.store("start")
        if alpha > 0.0:
            self.x[:] += alpha * self.store("h")
        self.energy = self.evaluate()
        away = self.x - self.store("start")
        near = self.sim.box.minimum_image(away)
        wrapped = near != away
        self.store("start")[wrapped] = (self.x - near)[wrapped]

    def _back(self, why: str) -> str:
        self._go(0.0)
        return why

    def _backtrack(self, slope: float, longest: float) -> str | None:
        start = self.energy
        self.alpha = min(_LARGEST_STEP, self.settings.dmax / longest)
        while True:
            self._go(self.alpha)
            promised = -_SLOPE * self.alpha * slope
            change = self.energy - start
            if change <= promised:
                return None
            self.alpha *= _SHRINK
            if self.alpha <= 0.0 or promised >= -_LEAST_DECREASE:
                return self._back(ENERGY_TOLERANCE if change < 0.0 else ALPHA_IS_ZERO)

    def _quadratic(self, slope: float, longest: float) -> str | None:
        start = self.energy
        most = min(_LARGEST_STEP, self.settings.dmax / longest)
        self.alpha = most
        slope_before, energy_before, alpha_before = slope, start, 0.0
        while True:
            self._go(self.alpha)
            here = self._slope()
            bend = here - slope_before
            if abs(here) < _ZERO or abs(bend) < _ZERO:
                return self._back(FACTORS_ARE_ZERO)
            parabola = 0.5 * (self.alpha - alpha_before) * (here + slope_before) + self.energy
            misfit = abs(1.0 - parabola / energy_before) if energy_before != 0.0 else math.inf
            lowest = self.alpha - (self.alpha - alpha_before) * here / bend
            if misfit <= _QUADRATIC and 0.0 < lowest < most:
                self._go(lowest)
                if self.energy - start < _LEAST_DECREASE:
                    return None
            promised = -_SLOPE * self.alpha * slope
            if self.energy - start <= promised:
                return None
            slope_before, energy_before, alpha_before = here, self.energy, self.alpha
            self.alpha *= _SHRINK
            if self.alpha <= 0.0 or promised >= -_LEAST_DECREASE:
                return self._back(ALPHA_IS_ZERO)

    def _force_zero(self, slope: float, longest: float) -> str | None:
        start = self.energy
        most = self.settings.dmax / longest
        step = min(max(_ZERO, 0.1 * abs(start) / slope), 0.5 * most)
        self.alpha, before, energy_before = 0.0, slope, start
        while True:
            self.alpha += step
            if self.alpha > most:
                self.alpha -= step
                return None
            self._go(self.alpha)
            here = self._slope()
            back = self.energy - energy_before >= _UPHILL
            if not back and abs(here / slope) <= _FORCE_ZERO:
                return None
            if here < 0.0 or back:
                self.alpha -= step
                step *= before / (before - here) if here < 0.0 else 0.1
                self.energy = energy_before
                if longest * step <= _SHORTEST:
                    return self._back(ALPHA_IS_ZERO)
                continue
            step *= min(_GROWTH, here / (before - here) if before > here else _GROWTH)
            before, energy_before = here, self.energy


def _key(name: str) -> str:
    return f"minimize {name}"
