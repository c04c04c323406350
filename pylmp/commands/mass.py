"""mass TYPES VALUE"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("mass", needs_box=True)
def mass(sim: Simulation, args: Args) -> None:
    """Set the mass of a range of atom types."""
    if len(args) != 2:
        args.illegal(args.owner, hint="mass TYPES VALUE")
    kinds = args.types(sim.atom_types)
    value = args.number()
    if value <= 0.0:
        args.fail("Invalid mass value", hint="a positive number")
    sim.mass[kinds.start : kinds.stop] = value
