"""compute ID GROUP STYLE arguments..."""

from __future__ import annotations

import re

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
    kind = COMPUTES.find(style.text)
    if kind is None:
        unknown_style(args, style, "compute", COMPUTES)
    if not re.fullmatch(r"\w+", identity.text, re.ASCII):
        args.fail(f"Compute ID {identity.text} must only have alphanumeric or underscore characters", identity)
    bit = sim.groups.bit(group.text)
    if not bit:
        args.fail(
            f"Group ID {group.text} requested by compute {style.text} does not exist", group,
            hint=f"groups: {' '.join(sim.groups.names)}",
        )  # fmt: skip
    inner = Args(f"compute {style.text}", args.rest(), style, f"compute_{style.text.replace('/', '_')}.html")
    new = sim.computes[identity.text] = kind(sim, identity.text, group.text, bit, inner)
    if sim.waiting is not None:
        sim.waiting.offer(sim, new, new.store, "STORE/GLOBAL", "STORE/ATOM")
