"""pair_style STYLE settings... | none | hybrid STYLE settings... STYLE settings... | hybrid/overlay ..."""

from __future__ import annotations

from pylmp.model.pair import Pair, PairPart
from pylmp.model.registry import PAIRS, command
from pylmp.model.simulation import Simulation
from pylmp.model.style import PairStyle
from pylmp.model.unknown import unknown_style
from pylmp.text.words import Args, Word

_HYBRID = ("hybrid", "hybrid/overlay")


@command("pair_style")
def pair_style(sim: Simulation, args: Args) -> None:
    """Choose the pair style.

    The same style again keeps pair_modify settings and, unless it has tables, the coefficients; a global cutoff replaces every
    cutoff. Hybrid keeps only what pair_modify said of all styles.
    """
    name = args.word()
    if name.text == "none":
        sim.pair = None
        return
    before = sim.pair if sim.pair is not None and sim.pair.name == name.text else None
    if name.text in _HYBRID:
        sim.pair = Pair(name.text, _hybrid(sim, args), sim.atom_types)
        if before is not None:
            sim.pair.settings = before.settings
        return
    part = _part(sim, args, name, args.rest(), "pair_style")
    sim.pair = Pair(part.style.name, [part], sim.atom_types)
    if before is not None:
        (old,) = before.parts
        part.settings = sim.pair.settings = old.settings
        sim.pair.born = before.born
        if part.style.data is None:
            part.given = {pair: (values, part.options.get("cut", cut)) for pair, (values, cut) in old.given.items()}
            sim.pair.acting = {pair: [part] for pair in part.given}


def _part(sim: Simulation, args: Args, name: Word, words: list[Word], called: str) -> PairPart:
    style: PairStyle | None = PAIRS.find(name.text)
    if style is None:
        unknown_style(args, name, "pair", PAIRS)
    return PairPart(style, style.settings(sim, Args(called, words, name, style.manual)))


def _hybrid(sim: Simulation, args: Args) -> list[PairPart]:
    """Words up to the next style name belong to the style before. Several parts of one style are numbered."""
    if not len(args):
        args.fail(
            f"Illegal pair_style {args.words[0].text} command: missing argument(s)", args.words[0],
            hint="pair_style hybrid STYLE settings STYLE settings",
        )  # fmt: skip
    parts: list[PairPart] = []
    while len(args):
        name = args.word()
        if name.text == "none" or name.text.startswith("hybrid"):
            kind = "none" if name.text == "none" else "hybrid"
            args.fail(f"Pair style hybrid cannot have {kind} as a sub-style", name)
        words = []
        while (word := args.peek()) is not None and PAIRS.find(word.text) is None and not word.text.startswith("hybrid"):
            words.append(args.word())
        parts.append(_part(sim, args, name, words, "pair_style"))
    for part in parts:
        same = [other for other in parts if other.style is part.style]
        part.number = same.index(part) + 1 if len(same) > 1 else 0
    return parts
