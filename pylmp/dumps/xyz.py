"""dump ID GROUP xyz N FILE: the XYZ format: the number of atoms, a comment, then a name and coordinates a line; sorted by ID.

Names are type numbers, or what dump_modify element says. Source: LAMMPS manual, dump.html.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.dumps.attributes import ATTRIBUTES
from pylmp.dumps.base import Dump
from pylmp.dumps.frame import NAME, Field
from pylmp.model.atoms import Ints
from pylmp.model.registry import DUMPS
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word


@DUMPS.register("xyz", "xyz/gz")
class DumpXYZ(Dump):
    style = "xyz"
    verbatim = True

    def read(self, sim: Simulation, args: Args) -> None:
        if len(args):
            args.fail("Illegal dump xyz command", args.peek(), hint="dump ID GROUP xyz N FILE; custom takes attributes")
        self.names = [str(kind) for kind in range(1, sim.atom_types + 1)]
        self.sort = "id"
        name = Field("name", lambda sim, rows, known: known["names"][sim.atoms.type[rows]], NAME)
        self.fields = [name, *(ATTRIBUTES[axis] for axis in "xyz")]
        self.keys = [ATTRIBUTES[name] for name in ("id", "type", "x", "y", "z")]

    def rows(self, sim: Simulation, known: dict[Any, Any]) -> Ints:
        known["names"] = np.array(["", *self.names], dtype=object)
        return np.flatnonzero((sim.atoms.mask[: sim.atoms.n] & self.bit) != 0)

    def head(self, sim: Simulation, count: int) -> str:
        time = f" Time: {sim.output.time():f}" if self.time else ""
        return f"{count}\n Atoms. Timestep: {sim.step}{time}\n"

    def column(self, word: Word) -> int | None:
        return None

    def setting(self, sim: Simulation, args: Args, key: Word) -> bool:
        if key.text == "element":
            if len(args) < sim.atom_types:
                args.fail(
                    "Dump modify element names do not match number of atom types", args.words[-1], hint=f"{sim.atom_types} names"
                )
            self.names = [args.word().text for _ in range(sim.atom_types)]
        elif key.text == "types":
            word = args.word()
            if word.text == "labels":
                args.fail("Label map must be defined when using 'types labels'", word, hint="types numeric")
            if word.text != "numeric":
                args.fail(f"Unknown option {word.text} for dump_modify 'types' keyword", word, hint="numeric")
            self.names = [str(kind) for kind in range(1, sim.atom_types + 1)]
        else:
            return False
        return True

    def format_kind(self, args: Args, what: Word) -> None:
        """This style knows formats of whole lines only."""
        args.fail(f"Unknown dump_modify format keyword: {what.text}", what, hint="format line or format none")
