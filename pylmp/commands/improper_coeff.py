"""improper_coeff TYPES values..."""

from __future__ import annotations

from pylmp.commands.angle_coeff import set_coefficients
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import IMPROPER
from pylmp.text.words import Args


@command("improper_coeff", needs_box=True)
def improper_coeff(sim: Simulation, args: Args) -> None:
    """Set coefficients for a range of improper types."""
    set_coefficients(sim, args, IMPROPER)
