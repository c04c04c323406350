"""pair_style STYLE settings... | none"""

from __future__ import annotations

from pylmp.model.pair import Pair, PairPart
from pylmp.model.registry import PAIRS, command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import unknown_style
from pylmp.text.words import Args


@command("pair_style")
def pair_style(sim: Simulation, args: Args) -> None:
    """Choose the pair style.

    The same style again keeps the coefficients and pair_modify settings; a global cutoff replaces every cutoff.
    """
    name = args.word()
    if name.text == "none":
        sim.pair = None
        return
    style = PAIRS.find(name.text)
    if style is None:
        unknown_style(args, name, "pair", PAIRS)
    inner = Args("pair_style", args.rest(), name, style.manual)
    options = style.settings(sim, inner)
    before = sim.pair
    part = PairPart(style, options)
    sim.pair = Pair(style.name, [part], sim.atom_types)
    if before is not None and before.name == style.name:
        (old,) = before.parts
        part.given = {pair: (values, options.get("cut", cut)) for pair, (values, cut) in old.given.items()}
        part.settings = sim.pair.settings = old.settings
        sim.pair.acting = {pair: [part] for pair in part.given}
