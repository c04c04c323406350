"""bond_coeff TYPES values..."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("bond_coeff", needs_box=True)
def bond_coeff(sim: Simulation, args: Args) -> None:
    """Set coefficients for a range of bond types."""
    if sim.bond is None:
        args.fail("Bond_coeff command before bond_style is defined", args.owner, hint="bond_style comes first")
    args.need(1)
    sim.labels.translate(args, "bond")
    sim.bond.coeff(sim, args)
