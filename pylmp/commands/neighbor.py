"""neighbor SKIN bin|nsq"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.number import shortest
from pylmp.text.words import Args


@command("neighbor")
def neighbor(sim: Simulation, args: Args) -> None:
    """Set the skin: how far beyond the cutoff pairs are listed."""
    if len(args) != 2:
        args.fail(f"Illegal neighbor command: expected 2 arguments but found {len(args)}", args.owner)
    word, style = args.word(), args.word()
    skin = args.as_number(word)
    if skin < 0.0:
        args.fail(f"Invalid neighbor argument: {shortest(skin)}", word, hint="zero or more")
    if style.text in ("multi", "multi/old"):
        raise Unsupported(f"LAMMPS has neighbor {style.text}, pylmp's native engines do not", style.span, hint="bin")
    if style.text not in ("bin", "nsq"):
        args.fail(f"Unknown neighbor {shortest(skin)} argument: {style.text}", style, hint="bin or nsq")
    sim.neighbor.skin, sim.neighbor.style = skin, style.text
