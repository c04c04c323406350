"""read_dump FILE STEP x|y|z|vx|vy|vz|q|ix|iy|iz|fx|fy|fz ... [box yes|no] [timestep yes|no] [replace yes|no] [purge yes|no] [trim yes|no]
[add yes|keep|no] [label FIELD COLUMN] [scaled yes|no] [wrapped yes|no] [format native]

Source: LAMMPS manual, read_dump.html.
"""

from __future__ import annotations

from pylmp.io.dump_file import MANUAL
from pylmp.io.snapshot import Reader, find, read_request
from pylmp.model.paths import readable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@command("read_dump", needs_box=True)
def read_dump(sim: Simulation, args: Args) -> None:
    """Take positions, velocities, images, box and step from a snapshot of a dump."""
    args.need(2)
    name, step = args.word(), args.integer()
    request = read_request(sim, args, "%" in name.text)
    if request.add != "no":
        sim.console.both("Adding 'type' field to requested per-atom fields\n")
    sim.console.both("Scanning dump file ...\n")
    reader = Reader(sim, [str(readable(sim, name))], request)
    snapshot = find(reader, step)
    if snapshot is None:
        raise ScriptError("Dump file does not contain requested snapshot", name.span, manual=MANUAL)
    if request.timestep and any(dump.written_once for dump in sim.output.dumps.values()):
        args.fail("Cannot reset timestep with active dump - must undump first", args.owner, hint="undump first")
    reader.check(snapshot)
    sim.console.both("Reading snapshot from dump file ...\n")
    reader.apply(snapshot, sim.console.both)
    if request.timestep:
        sim.step = step
        sim.output.clock.book(step, sim.dt)
