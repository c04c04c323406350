"""angle_style none | zero [nocoeff]"""

from __future__ import annotations

from typing import Any

from pylmp.model.many_body import ManyBody
from pylmp.model.registry import ANGLES, Registry, command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import ANGLE, Kind
from pylmp.model.unknown import unknown_style
from pylmp.text.words import Args


@command("angle_style")
def angle_style(sim: Simulation, args: Args) -> None:
    """Choose the force style of angles."""
    choose(sim, args, ANGLE, ANGLES)


def choose(sim: Simulation, args: Args, kind: Kind, styles: Registry[Any]) -> None:
    """What the commands of three kinds do alike. Coefficients are forgotten, also when the same style is named again."""
    what = kind.name
    if not len(args):
        args.illegal(args.owner, hint=f"{what}_style none or zero")
    name = args.word()
    if kind not in sim.style.kinds:
        says = f"{what.capitalize()}_style command when no {kind.plural} allowed"
        args.fail(says, args.owner, hint=f"atom_style {'angle or ' if what == 'angle' else ''}molecular, before the box")
    if name.text == "none":
        args.rest()
        setattr(sim, what, None)
        return
    style = styles.find(name.text)
    if style is None:
        if name.text == "hybrid" and not len(args):
            args.fail(f"Illegal {what}_style hybrid command: missing argument(s)", name)
        unknown_style(args, name, what, styles)
    takes = style.parse(Args(args.what, args.rest(), name, style.manual))
    setattr(sim, what, ManyBody(kind, style, takes, kind.types(sim)))
