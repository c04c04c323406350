"""jump FILE|SELF [LABEL]"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("jump")
def jump(sim: Simulation, args: Args) -> None:
    """Go on in a file, from its start or from a label."""
    args.expect(1, 2, "1 or 2 argument(s)")
    file = args.word()
    label = args.word() if len(args) else None
    span = (label or file).span
    sim.script.jump(file.text, label.text if label else None, span)
