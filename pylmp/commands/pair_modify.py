"""pair_modify shift yes|no mix geometric|arithmetic|sixthpower tail yes|no"""

from __future__ import annotations

from pylmp.model.mixing import ARITHMETIC, GEOMETRIC, SIXTHPOWER
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_ELSEWHERE = ("pair", "special", "table", "table/disp", "tabinner", "tabinner/disp", "compute", "nofdotr", "neigh/trim")


@command("pair_modify")
def pair_modify(sim: Simulation, args: Args) -> None:
    """Energy shift at the cutoff, mixing rule, tail corrections."""
    if sim.pair is None:
        args.fail("Pair_modify command before pair_style is defined", args.owner, hint="pair_style comes first")
    args.need(1)
    while len(args):
        word = args.word()
        if word.text == "mix":
            _need(args, word)
            rule = args.word()
            if rule.text not in (GEOMETRIC, ARITHMETIC, SIXTHPOWER):
                args.fail(
                    f"Unknown pair_modify mix argument: {rule.text}", rule, hint="geometric arithmetic sixthpower"
                )
            sim.pair.settings.mix = rule.text
        elif word.text == "shift":
            _need(args, word)
            sim.pair.settings.shift = args.yes()
        elif word.text == "tail":
            _need(args, word)
            sim.pair.settings.tail = args.yes()
        elif word.text in _ELSEWHERE:
            raise Unsupported(f"LAMMPS has pair_modify {word.text}, pylmp's native engines do not", word.span)
        else:
            args.fail(f"Unknown pair_modify keyword: {word.text}", word, hint="mix shift tail")


def _need(args: Args, keyword: Word) -> None:
    if not len(args):
        args.fail(f"Illegal pair_modify {keyword.text} command: missing argument(s)", keyword)
