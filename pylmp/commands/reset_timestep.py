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
    bound = next((fix for fix in sim.fixes if fix.time_dependent), None)
    if bound is not None:
        text = f"Cannot reset timestep with time-dependent fix {bound.style} defined"
        args.fail(text, args.owner, hint=f"unfix {bound.id} first")
    sim.step = step
    sim.output.clock.book(step, sim.dt)
