"""dump ID GROUP STYLE N FILE arguments..."""

from __future__ import annotations

from typing import Any

from pylmp.model.registry import DUMPS, command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import unknown_style
from pylmp.text.words import Args, Word


@command("dump")
def dump(sim: Simulation, args: Args) -> None:
    """Write frames of atoms or local values during runs."""
    args.need(5)
    identity, group, style, interval, path = (args.word() for _ in range(5))
    if identity.text in sim.output.dumps:
        args.fail(f"Reuse of dump ID: {identity.text}", identity, hint="another ID, or undump first")
    bit = group_bit(sim, args, group)
    every = args.as_integer(interval)
    if every <= 0:
        args.fail(f"Invalid dump frequency {interval.text}", interval, hint="a positive number of steps")
    kind = dump_style(args, style)
    inner = Args(f"dump {style.text}", args.rest(), path, args.manual)
    sim.output.dumps[identity.text] = kind(sim, identity.text, group.text, bit, every, path, inner)


def group_bit(sim: Simulation, args: Args, group: Word) -> int:
    bit = sim.groups.bit(group.text)
    if not bit:
        args.fail(f"Could not find dump group ID: {group.text}", group, hint=f"groups: {' '.join(sim.groups.names)}")
    return bit


def dump_style(args: Args, style: Word) -> Any:
    kind = DUMPS.find(style.text)
    return kind if kind is not None else unknown_style(args, style, "dump", DUMPS)
