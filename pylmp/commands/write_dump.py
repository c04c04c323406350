"""write_dump GROUP STYLE FILE arguments... [modify KEYWORD VALUE...]"""

from __future__ import annotations

from pylmp.commands.dump import dump_style, group_bit
from pylmp.dumps.settings import modify
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@command("write_dump", needs_box=True)
def write_dump(sim: Simulation, args: Args) -> None:
    """Write one frame of the current state."""
    args.need(3)
    group, style, path = (args.word() for _ in range(3))
    words = args.rest()
    texts = [word.text for word in words]
    at = texts.index("modify") if "modify" in texts else len(words)
    if at == len(words) - 1:
        args.fail("Illegal dump_modify command: missing argument(s)", words[-1])
    bit = group_bit(sim, args, group)
    kind = dump_style(args, style)
    inner = Args(f"dump {style.text}", words[:at], path, args.manual)
    dump = kind(sim, "WRITE_DUMP", group.text, bit, max(sim.step, 1), path, inner)
    modify(dump, sim, Args("dump_modify", words[at + 1 :], style, "dump_modify.html"))
    if not sim.ran:
        sim.console.warning("Calling write_dump before a full system init")
    dump.init(sim)
    dump.write(sim)
    dump.close()
