"""units lj|real|metal|si|cgs|electron|micro|nano"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.units import UNITS
from pylmp.text.words import Args


@command("units")
def units(sim: Simulation, args: Args) -> None:
    """Choose the unit system, and with it the default timestep and skin."""
    word = args.word()
    if len(args):
        args.illegal(args.peek())
    if sim.has_box:
        args.fail("Units command after simulation box is defined", args.owner, hint="units comes first in a script")
    if word.text not in UNITS:
        args.fail(f"Unknown units style {word.text}", word, hint=" ".join(UNITS))
    sim.units = UNITS[word.text]
    sim.dt, sim.neighbor.skin = sim.units.dt, sim.units.skin
