"""dihedral_style none | zero [nocoeff]"""

from __future__ import annotations

from pylmp.commands.angle_style import choose
from pylmp.model.registry import DIHEDRALS, command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import DIHEDRAL
from pylmp.text.words import Args


@command("dihedral_style")
def dihedral_style(sim: Simulation, args: Args) -> None:
    """Choose the force style of dihedrals."""
    choose(sim, args, DIHEDRAL, DIHEDRALS)
