"""min_style cg|sd|fire|quickmin"""

from __future__ import annotations

from pylmp.model.minimize import MinSettings
from pylmp.model.registry import MINIMIZERS, command
from pylmp.model.simulation import Simulation
from pylmp.model.unknown import is_elsewhere, unsupported
from pylmp.text.words import Args


@command("min_style", needs_box=True)
def min_style(sim: Simulation, args: Args) -> None:
    """Choose how minimize goes downhill; min_modify's settings begin anew."""
    args.need(1)
    word = args.word()
    if MINIMIZERS.find(word.text) is None:
        if is_elsewhere("minimize", word.text):
            raise unsupported("minimize", word)
        args.fail(f"Unknown minimize style {word.text}", word, hint=" ".join(MINIMIZERS.names()))
    sim.minimizing = MinSettings(style=word.text)
