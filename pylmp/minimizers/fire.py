"""min_style fire: damped dynamics that turns the velocity toward the force and goes faster while it goes downhill.

    v = (1 - alpha) v + alpha |v| f/|f|,   dt and alpha change with the sign of v.f

Source: LAMMPS manual, min_style.html, min_modify.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math

import numpy as np

from pylmp.model.damped import DampedMinimizer, rowwise
from pylmp.model.minimize import UPHILL
from pylmp.model.registry import MINIMIZERS
from pylmp.model.sums import total
from pylmp.text.diagnostic import ScriptError

_ZERO = 1.0e-20
_LEAST_ALPHA = 1.0e-10
_COLUMNS = {
    "dmax": 5, "delaystep": 9, "dtgrow": 6, "dtshrink": 8, "alpha0": 6, "alphashrink": 11, "tmax": 4, "tmin": 4,
    "integrator": 14, "halfstepback": 12, "abcfire": 11,
}  # fmt: skip


@MINIMIZERS.register("fire")
class Fire(DampedMinimizer):
    style = "fire"

    def prepare(self) -> None:
        super().prepare()
        settings = self.settings
        for wrong, text in (
            (settings.tmax < settings.tmin, "tmax has to be larger than tmin"),
            (settings.dtgrow < 1.0, "dtgrow has to be larger than 1.0"),
            (settings.dtshrink > 1.0, "dtshrink has to be smaller than 1.0"),
        ):
            if wrong:
                raise ScriptError(text, hint="min_modify", manual="min_modify.html")

    def begin(self) -> None:
        settings = self.settings
        self.timestep = self.dt = self.sim.dt
        self.slowest, self.fastest = settings.tmin * self.dt, settings.tmax * self.dt
        self.mixing = settings.alpha0
        self.started = self.turned = self.sim.step
        self.uphill = 0
        self.still = True
        if settings.integrator == "leapfrog":
            self.energy = self.evaluate()
            self.v[:] = self.push(-0.5 * self.dt)

    def end(self) -> None:
        self.sim.dt = self.timestep

    def iterate(self) -> str | None:
        settings = self.settings
        downhill = self.power() > 0.0
        keep, turn = (self._faster() if downhill else (1.0, 0.0))
        if not downhill and self._uphill():
            return UPHILL
        dt = self.dt
        if not settings.abcfire:
            if self.still:
                self.energy = self.evaluate()
                dt = self.limited(dt, self.push(self.dt))
                self.v[:] = 0.0
            else:
                dt = self.limited(dt)
        self.previous = self.energy
        self._advance(dt, downhill, keep, turn)
        self.still = False
        self.sim.dt = self.dt
        settled = self.energy_settled() if self.sim.step - self.turned > settings.delaystep else None
        return settled or self.force_settled()

    def _faster(self) -> tuple[float, float]:
        """Downhill: how much of v is kept, how much of f is added; the timestep grows after a while."""
        settings = self.settings
        self.uphill = 0
        vv, ff = total(rowwise(self.v, self.v)), total(rowwise(self.f, self.f))
        length = math.sqrt(vv / ff) if ff > _ZERO else 0.0
        if settings.abcfire:
            self.mixing = max(self.mixing, _LEAST_ALPHA)
            share = 1.0 - math.pow(1.0 - self.mixing, self.sim.step - self.turned)
            keep, turn = (1.0 - self.mixing) / share, (self.mixing * length) / share
        else:
            keep, turn = 1.0 - self.mixing, self.mixing * length
        if self.sim.step - self.turned > settings.delaystep:
            self.dt = min(self.dt * settings.dtgrow, self.fastest)
            self.mixing *= settings.alphashrink
        return keep, turn

    def _uphill(self) -> bool:
        """Uphill: stop, half a step back, smaller steps. True when that happened too often in a row."""
        settings = self.settings
        self.turned = self.sim.step
        if not (self.sim.step - self.started < settings.delaystep and settings.initialdelay):
            self.mixing = settings.alpha0
            if self.dt * settings.dtshrink >= self.slowest:
                self.dt *= settings.dtshrink
        self.uphill += 1
        if self.uphill > settings.vdfmax:
            return True
        if settings.halfstepback:
            self.x[:] -= 0.5 * self.dt * self.v
        self.v[:] = 0.0
        self.still = True
        return False

    def _advance(self, dt: float, downhill: bool, keep: float, turn: float) -> None:
        """One step of the chosen integrator."""
        how = self.settings.integrator
        if how == "verlet":
            self.kick(0.5 * dt)
        elif how != "eulerexplicit":
            self.kick(dt)
        if downhill:
            self.v[:] = keep * self.v + turn * self.f
            if self.settings.abcfire:
                far = np.abs(self.v * dt) > self.settings.dmax
                self.v[far] = (self.settings.dmax / dt * self.v / np.where(far, np.abs(self.v), 1.0))[far]
        self.drift(dt)
        if how == "eulerexplicit":
            self.kick(dt)
        self.energy = self.evaluate()
        if how == "verlet":
            self.kick(0.5 * dt)

    def describe(self) -> str:
        shown = [getattr(self.settings, name) for name in _COLUMNS]
        texts = [("yes" if v else "no") if isinstance(v, bool) else v if isinstance(v, str) else f"{v:g}" for v in shown]
        rows = (list(_COLUMNS), texts)
        centered = (" ".join(f"{text:^{w}}" for text, w in zip(row, _COLUMNS.values(), strict=True)) for row in rows)
        return "  Parameters for fire:\n" + "".join(f"    {line}\n" for line in centered)
