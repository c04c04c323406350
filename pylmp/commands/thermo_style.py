"""thermo_style STYLE keywords..."""

from __future__ import annotations

from pylmp.model.registry import THERMOS, command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("thermo_style", needs_box=True)
def thermo_style(sim: Simulation, args: Args) -> None:
    """Choose the columns and layout of the thermo table."""
    word = args.word()
    if sim.output.thermo.modified:
        sim.console.warning("New thermo_style command, previous thermo_modify settings will be lost")
    make = THERMOS.find(word.text)
    if make is None:
        args.fail(f"Illegal thermo style {word.text}", word, hint=" ".join(THERMOS.names()))
    sim.output.thermo = make(sim, args)
