"""fix ID GROUP temp/berendsen Tstart Tstop Tdamp: velocities are scaled a little in every step.

    v *= lambda,  lambda^2 = 1 + (dt/Tdamp)(target/T - 1)

scalar: energy taken out so far. Tstart may be an equal-style variable: the target itself. Source: LAMMPS manual,
fix_temp_berendsen.html.
"""

from __future__ import annotations

import math
import struct

from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.thermostat import Thermostat
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@FIXES.register("temp/berendsen")
class TempBerendsen(Thermostat):
    style = "temp/berendsen"
    extensive_scalar = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args) != 3:
            word = args.words[3] if len(args) > 3 else args.words[-1] if args.words else args.owner
            args.fail(f"Illegal fix temp/berendsen command: expected 6 arguments but found {3 + len(args)}", word)
        self.start, self.stop, self.damp = Quantity.read(args), args.number(), args.number()
        if self.damp <= 0.0:
            args.fail("Fix temp/berendsen Tdamp period must be > 0.0", hint="damp is a time")
        self._energy = 0.0
        self.measure_group(sim, group, bit)

    def end_of_step(self, sim: Simulation) -> None:
        compute = self.compute(sim)
        now, dof = compute.scalar(sim), compute.dof(sim)
        if dof < 1:
            return
        if now == 0.0:
            raise ScriptError(
                "Computed current temperature for fix temp/berendsen must not be 0.0",
                hint="atoms at rest have no velocities to scale",
            )
        negative = f"Fix temp/berendsen variable {self.start.name} returned negative temperature"
        target = self.target(sim, negative, sim.step + 1)
        square = 1.0 + sim.dt / self.damp * (target / now - 1.0)
        factor = math.sqrt(square) if square >= 0.0 else math.nan
        self._energy += now * (1.0 - factor * factor) * (0.5 * sim.units.boltz * dof)
        self.scale(sim, self.members(sim), factor)

    def state(self, sim: Simulation) -> bytes:
        return struct.pack("<d", self._energy)

    def restore(self, sim: Simulation, state: bytes) -> None:
        (self._energy,) = struct.unpack("<d", state)

    def scalar(self, sim: Simulation) -> float:
        return self._energy
