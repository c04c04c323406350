"""echo none|screen|log|both"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args

MODES = ("none", "screen", "log", "both")


@command("echo")
def echo(sim: Simulation, args: Args) -> None:
    """Where commands are repeated as they are carried out."""
    args.expect(1, 1, "1 argument")
    word = args.word()
    if word.text not in MODES:
        args.fail(f"Unknown echo keyword: {word.text}", word, hint=" ".join(MODES))
    sim.script.echo = word.text
