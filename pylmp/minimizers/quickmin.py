"""min_style quickmin: damped dynamics; the velocity keeps only its part along the force. Source: LAMMPS manual, min_style.html."""

from __future__ import annotations

from pylmp.model.damped import DampedMinimizer, rowwise
from pylmp.model.registry import MINIMIZERS
from pylmp.model.sums import total

_DELAY = 5  # iterations after a turn before the energy may be called settled


@MINIMIZERS.register("quickmin")
class QuickMin(DampedMinimizer):
    style = "quickmin"

    def begin(self) -> None:
        self.turned = self.sim.step

    def iterate(self) -> str | None:
        along = self.power()
        if along < 0.0:
            self.turned = self.sim.step
            self.v[:] = 0.0
        else:
            ff = total(rowwise(self.f, self.f))
            self.v[:] = (along / ff if ff != 0.0 else 0.0) * self.f
        dt = self.limited(self.sim.dt)
        self.drift(dt)
        self.kick(dt)
        self.previous = self.energy
        self.energy = self.evaluate()
        settled = self.energy_settled() if self.sim.step - self.turned > _DELAY else None
        return settled or self.force_settled()
