"""newton on|off, or newton PAIR BOND"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("newton")
def newton(sim: Simulation, args: Args) -> None:
    """Newton's third law between processes: here, whether a pair with a ghost is computed once or at both ends."""
    if not 1 <= len(args) <= 2:
        args.illegal(args.owner)
    pair = args.yes()
    bond = args.yes() if len(args) else pair
    if sim.has_box and bond != sim.newton_bond:
        args.fail(
            "Newton bond change after simulation box is defined", args.owner, hint="newton comes before the box"
        )
    sim.newton_pair, sim.newton_bond = pair, bond
