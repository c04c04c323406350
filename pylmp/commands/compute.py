"""compute ID GROUP STYLE arguments..."""

from __future__ import annotations

from pylmp.model.registry import COMPUTES, command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import unknown_style
from pylmp.text.words import Args


@command("compute", needs_box=True)
def compute(sim: Simulation, args: Args) -> None:
    """Define a compute."""
    args.need(3)
    identity, group, style = args.word(), args.word(), args.word()
    if identity.text in sim.computes:
        args.fail(f"Reuse of compute ID '{identity.text}'", identity, hint="another ID, or uncompute first")
    bit = sim.groups.bit(group.text)
    if not bit:
        args.fail(f"Could not find compute group ID {group.text}", group, hint=f"groups: {' '.join(sim.groups.names)}")
    kind = COMPUTES.find(style.text)
    if kind is None:
        unknown_style(args, style, "compute", COMPUTES)
    inner = Args(f"compute {style.text}", args.rest(), style, f"compute_{style.text.replace('/', '_')}.html")
    sim.computes[identity.text] = kind(sim, identity.text, group.text, bit, inner)
