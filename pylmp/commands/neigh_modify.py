"""neigh_modify every N delay N check yes|no one N page N"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args

_ELSEWHERE = ("exclude", "include", "once", "cluster", "binsize", "collection/type", "collection/interval")


@command("neigh_modify")
def neigh_modify(sim: Simulation, args: Args) -> None:
    """When neighbor lists are built anew, and how large they may become."""
    settings = sim.neighbor
    while len(args):
        key = args.word()
        if key.text in ("every", "delay", "one", "page"):
            args.need(1, key.text)
            word = args.word()
            value = args.as_integer(word)
            least = {"every": 1, "delay": 0}.get(key.text, value)
            if value < least:
                args.fail(f"Invalid neigh_modify {key.text} argument: {value}", word)
            setattr(settings, key.text, value)
        elif key.text == "check":
            args.need(1, key.text)
            settings.check = args.yes()
        elif key.text in _ELSEWHERE:
            raise Unsupported(f"LAMMPS has neigh_modify {key.text}, pylmp's native engines do not", key.span)
        else:
            args.fail(f"Unknown neigh_modify keyword: {key.text}", key, hint="every delay check one page")
