"""min_modify keyword value ..."""

from __future__ import annotations

from collections.abc import Callable

from pylmp.model.minimize import MinSettings
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word

_CHOICES = {
    "line": ("backtrack", "quadratic", "forcezero"),
    "norm": ("two", "inf", "max"),
    "integrator": ("eulerimplicit", "eulerexplicit", "leapfrog", "verlet"),
}
_KINDS = {name: type(getattr(MinSettings(), name)) for name in MinSettings.__annotations__ if name != "style"}


@command("min_modify", needs_box=True)
def min_modify(sim: Simulation, args: Args) -> None:
    """Change the settings of the min style in force."""
    args.need(1)
    settings = sim.minimizing
    while len(args):
        key = args.word()
        if key.text not in _KINDS:
            args.fail("Illegal fix_modify command", key, hint=" ".join(_KINDS))  # LAMMPS names the wrong command
        args.need(1, key.text)
        setattr(settings, key.text, _value(args, key))


def _value(args: Args, key: Word) -> object:
    if key.text in _CHOICES:
        word = args.word()
        if word.text not in _CHOICES[key.text]:
            args.illegal(word, hint=" ".join(_CHOICES[key.text]))
        return word.text
    readers: dict[type, Callable[[], object]] = {bool: args.yes, int: args.integer, float: args.number}
    return readers[_KINDS[key.text]]()
