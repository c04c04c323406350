"""angle_coeff TYPES values..."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import ANGLE, Kind
from pylmp.text.words import Args


@command("angle_coeff", needs_box=True)
def angle_coeff(sim: Simulation, args: Args) -> None:
    """Set coefficients for a range of angle types."""
    set_coefficients(sim, args, ANGLE)


def set_coefficients(sim: Simulation, args: Args, kind: Kind) -> None:
    """What the commands of three kinds do alike."""
    what, style = kind.name, kind.style(sim)
    if style is None:
        args.fail(f"{what.capitalize()}_coeff command before {what}_style is defined", args.owner, hint=f"{what}_style zero")
    args.need(1)
    sim.labels.translate(args, what)
    style.coeff(sim, args)
