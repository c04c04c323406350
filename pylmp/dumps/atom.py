"""dump ID GROUP atom N FILE: id, type and coordinates of every atom, scaled by the box unless dump_modify scale no.

Source: LAMMPS manual, dump.html.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.dumps.attributes import ATTRIBUTES
from pylmp.dumps.base import Dump
from pylmp.model.atoms import Ints
from pylmp.model.registry import DUMPS
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word


@DUMPS.register("atom", "atom/gz")
class DumpAtom(Dump):
    style = "atom"
    verbatim = True

    def read(self, sim: Simulation, args: Args) -> None:
        if len(args):
            args.fail(
                "Illegal dump atom command", args.peek(), hint="dump ID GROUP atom N FILE; custom takes attributes"
            )
        self.scale, self.image = True, False
        self._choose()

    def _choose(self) -> None:
        names = ["id", "type", *(("xs", "ys", "zs") if self.scale else ("x", "y", "z"))]
        names += ["ix", "iy", "iz"] if self.image else []
        self.fields = [ATTRIBUTES[name] for name in names]

    def rows(self, sim: Simulation, known: dict[Any, Any]) -> Ints:
        return np.flatnonzero((sim.atoms.mask[: sim.atoms.n] & self.bit) != 0)

    def setting(self, sim: Simulation, args: Args, key: Word) -> bool:
        if key.text not in ("scale", "image"):
            return False
        if not len(args):
            args.illegal(key, hint=f"{key.text} yes or {key.text} no")
        setattr(self, key.text, args.yes())
        self._choose()
        return True

    def format_kind(self, args: Args, what: Word) -> None:
        """This style knows formats of whole lines only."""
        args.fail(f"Unknown dump_modify format keyword: {what.text}", what, hint="format line or format none")
