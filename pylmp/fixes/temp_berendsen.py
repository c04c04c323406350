"""fix ID GROUP temp/berendsen Tstart Tstop Tdamp: velocities are scaled a little in every step.

    v *= lambda,  lambda^2 = 1 + (dt/Tdamp)(target/T - 1)

scalar: energy taken out so far. Tstart may be an equal-style variable: the target itself. Source: LAMMPS manual,
fix_temp_berendsen.html.
"""

from __future__ import annotations

import math

from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.rescaling import Rescaling
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@FIXES.register("temp/berendsen")
class TempBerendsen(Rescaling):
    style = "temp/berendsen"
    at_rest = "Computed current temperature for fix temp/berendsen must not be 0.0"

    def read(self, args: Args) -> None:
        if len(args) != 3:
            word = args.words[3] if len(args) > 3 else args.words[-1] if args.words else args.owner
            args.fail(f"Illegal fix temp/berendsen command: expected 6 arguments but found {3 + len(args)}", word)
        self.start, self.stop, self.damp = Quantity.read(args), args.number(), args.number()
        if self.damp <= 0.0:
            args.fail("Fix temp/berendsen Tdamp period must be > 0.0", hint="damp is a time")

    def rescaling(self, sim: Simulation, now: float) -> tuple[float, float]:
        negative = f"Fix temp/berendsen variable {self.start.name} returned negative temperature"
        target = self.target(sim, negative, sim.step + 1)
        square = 1.0 + sim.dt / self.damp * (target / now - 1.0)
        factor = math.sqrt(square) if square >= 0.0 else math.nan
        return factor, now * (1.0 - factor * factor)
