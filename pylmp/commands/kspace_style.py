"""kspace_style none"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import is_elsewhere, unsupported
from pylmp.text.words import Args


@command("kspace_style")
def kspace_style(sim: Simulation, args: Args) -> None:
    """No long-range solver: there is none here to choose."""
    if not len(args):
        args.missing()
    style = args.word()
    if is_elsewhere("kspace", style.text):
        raise unsupported("kspace", style)
    if style.text != "none":
        args.fail(f"Unrecognized kspace style '{style.text}'", style, hint="none")
    args.rest()
