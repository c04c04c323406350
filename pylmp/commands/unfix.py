"""unfix ID"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("unfix")
def unfix(sim: Simulation, args: Args) -> None:
    """Delete a fix."""
    if len(args) != 1:
        args.illegal(args.owner)
    word = args.word()
    found = next((fix for fix in sim.fixes if fix.id == word.text), None)
    if found is None:
        args.fail(
            f"Could not find fix ID {word.text} to delete", word, hint=f"fixes: {' '.join(f.id for f in sim.fixes)}"
        )
    sim.fixes.remove(found)
    found.removed(sim)
