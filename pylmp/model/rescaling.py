"""What fixes share that keep a temperature by multiplying velocities, and count the energy that this takes out."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING

from pylmp.model.thermostat import Thermostat
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


class Rescaling(Thermostat):
    """A style reads its words (read) and says how much it scales (rescaling).

    at_rest   what LAMMPS says where the temperature is 0
    """

    extensive_scalar = True
    at_rest = ""

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self._energy = 0.0
        self.read(args)
        self.measure_group(sim, group, bit)

    def read(self, args: Args) -> None:
        raise NotImplementedError

    def rescaling(self, sim: Simulation, now: float) -> tuple[float, float] | None:
        """(factor of velocities, by how much the temperature falls); None: not in this step."""
        raise NotImplementedError

    def end_of_step(self, sim: Simulation) -> None:
        compute = self.compute(sim)
        now, dof = compute.scalar(sim), compute.dof(sim)
        if dof < 1:
            return
        if now == 0.0:
            raise ScriptError(self.at_rest, hint="atoms at rest have no velocities to scale")
        found = self.rescaling(sim, now)
        if found is not None:
            factor, fall = found
            self._energy += fall * (0.5 * sim.units.boltz * dof)
            self.scale(sim, self.members(sim), factor)

    def state(self, sim: Simulation) -> bytes:
        return struct.pack("<d", self._energy)

    def restore(self, sim: Simulation, state: bytes) -> None:
        (self._energy,) = struct.unpack("<d", state)

    def scalar(self, sim: Simulation) -> float:
        return self._energy
