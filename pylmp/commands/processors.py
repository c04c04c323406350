"""processors Px Py Pz [grid STYLE...] [map ORDER] [file NAME] ..."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word

_GRIDS = ("onelevel", "twolevel", "numa", "custom")
_ORDERS = ("cart", "cart/reorder", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx")


@command("processors")
def processors(sim: Simulation, args: Args) -> None:
    """Accepted where one process fits, without effect: there is one process."""
    if sim.has_box:
        args.fail("Processors command after simulation box is defined", args.owner, hint="it comes before the box")
    if len(args) < 3:
        args.illegal(args.owner, hint="processors Px Py Pz, each a number or *")
    counts = [_count(args, args.word()) for _ in range(3)]
    while len(args):
        key = args.word()
        if not len(args):
            args.illegal(key)
        value = args.word()
        known = {"grid": _GRIDS, "map": _ORDERS, "file": (value.text,), "numa_nodes": (value.text,)}
        if key.text == "part":
            args.fail("Cannot use processors part command without using partitions", key, hint="there is one partition")
        if value.text not in known.get(key.text, ()):
            args.illegal(value, hint="grid onelevel, map xyz, file NAME")
        if key.text == "grid" and value.text in ("twolevel", "custom"):
            args.rest()
    if any(count > 1 for count in counts):
        args.fail("Specified processors != physical processors", args.words[0], hint="processors * * *: there is one process")
    sim.console.note("processors changes nothing: pylmp runs in one process")


def _count(args: Args, word: Word) -> int:
    count = 0 if word.text == "*" else args.as_integer(word)
    if count < 0:
        args.illegal(word)
    return count
