"""fix ID GROUP STYLE arguments..."""

from __future__ import annotations

import re

from pylmp.model.registry import FIXES, command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import unknown_style
from pylmp.text.words import Args


@command("fix", needs_box=True)
def fix(sim: Simulation, args: Args) -> None:
    """Define a fix. An ID may be used again with the same style and group: the new one takes the old one's place."""
    args.need(3)
    identity, group, style = args.word(), args.word(), args.word()
    if not re.fullmatch(r"\w+", identity.text, re.ASCII):
        args.fail("Fix ID must be alphanumeric or underscore characters", identity)
    bit = sim.groups.bit(group.text)
    if not bit:
        args.fail(f"Could not find fix group ID {group.text}", group, hint=f"groups: {' '.join(sim.groups.names)}")
    kind = FIXES.find(style.text)
    if kind is None:
        unknown_style(args, style, "fix", FIXES)
    place = next((k for k, other in enumerate(sim.fixes) if other.id == identity.text), None)
    if place is not None and sim.fixes[place].style != style.text:
        args.fail("Replacing a fix, but new style != old style", style, hint=f"unfix {identity.text} first")
    inner = Args(f"fix {style.text}", args.rest(), style, f"fix_{style.text.replace('/', '_')}.html")
    if place is not None:
        sim.fixes[place].removed(sim)
    new = kind(sim, identity.text, group.text, bit, inner)
    if place is None:
        sim.fixes.append(new)
    else:
        if sim.fixes[place].group != group.text:
            sim.console.warning("Replacing a fix, but new group != old group")
        new.born = sim.fixes[place].born
        sim.fixes[place] = new
    if sim.waiting is not None:
        sim.waiting.offer(sim, new, new.id, new.style, new.style)
