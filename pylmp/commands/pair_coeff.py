"""pair_coeff I J values..."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("pair_coeff", needs_box=True)
def pair_coeff(sim: Simulation, args: Args) -> None:
    """Set coefficients for a range of type pairs."""
    if sim.pair is None:
        args.fail("Pair_coeff command without a pair style", args.owner, hint="pair_style comes first")
    args.need(2)
    args.words[:2] = [sim.labels.resolved(args, "atom", word) for word in args.words[:2]]
    sim.pair.coeff(sim, args)
