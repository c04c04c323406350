"""kspace_modify keywords...: only for long-range solvers, of which there is none here"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("kspace_modify")
def kspace_modify(sim: Simulation, args: Args) -> None:
    """Always wrong: kspace_style none has nothing to modify."""
    args.fail("KSpace style has not yet been set", args.owner, hint="there is no long-range solver here")
