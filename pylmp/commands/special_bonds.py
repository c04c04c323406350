"""special_bonds amber|charmm|dreiding|fene|lj a b c|coul a b c|lj/coul a b c, angle yes|no, dihedral yes|no"""

from __future__ import annotations

from pylmp.model.registry import command
from pylmp.model.settings import SpecialSettings
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.text.words import Args

Weights = tuple[float, float, float]
_NONE: Weights = (0.0, 0.0, 0.0)
_PRESETS: dict[str, tuple[Weights, Weights]] = {
    "amber": ((0.0, 0.0, 0.5), (0.0, 0.0, 5.0 / 6.0)),
    "charmm": (_NONE, _NONE),
    "dreiding": ((0.0, 0.0, 1.0), (0.0, 0.0, 1.0)),
    "fene": ((0.0, 1.0, 1.0), (0.0, 1.0, 1.0)),
}


@command("special_bonds")
def special_bonds(sim: Simulation, args: Args) -> None:
    """Weights of pair interactions between bonded neighbors. Every call starts again from all weights 0."""
    if not len(args):
        args.illegal(args.owner, hint="lj/coul W12 W13 W14")
    before, new = sim.special, SpecialSettings()
    flagged = False
    while len(args):
        key = args.word()
        if key.text in _PRESETS:
            new.lj, new.coul = _PRESETS[key.text]
        elif key.text in ("lj", "coul", "lj/coul"):
            weights = _weights(args)
            if "lj" in key.text:
                new.lj = weights
            if "coul" in key.text:
                new.coul = weights
        elif key.text in ("angle", "dihedral"):
            if not len(args):
                args.illegal(key)
            setattr(new, key.text, args.yes())
            flagged = True
        elif key.text == "one/five":
            if not len(args):
                args.illegal(key)
            if args.yes() and sim.atom_style != "atomic":
                args.fail("Cannot set special_bonds one/five if atom style does not support it", key)
        else:
            args.illegal(key, hint="lj coul lj/coul fene amber charmm dreiding angle dihedral")
    sim.special = new
    changed = before.lj[1:] != new.lj[1:] or before.coul[1:] != new.coul[1:]
    changed = changed or flagged or before.angle != new.angle or before.dihedral != new.dihedral
    if changed and sim.has_box and sim.has_bonds:
        build_special(sim)


def _weights(args: Args) -> Weights:
    if len(args) < 3:
        args.illegal(args.words[-1], hint="three weights: 1-2, 1-3, 1-4")
    values = []
    for _ in range(3):
        word = args.word()
        value = args.as_number(word)
        if not 0.0 <= value <= 1.0:
            args.illegal(word, hint="weights are from 0 to 1")
        values.append(value)
    return values[0], values[1], values[2]
