"""special_bonds keywords...: how strongly bonded neighbors interact through the pair style."""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.settings import SpecialSettings
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.text.words import Args, Word

Weights = tuple[float, float, float]
_NAMED: dict[str, tuple[Weights, Weights]] = {
    "amber": ((0.0, 0.0, 0.5), (0.0, 0.0, 5.0 / 6.0)),
    "charmm": ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
    "dreiding": ((0.0, 0.0, 1.0), (0.0, 0.0, 1.0)),
    "fene": ((0.0, 1.0, 1.0), (0.0, 1.0, 1.0)),
}
_HINT = "amber charmm dreiding fene, lj|coul|lj/coul W W W, angle|dihedral yes|no"


@command("special_bonds")
def special_bonds(sim: Simulation, args: Args) -> None:
    """Set the weights of 1-2, 1-3, 1-4 pairs. What is not named goes back to 0 and no, as in LAMMPS."""
    if not len(args):
        args.illegal(args.owner, hint=_HINT)
    new = SpecialSettings()
    while len(args):
        _keyword(sim, args, new)
    old, sim.special = sim.special, new
    changed = old.lj[1:] != new.lj[1:] or old.coul[1:] != new.coul[1:]
    changed = changed or (old.angle, old.dihedral) != (new.angle, new.dihedral)
    if changed and sim.has_box and sim.has_bonds:
        build_special(sim)


def _keyword(sim: Simulation, args: Args, new: SpecialSettings) -> None:
    key = args.word()
    if key.text in _NAMED:
        new.lj, new.coul = _NAMED[key.text]
    elif key.text in ("lj", "coul", "lj/coul"):
        weights = _weights(args)
        if key.text != "coul":
            new.lj = weights
        if key.text != "lj":
            new.coul = weights
    elif key.text in ("angle", "dihedral"):
        _present(args)
        setattr(new, key.text, args.yes())
    elif key.text == "one/five":
        _present(args)
        word = args.word()
        if word.text == "yes":
            args.fail("Cannot set special_bonds one/five if atom style does not support it", word, hint="one/five no")
        if word.text != "no":
            args.illegal(word, hint="yes or no")
    else:
        args.illegal(key, hint=_HINT)


def _present(args: Args) -> None:
    if not len(args):
        args.illegal(hint="yes or no")


def _weights(args: Args) -> Weights:
    if len(args) < 3:
        args.illegal(args.words[-1], hint="three weights: of 1-2, 1-3 and 1-4 pairs")
    a, b, c = (_weight(args, args.word()) for _ in range(3))
    return a, b, c


def _weight(args: Args, word: Word) -> float:
    value = args.as_number(word)
    if not 0.0 <= value <= 1.0:
        args.illegal(word, hint="a weight is between 0 and 1")
    return value
