"""compute ID GROUP temp: temperature, and the kinetic energy tensor.

T = sum(m v^2) / (dof kB), dof = dimension*N - dimension; after read_restart of a file in two dimensions the default compute still
subtracts the three of the time of its definition, as in LAMMPS. Source: LAMMPS manual, compute_temp.html.
"""

from __future__ import annotations

from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.temperature import Temperature
from pylmp.text.words import Args


@COMPUTES.register("temp")
class Temp(Temperature):
    style = "temp"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if len(args):
            args.illegal(args.peek())
