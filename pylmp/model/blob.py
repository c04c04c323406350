"""What a restart file holds of a bond or pair style. The style says so itself, in its own file."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

# How a setting is stored: as a double, an int, an int that is 1 for yes, an int that is 0 for yes, the code of a mixing rule.
MODIFIED = ("mix", "shift", "tail")  # settings that pair_modify changes
NUMBER, INTEGER, FLAG, UNLESS, MIXING = "number", "integer", "flag", "unless", "mixing"
Numbers = Sequence[float]


@dataclass(frozen=True)
class Blob:
    """What LAMMPS writes of a style, in its order.

    settings   (name, kind) of each number that stands first; a name is one of the style's options, or one of MODIFIED
    coeffs     names of the coefficients that follow, for each type or pair of types ("cut" is a pair's cutoff)
    kept       the coefficients are in the file; if not, a script must give them again
    alone      names of settings that stand there only for a style of its own: hybrid does not store them
    defaults   options that are not in the file, or not always
    pack       a type's coefficients -> the numbers that are stored; unpack: back again
    name       the style's name in files, where that is another one
    """

    settings: tuple[tuple[str, str], ...] = ()
    coeffs: tuple[str, ...] = ()
    kept: bool = True
    alone: tuple[str, ...] = ()
    defaults: tuple[tuple[str, object], ...] = ()
    pack: Callable[[Numbers], Numbers] = tuple
    unpack: Callable[[Numbers], Numbers] = tuple
    name: str = ""

    @property
    def in_hybrid(self) -> Blob:
        """What hybrid stores of it: settings, never coefficients."""
        return replace(self, settings=tuple(s for s in self.settings if s[0] not in self.alone), kept=False)


def nearest(guess: float, wanted: float, function: Callable[[float], float]) -> float:
    """The number next to guess of which function makes wanted, to the last bit; guess itself if there is none."""
    for steps in range(4):
        for toward in (-math.inf, math.inf):
            value = guess
            for _ in range(steps):
                value = math.nextafter(value, toward)
            if function(value) == wanted:
                return value
    return guess
