"""fix ID GROUP wall/lj1043 FACE coord eps sigma cutoff ... [units lattice|box] [fld yes|no] [pbc yes|no]: Lennard-Jones walls (10-4-3), a layer of atoms on a half space.

Its formula is in pylmp/model/wall_laws.py. Source: LAMMPS manual, fix_wall.html.
"""

from __future__ import annotations

from pylmp.model import wall_laws
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.wall import Law, Wall


@FIXES.register("wall/lj1043")
class WallLJ1043(Wall):
    style = "wall/lj1043"
    reach_inclusive = passable = True

    def law(self, sim: Simulation, parameters: list[float], cutoff: float) -> Law:
        eps, sigma = parameters
        return wall_laws.lj1043(eps, sigma, cutoff)
