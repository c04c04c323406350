"""compute_modify ID [extra/dof N] [dynamic/dof yes|no]: how a compute counts degrees of freedom."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("compute_modify")
def compute_modify(sim: Simulation, args: Args) -> None:
    """Change the settings of a compute."""
    args.need(2)
    word = args.word()
    if word.text not in sim.computes:
        args.fail(f"Could not find compute_modify ID {word.text}", word, hint=f"computes: {' '.join(sim.computes)}")
    compute = sim.computes[word.text]
    while len(args):
        key = args.word()
        if key.text == "extra/dof":
            args.need(1, key.text)
            compute.extra_dof = args.number()
        elif key.text == "dynamic/dof":
            args.need(1, key.text)
            compute.recount = args.yes()
        else:
            text = f"Compute {compute.id} {compute.style} does not support compute_modify {key.text} command"
            args.fail(text, key, hint="extra/dof dynamic/dof")
