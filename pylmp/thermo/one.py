"""thermo_style one: one line a step."""

from __future__ import annotations

from pylmp.model.registry import THERMOS
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word
from pylmp.thermo.table import Thermo

_COLUMNS = "step temp epair emol etotal press"


@THERMOS.register("one")
def one(sim: Simulation, args: Args) -> Thermo:
    return Thermo(sim, "one", [Word(name) for name in _COLUMNS.split()], args)
