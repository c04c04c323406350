"""region ID STYLE arguments... keywords..., region ID delete"""

from __future__ import annotations

from pylmp.model.region import read_options
from pylmp.model.registry import REGIONS, command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import unknown_style
from pylmp.text.words import Args


@command("region")
def region(sim: Simulation, args: Args) -> None:
    """Define a region of space."""
    args.need(2)
    identity, style = args.word(), args.word()
    if style.text == "delete":
        if identity.text not in sim.regions:
            args.fail(f"Delete region {identity.text} does not exist", identity)
        del sim.regions[identity.text]
        return
    if identity.text in sim.regions:
        args.fail(f"Reuse of region ID {identity.text}", identity, hint="another name, or region ID delete first")
    kind = REGIONS.find(style.text)
    if kind is None:
        unknown_style(args, style, "region", REGIONS)
    words = kind.count_words(args)
    args.need(words)
    options = read_options(sim, args, args.at + words, identity.text, kind)
    found = kind(sim, args, options, sim.spacing if options.lattice else (1.0, 1.0, 1.0))
    if options.motion:
        options.motion.check(sim)
    sim.regions[identity.text] = found
