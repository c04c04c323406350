"""What fixes that set a temperature share: the compute they read, and a target that ramps over the run or is a variable."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.fix import Fix
from pylmp.model.quantity import Quantity
from pylmp.model.registry import COMPUTES
from pylmp.model.temperature import Temperature
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


def ramp(sim: Simulation, start: float, stop: float) -> float:
    """start at the first step of the run (or its keyword start), stop at the last."""
    part = 0.0 if sim.step == sim.begin else (sim.step - sim.begin) / (sim.end - sim.begin)
    return start + part * (stop - start)


class Thermostat(Fix):
    """A fix that keeps a temperature. It makes the compute ID_temp of its group; fix_modify temp names another.

    start stop    the target at both ends of a run; a variable start is the target itself
    temperature   ID of the compute it reads, "" if it needs none
    own           it made that compute
    unknown       what LAMMPS says when fix_modify names no compute
    per_atom      the target may be an atom-style variable
    """

    couples = True
    temperature = ""
    own = False
    per_atom = False
    unknown = "Could not find fix_modify temperature compute {}"
    start: Quantity
    stop: float

    def measure_group(self, sim: Simulation, group: str, bit: int) -> None:
        """Make the compute ID_temp."""
        self.temperature = f"{self.id}_temp"
        self.own = True
        kind = COMPUTES.find("temp")
        assert kind is not None
        sim.computes[self.temperature] = kind(sim, self.temperature, group, bit, Args("compute temp", []))

    def removed(self, sim: Simulation) -> None:
        self._release(sim)

    def _release(self, sim: Simulation) -> None:
        """The compute it made goes."""
        if self.own:
            sim.computes.pop(self.temperature, None)

    def modify(self, sim: Simulation, args: Args, key: Word) -> bool:
        """fix_modify temp COMPUTE-ID."""
        if key.text != "temp":
            return super().modify(sim, args, key)
        word = args.word()
        self._release(sim)
        self.own = False
        self.temperature = word.text
        found: Any = sim.computes.get(word.text)
        if found is None:
            args.fail(self.unknown.format(word.text), word)
        if not isinstance(found, Temperature):
            args.fail(f"Fix_modify temperature compute {word.text} does not compute temperature", word, hint="compute temp")
        self.warn_group(sim, found)
        return True

    def warn_group(self, sim: Simulation, found: Any) -> None:
        """The compute is of another group than the fix."""
        if found.bit != self.bit:
            sim.console.warning(f"Group for fix_modify temp != fix group: {self.group} vs {found.group}")

    def init(self, sim: Simulation) -> None:
        self.start.check(sim, f"fix {self.style}", atoms=self.per_atom, missing="Variable name {} for {} does not exist")
        if self.temperature:
            self.compute(sim)

    def compute(self, sim: Simulation) -> Any:
        """The compute it reads. Raises ScriptError if it was deleted."""
        found = sim.computes.get(self.temperature)
        if found is None:
            raise ScriptError(
                f"Temperature compute ID {self.temperature} for fix {self.style} does not exist", hint="uncompute took it away"
            )
        return found

    def target(self, sim: Simulation, negative: str, following: int) -> float:
        """What the temperature should be now; negative is what LAMMPS says of a variable below zero."""
        if not self.start.varies:
            return ramp(sim, self.start.value, self.stop)
        with self.reading(sim, following):
            value = self.start.number(sim)
        if value < 0.0:
            raise ScriptError(negative, hint=f"v_{self.start.name} is {value:g}")
        return value

    def thermal(self, sim: Simulation, rows: NDArray[np.bool_]) -> Floats:
        """(k, 3) velocities of the chosen atoms without that drift. As in LAMMPS, taking it out and putting it back may cost v a bit."""
        compute = self.compute(sim)
        kept = compute.remove_bias(sim, rows)
        hot = sim.atoms.v[: sim.atoms.n][rows]
        compute.restore_bias(sim, rows, kept)
        return hot

    def scale(self, sim: Simulation, rows: NDArray[np.bool_], factor: float) -> None:
        """Multiply the velocities of the chosen atoms, without those parts that the compute takes for a drift."""
        compute = self.compute(sim)
        kept = compute.remove_bias(sim, rows)
        sim.atoms.v[: sim.atoms.n][rows] *= factor
        compute.restore_bias(sim, rows, kept)
