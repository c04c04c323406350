"""neigh_modify every N delay N check yes|no once yes|no one N page N binsize D exclude ... include GROUP cluster no

exclude type I J, group G1 G2, molecule/intra G, molecule/inter G, none. Source: LAMMPS manual, neigh_modify.html.
"""

from __future__ import annotations

from pylmp.model.exclusions import Exclusions
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_NUMBERS = {"every": 1, "delay": 0, "one": None, "page": None}  # and the least they may be
_KEYWORDS = "every delay check once one page binsize exclude"


@command("neigh_modify")
def neigh_modify(sim: Simulation, args: Args) -> None:
    """When neighbor lists are built anew, how large they may become, and which pairs they leave out."""
    settings = sim.neighbor
    while len(args):
        key = args.word()
        if key.text in _NUMBERS:
            args.need(1, key.text)
            word = args.word()
            value, least = args.as_integer(word), _NUMBERS[key.text]
            if least is not None and value < least:
                args.fail(f"Invalid neigh_modify {key.text} argument: {value}", word)
            setattr(settings, key.text, value)
        elif key.text in ("check", "once"):
            args.need(1, key.text)
            setattr(settings, key.text, args.yes())
        elif key.text == "binsize":
            args.need(1, key.text)
            settings.bin_size = max(args.number(), 0.0)
        elif key.text == "exclude":
            args.need(1, key.text)
            _exclude(sim, args, settings.exclude)
        elif key.text == "include":
            args.need(1, key.text)
            _include(sim, args)
        elif key.text == "cluster":
            args.need(1, key.text)
            if args.yes():
                raise Unsupported("LAMMPS has neigh_modify cluster yes, pylmp's native engines do not", key.span)
        elif key.text in ("collection/type", "collection/interval"):
            args.fail(
                f"Cannot use {key.text} command without multi setting", key, hint="neighbor multi is LAMMPS's only"
            )
        else:
            args.fail(f"Unknown neigh_modify keyword: {key.text}", key, hint=_KEYWORDS)


def _exclude(sim: Simulation, args: Args, known: Exclusions) -> None:
    kind = args.word()
    what = kind.text
    if what == "none":
        sim.neighbor.exclude = Exclusions()
        return
    counts = {"type": 2, "group": 2, "molecule/intra": 1, "molecule/inter": 1}
    if what not in counts:
        args.fail(
            f"Unknown neigh_modify exclude keyword: {what}", kind, hint="type group molecule/intra molecule/inter none"
        )
    args.need(counts[what], f"exclude {what.split('/')[0]}")
    if what == "type":
        known.types.append((args.integer(), args.integer()))
    elif what == "group":
        known.groups.append(
            (
                _group(sim, args, args.word(), "exclude group keyword: "),
                _group(sim, args, args.word(), "exclude group keyword: "),
            )
        )
    else:
        if not sim.has_bonds:
            args.fail("Neigh_modify exclude molecule requires atom attribute molecule", kind)
        bit = _group(sim, args, args.word(), "exclude keyword:")
        (known.intra if what == "molecule/intra" else known.inter).append(bit)


def _group(sim: Simulation, args: Args, word: Word, what: str) -> int:
    bit = sim.groups.bit(word.text)
    if not bit:
        args.fail(f"Invalid {what}group {word.text} not found", word)
    return bit


def _include(sim: Simulation, args: Args) -> None:
    """It needs atom_modify first, which pylmp lacks."""
    word = args.word()
    _group(sim, args, word, "include keyword: ")
    args.fail("Invalid include keyword: atom_modify first command must be used", word)
