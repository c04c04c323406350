"""dielectric CONSTANT"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("dielectric")
def dielectric(sim: Simulation, args: Args) -> None:
    """Accepted, without effect: no style here has Coulomb forces."""
    if len(args) != 1:
        args.illegal(args.owner, hint="dielectric CONSTANT")
    args.number()
    sim.console.note("dielectric changes nothing: no style here has Coulomb forces")
