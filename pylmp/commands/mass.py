"""mass TYPES VALUE"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.number import shortest
from pylmp.text.words import Args


@command("mass", needs_box=True)
def mass(sim: Simulation, args: Args) -> None:
    """Set the mass of a range of atom types."""
    args.expect(2, 2, "2 arguments")
    sim.labels.translate(args, "atom")
    sim.labels.translate(args, "atom")
    kinds = args.types(sim.atom_types)
    value = args.number()
    if value <= 0.0:
        args.fail(f"Invalid atom mass value {shortest(value)} for type {kinds.start}", hint="a positive number")
    sim.mass[kinds.start : kinds.stop] = value
