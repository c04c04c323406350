"""reset_timestep N"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("reset_timestep", needs_box=True)
def reset_timestep(sim: Simulation, args: Args) -> None:
    """Set the current step number."""
    args.need(1)
    word = args.word()
    if len(args):
        args.illegal(args.peek())
    step = args.as_integer(word)
    if step < 0:
        args.fail("Timestep must be >= 0", word)
    if any(dump.written_once for dump in sim.output.dumps.values()):
        args.fail("Cannot reset timestep with active dump - must undump first", args.owner, hint="undump first")
    if any(fix.changes_box for fix in sim.fixes):
        args.fail("Cannot reset timestep with a time-dependent fix defined", args.owner, hint="unfix first")
    sim.step = step
