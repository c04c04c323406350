"""fix ID GROUP temp/rescale N Tstart Tstop window fraction: velocities are scaled when the temperature is off by more than window.

    v *= sqrt(T'/T),  T' = T - fraction (T - target)

scalar: energy taken out so far. Tstart may be an equal-style variable: the target itself. Source: LAMMPS manual,
fix_temp_rescale.html.
"""

from __future__ import annotations

import math
import struct

from pylmp.model.quantity import Quantity
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.thermostat import Thermostat
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest
from pylmp.text.words import Args


@FIXES.register("temp/rescale")
class TempRescale(Thermostat):
    style = "temp/rescale"
    extensive_scalar = True

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
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
        self._energy = 0.0
        self.measure_group(sim, group, bit)

    def end_of_step(self, sim: Simulation) -> None:
        compute = self.compute(sim)
        now, dof = compute.scalar(sim), compute.dof(sim)
        if dof < 1:
            return
        if now == 0.0:
            raise ScriptError(
                "Computed temperature for fix temp/rescale cannot be 0.0", hint="atoms at rest have no velocities to scale"
            )
        target = self.target(sim, "Fix temp/rescale variable returned negative temperature", sim.step + self.every)
        if abs(now - target) > self.window:
            target = now - self.fraction * (now - target)
            factor = math.sqrt(target / now)
            self._energy += (now - target) * (0.5 * sim.units.boltz * dof)
            self.scale(sim, self.members(sim), factor)

    def state(self, sim: Simulation) -> bytes:
        return struct.pack("<d", self._energy)

    def restore(self, sim: Simulation, state: bytes) -> None:
        (self._energy,) = struct.unpack("<d", state)

    def scalar(self, sim: Simulation) -> float:
        return self._energy
