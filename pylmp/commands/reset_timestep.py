"""reset_timestep N [time T]"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("reset_timestep", needs_box=True)
def reset_timestep(sim: Simulation, args: Args) -> None:
    """Set the current step number, and the simulated time. Of further words only a first "time T" counts, as in LAMMPS."""
    if not len(args):
        args.missing()
    word = args.word()
    step = args.as_integer(word, 64)
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
    if len(args):
        key = args.word()
        if key.text != "time":
            args.fail(f"Unknown reset_timestep option {key.text}", key, hint="time")
        if not len(args):
            args.fail("Illegal reset_timestep time command: missing argument(s)", key, hint="the time at this step")
        sim.output.clock.set(step, args.number())
        args.rest()
