"""fix ID GROUP wall/morse FACE coord D0 alpha r0 cutoff ... [units lattice|box] [fld yes|no] [pbc yes|no]: Morse walls.

Its formula is in pylmp/model/wall_laws.py. Source: LAMMPS manual, fix_wall.html.
"""

from __future__ import annotations

from pylmp.model import wall_laws
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.wall import Law, Wall


@FIXES.register("wall/morse")
class WallMorse(Wall):
    style = "wall/morse"
    parameters = 3

    def law(self, sim: Simulation, parameters: list[float], cutoff: float) -> Law:
        depth, alpha, rest = parameters
        return wall_laws.morse(depth, alpha, rest, cutoff)
