"""thermo_style multi: a block a step."""

from __future__ import annotations

from pylmp.model.registry import THERMOS
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word
from pylmp.thermo.table import Thermo

_COLUMNS = "etotal ke temp pe ebond eangle edihed eimp evdwl ecoul elong press"


@THERMOS.register("multi")
def multi(sim: Simulation, args: Args) -> Thermo:
    return Thermo(sim, "multi", [Word(name) for name in _COLUMNS.split()], args)
