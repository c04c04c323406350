"""fix ID GROUP wall/lj93 FACE coord eps sigma cutoff ... [units lattice|box] [fld yes|no] [pbc yes|no]: the walls of a half space of Lennard-Jones atoms (9-3).

Its formula is in pylmp/model/wall_laws.py. Source: LAMMPS manual, fix_wall.html.
"""

from __future__ import annotations

from pylmp.model import wall_laws
from pylmp.model.registry import FIXES
from pylmp.model.simulation import Simulation
from pylmp.model.wall import Law, Wall


@FIXES.register("wall/lj93")
class WallLJ93(Wall):
    style = "wall/lj93"

    def law(self, sim: Simulation, parameters: list[float], cutoff: float) -> Law:
        eps, sigma = parameters
        return wall_laws.lj93(eps, sigma, cutoff)
