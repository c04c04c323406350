"""compute ID all pe [pair bond fix]: potential energy. Source: LAMMPS manual, compute_pe.html."""

from __future__ import annotations

from pylmp.model.asking import ENERGY
from pylmp.model.compute import Compute
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_NOTHING_HERE = ("angle", "dihedral", "improper", "kspace")


@COMPUTES.register("pe")
class PotentialEnergy(Compute):
    style = "pe"
    extensive_scalar = True
    tallies = ENERGY

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        if bit != 1:
            args.fail("Compute pe must use group all", args.owner)
        parts = []
        while len(args):
            key = args.word()
            if key.text not in ("pair", "bond", "fix", *_NOTHING_HERE):
                args.fail(f"Unknown compute pe keyword {key.text}", key, hint="pair bond fix")
            parts.append(key.text)
        self.parts = parts or ["pair", "bond", "fix"]

    def scalar(self, sim: Simulation) -> float:
        if not sim.tally.has(ENERGY, sim.step):
            raise ScriptError("Energy was not tallied on needed timestep", hint="use it on thermo steps")
        energy = 0.0
        if "pair" in self.parts:
            energy += sim.tally.pair
        if "bond" in self.parts:
            energy += sim.tally.bond
        if "pair" in self.parts and sim.pair is not None:
            energy += sim.pair.tails(sim)[0] / sim.box.volume
        if "fix" in self.parts:
            extra = 0.0
            for fix in sim.fixes:
                if fix.in_energy:
                    extra += fix.scalar(sim)  # type: ignore[attr-defined]
            energy += extra
        return energy
