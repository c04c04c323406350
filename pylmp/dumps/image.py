"""dump ID GROUP image|movie N FILE ...: LAMMPS draws pictures. Here nothing is drawn: the script runs, and one warning says so.

Source: LAMMPS manual, dump_image.html.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.dumps.base import Dump
from pylmp.model.atoms import Ints
from pylmp.model.registry import DUMPS
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word


@DUMPS.register("image", "movie")
class DumpImage(Dump):
    style = "image"

    def read(self, sim: Simulation, args: Args) -> None:
        args.rest()
        sim.console.warning(f"{args.what} draws nothing here: {self.file.name} is not written. A dump of atoms can be drawn later")

    def init(self, sim: Simulation) -> None:
        """There is no file."""

    def rows(self, sim: Simulation, known: dict[Any, Any]) -> Ints:
        return np.zeros(0, np.int64)

    def setup(self, sim: Simulation) -> None:
        """No frame is ever due."""
        self.due = sim.output.last + 1

    def write(self, sim: Simulation) -> None:
        """Nothing."""

    def setting(self, sim: Simulation, args: Args, key: Word) -> bool:
        args.rest()
        return True
