"""pair_modify [pair STYLE [N] [special lj|coul|lj/coul W W W]...] keywords...: what all pair styles share, or under hybrid one of them.

mix geometric|arithmetic|sixthpower, shift, tail, compute, neigh/trim yes|no, nofdotr; the table keywords are for styles with
long-range forces and change nothing here.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from pylmp.model.mixing import ARITHMETIC, GEOMETRIC, SIXTHPOWER
from pylmp.model.pair import Pair, PairPart
from pylmp.model.registry import command
from pylmp.model.settings import PairSettings
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word

_FEWEST, _MOST = 8, 32


@command("pair_modify")
def pair_modify(sim: Simulation, args: Args) -> None:
    if sim.pair is None:
        args.fail("Pair_modify command before pair_style is defined", args.owner, hint="pair_style comes first")
    args.need(1)
    settings = [sim.pair.settings, *(part.settings for part in sim.pair.parts)]
    if sim.pair.hybrid and args.take("pair"):
        part = _named(sim.pair, args)
        while args.take("special"):
            _special(part.settings, args)
        settings = [sim.pair.settings, part.settings]  # LAMMPS changes what is said of all, too
    while len(args):
        word = args.word()
        keyword = _KEYWORDS.get(word.text)
        if keyword is None:
            args.fail(f"Unknown pair_modify keyword: {word.text}", word, hint=" ".join(_KEYWORDS))
        if keyword is not _nofdotr and not len(args):
            args.fail(f"Illegal pair_modify {word.text} command: missing argument(s)", word)
        for name, value in keyword(word, args).items():
            for each in settings:
                setattr(each, name, value)


def _named(pair: Pair, args: Args) -> PairPart:
    if not len(args):
        args.illegal(hint="pair STYLE")
    word = args.word()
    same = [part for part in pair.parts if part.style.name == word.text]
    if len(same) > 1:
        number = args.integer()
        same = [part for part in same if part.number == number]
    if not same:
        hint = " ".join(dict.fromkeys(part.called for part in pair.parts))
        args.fail(f"Unknown pair_modify hybrid sub-style: {word.text}", word, hint=hint)
    return same[0]


def _special(settings: PairSettings, args: Args) -> None:
    if len(args) < 4:
        args.fail("Illegal pair_modify special command", args.words[-1], hint="special lj|coul|lj/coul W W W")
    word = args.word()
    if word.text not in ("lj", "coul", "lj/coul"):
        args.fail("Illegal pair_modify special command", word, hint="lj, coul or lj/coul")
    weights = (args.number(), args.number(), args.number())
    if word.text != "coul":
        settings.lj = weights
    if word.text != "lj":
        settings.coul = weights


def _mix(keyword: Word, args: Args) -> dict[str, Any]:
    rule = args.word()
    if rule.text not in (GEOMETRIC, ARITHMETIC, SIXTHPOWER):
        args.fail(f"Unknown pair_modify mix argument: {rule.text}", rule, hint="geometric arithmetic sixthpower")
    return {"mix": rule.text}


def _yes(name: str) -> Callable[[Word, Args], dict[str, Any]]:
    return lambda keyword, args: {name: args.yes()}


def _nofdotr(keyword: Word, args: Args) -> dict[str, Any]:
    return {"fdotr": False}


def _table(keyword: Word, args: Args) -> dict[str, Any]:
    """Bits of the index into a table of long-range forces; 0: no table."""
    word = args.word()
    bits = args.as_integer(word)
    if bits and not _FEWEST <= bits <= _MOST:
        many, kind = "many" if bits > _MOST else "few", "Dispersion" if "disp" in keyword.text else "Coulomb"
        args.fail(f"Too {many} total bits for bitmapped {kind} lookup table", word, hint=f"{_FEWEST} to {_MOST}, or 0")
    return {}


def _inner(keyword: Word, args: Args) -> dict[str, Any]:
    args.number()
    return {}


_KEYWORDS: dict[str, Callable[[Word, Args], dict[str, Any]]] = {
    "mix": _mix, "shift": _yes("shift"), "tail": _yes("tail"), "compute": _yes("compute"), "nofdotr": _nofdotr,
    "neigh/trim": _yes("trim"), "table": _table, "table/disp": _table, "tabinner": _inner, "tabinner/disp": _inner,
}  # fmt: skip
