"""compute ID GROUP reduce/region REGION MODE inputs...: compute reduce over the atoms that are inside the region now.

Source: LAMMPS manual, compute_reduce.html.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pylmp.computes.reduce import Reduce
from pylmp.model.region import named
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args


@COMPUTES.register("reduce/region")
class ReduceRegion(Reduce):
    style = "reduce/region"
    words_needed = 3

    def read_region(self, sim: Simulation, args: Args) -> None:
        word = args.word()
        if word.text not in sim.regions:
            args.fail(f"Region {word.text} for compute reduce/region does not exist", word, hint="region comes first")
        self.region = word.text

    def check_inputs(self, args: Args) -> None:
        if self.local_inputs:
            args.fail("Compute reduce/region cannot use local data as input", hint="compute reduce takes local values")

    def init(self, sim: Simulation) -> None:
        super().init(sim)
        named(sim, self.region, "compute reduce/region")

    def members(self, sim: Simulation) -> NDArray[np.bool_]:
        inside = named(sim, self.region, "compute reduce/region").inside(sim.atoms.x[: sim.atoms.n])
        return np.asarray(super().members(sim) & inside)
