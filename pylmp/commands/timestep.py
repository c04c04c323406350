"""timestep DT"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("timestep")
def timestep(sim: Simulation, args: Args) -> None:
    """Set the size of a step in time units."""
    if len(args) != 1:
        args.illegal(args.owner)
    value = args.number()
    sim.output.clock.book(sim.step, sim.dt)
    sim.dt = value
    for fix in sim.fixes if sim.ran else []:
        fix.reset_dt(sim)
