"""compute ID all pressure TEMP-ID|NULL [ke pair bond fix virial]: pressure and its tensor.

P = (dof kB T + W_xx + W_yy + W_zz)/(d V) in pressure units. Source: LAMMPS manual, compute_pressure.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.model.asking import VIRIAL
from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.temperature import Temperature
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args

_PARTS = ("ke", "pair", "bond", "fix", "virial")
_NOTHING_HERE = ("angle", "dihedral", "improper", "kspace")


@COMPUTES.register("pressure")
class Pressure(Compute):
    style = "pressure"
    length = 6
    tallies = VIRIAL

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if bit != 1:
            args.fail("Compute pressure must use group all", args.owner)
        args.need(1)
        word = args.word()
        self.temperature = None if word.text == "NULL" else word.text
        if self.temperature is not None and self.temperature not in sim.computes:
            args.fail(f"Could not find compute pressure temperature ID {word.text}", word)
        if self.temperature is not None and not isinstance(sim.computes[self.temperature], Temperature):
            args.fail(
                f"Compute pressure temperature ID {word.text} does not compute temperature", word, hint="thermo_temp"
            )
        parts = []
        while len(args):
            key = args.word()
            if key.text == "pair/hybrid":
                raise Unsupported("LAMMPS has compute pressure pair/hybrid, pylmp's native engines do not", key.span)
            if key.text not in (*_PARTS, *_NOTHING_HERE):
                args.fail(f"Unknown compute pressure keyword {key.text}", key, hint="ke pair bond fix virial")
            parts.append(key.text)
        self.parts = parts or ["ke", "virial"]
        if "ke" in self.parts and self.temperature is None:
            args.fail("Compute pressure requires temperature ID to include kinetic energy", word)

    def init(self, sim: Simulation) -> None:
        if self.temperature is not None and self.temperature not in sim.computes:
            raise ScriptError(
                f"Could not find compute pressure temperature ID {self.temperature}", hint="uncompute took it away"
            )

    def virial(self, sim: Simulation) -> Floats:
        """(6,) xx yy zz xy xz yz of the parts asked for."""
        if not sim.tally.has(VIRIAL, sim.step):
            raise ScriptError("Virial was not tallied on needed timestep", hint="use it on thermo steps")
        result = np.zeros(6)
        for name, values in (("pair", sim.tally.pair_virial), ("bond", sim.tally.bond_virial)):
            if name in self.parts or "virial" in self.parts:
                result = result + np.array(values)
        if "fix" in self.parts or "virial" in self.parts:
            for fix in sim.fixes:
                if fix.in_virial:
                    result = result + fix.virial(sim)  # type: ignore[attr-defined]
        if sim.pair is not None and sim.pair.tail and ("pair" in self.parts or "virial" in self.parts):
            result[:3] += sim.pair.tails(sim)[1] * (1.0 / sim.box.volume)
        return result

    def _temp(self, sim: Simulation):  # type: ignore[no-untyped-def]
        return sim.computes[self.temperature] if self.temperature and "ke" in self.parts else None

    def scalar(self, sim: Simulation) -> float:
        w = self.virial(sim)
        temp = self._temp(sim)
        d = sim.dimension
        inverse = 1.0 / sim.box.volume
        if temp is None:
            total = float(w[0]) + float(w[1])
            if d == 3:
                total = total + float(w[2])
        else:
            total = temp.dof(sim) * sim.units.boltz * temp.at_step(sim, "scalar") + float(w[0]) + float(w[1])
            if d == 3:
                total = total + float(w[2])
        return total / float(d) * inverse * sim.units.nktv2p

    def vector(self, sim: Simulation) -> Floats:
        w = self.virial(sim)
        temp = self._temp(sim)
        inverse = 1.0 / sim.box.volume
        whole = w if temp is None else temp.at_step(sim, "vector") + w
        result = whole * inverse * sim.units.nktv2p
        if sim.dimension == 2:
            result[[2, 4, 5]] = 0.0
        return np.asarray(result)
