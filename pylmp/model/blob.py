"""What a restart file holds of a bond or pair style. The style says so itself, in its own file."""

from __future__ import annotations

from dataclasses import dataclass, replace

# How a setting is stored: as a double, an int, an int that is 1 for yes, an int that is 0 for yes, the code of a mixing rule.
MODIFIED = ("mix", "shift", "tail")  # settings that pair_modify changes
NUMBER, INTEGER, FLAG, UNLESS, MIXING = "number", "integer", "flag", "unless", "mixing"


@dataclass(frozen=True)
class Blob:
    """What LAMMPS writes of a style, in its order.

    settings   (name, kind) of each number that stands first; a name is one of the style's options, or one of MODIFIED
    coeffs     names of the coefficients that follow, for each type or pair of types ("cut" is a pair's cutoff)
    kept       the coefficients are in the file; if not, a script must give them again
    alone      names of settings that stand there only for a style of its own: hybrid does not store them
    defaults   options that are not in the file, or not always
    degrees    coefficients that a script gives in degrees and a file in radians
    name       the style's name in files, where that is another one
    """

    settings: tuple[tuple[str, str], ...] = ()
    coeffs: tuple[str, ...] = ()
    kept: bool = True
    alone: tuple[str, ...] = ()
    defaults: tuple[tuple[str, object], ...] = ()
    degrees: tuple[str, ...] = ()
    name: str = ""

    @property
    def in_hybrid(self) -> Blob:
        """What hybrid stores of it: settings, never coefficients."""
        return replace(self, settings=tuple(s for s in self.settings if s[0] not in self.alone), kept=False)
