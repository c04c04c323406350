"""thermo_style yaml: YAML, for scripts that read logs."""

from __future__ import annotations

from pylmp.model.registry import THERMOS
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args, Word
from pylmp.thermo.table import Thermo

_COLUMNS = "step temp ke pe ebond eangle edihed eimp evdwl ecoul elong press"


@THERMOS.register("yaml")
def yaml(sim: Simulation, args: Args) -> Thermo:
    return Thermo(sim, "yaml", [Word(name) for name in _COLUMNS.split()], args)
