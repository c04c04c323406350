"""fix ID GROUP temp/rescale N Tstart Tstop window fraction: velocities are scaled when the temperature is off by more than window.

    v *= sqrt(T'/T),  T' = T - fraction (T - target)

scalar: energy taken out so far. Tstart may be an equal-style variable: the target itself. Source: LAMMPS manual,
fix_temp_rescale.html.
"""

from __future__ import annotations

import math

from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.rescaling import Rescaling
from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest
from pylmp.text.words import Args


@FIXES.register("temp/rescale")
class TempRescale(Rescaling):
    style = "temp/rescale"
    at_rest = "Computed temperature for fix temp/rescale cannot be 0.0"

    def read(self, args: Args) -> None:
        args.need(5)
        self.every = self.compatible_every = args.integer()
        if self.every <= 0:
            args.fail(f"Invalid fix temp/rescale every argument: {self.every}", hint="every so many steps")
        self.start, self.stop = Quantity.read(args), args.number()
        if self.stop < 0.0:
            args.fail(f"Invalid fix temp/rescale Tstop argument: {shortest(self.stop)}")
        self.window = args.number()
        if self.window < 0.0:
            args.fail(f"Invalid fix temp/rescale window argument: {shortest(self.window)}")
        self.fraction = args.number()
        if self.fraction <= 0.0:
            args.fail(f"Invalid fix temp/rescale fraction argument: {shortest(self.fraction)}", hint="0 to 1")

    def rescaling(self, sim: Simulation, now: float) -> tuple[float, float] | None:
        target = self.target(sim, "Fix temp/rescale variable returned negative temperature", sim.step + self.every)
        if not abs(now - target) > self.window:
            return None
        target = now - self.fraction * (now - target)
        return math.sqrt(target / now), now - target
