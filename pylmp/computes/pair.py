"""compute ID all pair STYLE [N] [epair|evdwl|ecoul]: energy of one pair style, also of one of several under pair_style hybrid.

Source: LAMMPS manual, compute_pair.html.
"""

from __future__ import annotations

from pylmp.model.asking import ENERGY
from pylmp.model.compute import Compute
from pylmp.model.pair import PairPart
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args


@COMPUTES.register("pair")
class PairEnergy(Compute):
    style = "pair"
    extensive_scalar = True
    tallies = ENERGY

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        word = args.word()
        self.pair, self.number, self.part = word.text, 0, "epair"
        if (number := args.peek()) is not None and number.text.isdigit():
            self.number = args.integer()
        if len(args):
            key = args.word()
            if key.text not in ("epair", "evdwl", "ecoul"):
                args.fail(f"Unknown compute pair keyword {key.text}", key, hint="epair evdwl ecoul")
            self.part = key.text
        args.rest()  # LAMMPS takes no notice of more
        if not self._there(sim):
            args.fail(f"Unused pair style {word.text} in compute pair command", word, hint="pair_style comes first")

    def _part(self, sim: Simulation) -> PairPart | None:
        """The sub-style meant; None: all of them together, or none."""
        if sim.pair is None or not sim.pair.hybrid:
            return None
        parts = [part for part in sim.pair.parts if part.style.name == self.pair]
        found: PairPart | None = next((part for part in parts if not self.number or part.number == self.number), None)
        return found

    def _there(self, sim: Simulation) -> bool:
        return self._part(sim) is not None or (sim.pair is not None and sim.pair.name == self.pair)

    def init(self, sim: Simulation) -> None:
        if not self._there(sim):
            raise ScriptError(f"Unrecognized pair style {self.pair} in compute pair command", hint="pair_style changed")

    def scalar(self, sim: Simulation) -> float:
        if not sim.tally.has(ENERGY, sim.step):
            raise ScriptError("Energy was not tallied on needed timestep", hint="use it on thermo steps")
        part = self._part(sim)
        if self.part == "ecoul":
            return 0.0
        return float(part.energy if part is not None else sim.tally.pair)
