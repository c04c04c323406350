"""improper_style none | zero [nocoeff]"""

from __future__ import annotations

from pylmp.commands.angle_style import choose
from pylmp.model.registry import IMPROPERS, command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import IMPROPER
from pylmp.text.words import Args


@command("improper_style")
def improper_style(sim: Simulation, args: Args) -> None:
    """Choose the force style of impropers."""
    choose(sim, args, IMPROPER, IMPROPERS)
