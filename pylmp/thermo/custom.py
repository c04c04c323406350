"""thermo_style custom KEYWORDS: the columns a script asks for, one line a step."""

from __future__ import annotations

from pylmp.model.registry import THERMOS
from pylmp.model.simulation import Simulation
from pylmp.text.words import Args
from pylmp.thermo.table import Thermo


@THERMOS.register("custom")
def custom(sim: Simulation, args: Args) -> Thermo:
    if not len(args):
        args.fail("Illegal thermo style custom command", hint="thermo_style custom step temp ...")
    table = Thermo(sim, "one", args.rest(), args)
    table.custom = True
    return table
