"""A number that a script may also give as a variable: 1.5, v_pull, NULL."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.variables import EQUAL_STYLES, Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


@dataclass
class Quantity:
    """value: the number, times scale; name: of the variable that gives it instead, "" for none. NULL is neither (absent).

    per_atom    the variable is atom-style; known once check was called
    """

    value: float = 0.0
    name: str = ""
    scale: float = 1.0
    absent: bool = False
    per_atom: bool = False

    @classmethod
    def read(cls, args: Args, *, scale: float = 1.0, null: bool = False) -> Quantity:
        """Take the next word: a number, v_NAME, or NULL where that may stand."""
        word = args.word()
        if word.text.startswith("v_"):
            return cls(name=word.text[2:], scale=scale)
        if null and word.text == "NULL":
            return cls(absent=True)
        return cls(scale * args.as_number(word), scale=scale)

    @property
    def varies(self) -> bool:
        return bool(self.name)

    def check(
        self, sim: Simulation, owner: str, *, atoms: bool = False, missing: str = "Variable {} for {} does not exist",
        invalid: str = "Variable {} for {} is invalid style",
    ) -> None:  # fmt: skip
        """At the start of a run: the variable exists and is equal-style (atom-style too, where atoms).

        owner is what LAMMPS's sentences name, e.g. "fix setforce". Raises ScriptError.
        """
        if not self.name:
            return
        style = Variables(sim).style(self.name)
        if style is None:
            raise ScriptError(missing.format(self.name, owner), hint=f"variable {self.name} equal ...")
        self.per_atom = atoms and style in ("atom", "atomfile")
        if not self.per_atom and style not in EQUAL_STYLES:
            kinds = "equal or atom" if atoms else "equal"
            raise ScriptError(invalid.format(self.name, owner), hint=f"an {kinds}-style variable")

    def number(self, sim: Simulation) -> float:
        """Its value now, of one number."""
        return self.scale * Variables(sim).number(self.name) if self.name else self.value

    def numbers(self, sim: Simulation, group: NDArray[np.bool_] | None = None) -> Floats | float:
        """Its value now: (n,) for each owned atom if the variable is atom-style, else one number.

        group: (n,) the atoms it is evaluated for; 0 for the others.
        """
        if self.per_atom and group is not None:
            values = np.zeros(sim.atoms.n)
            values[group] = self.scale * Variables(sim).per_atom(self.name, np.flatnonzero(group))
            return values
        if self.per_atom:
            return np.asarray(self.scale * Variables(sim).per_atom(self.name))
        return self.number(sim)
