"""variable NAME STYLE values..."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("variable")
def variable(sim: Simulation, args: Args) -> None:
    """Define or delete a variable."""
    sim.script.variables.define(args, sim.script.substitute_text, sim.script.scope)
