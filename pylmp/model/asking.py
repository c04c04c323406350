"""Who will want what at which step: energies, virials and their shares per atom are summed only on steps that ask for them.

LAMMPS's own bookkeeping. A consumer of computes (the thermo table, a dump, a fix that measures) evaluates them in a block:

    sim.asking.block()        forget what was evaluated: in this block every compute is evaluated once
    ... current(sim, compute, "scalar") ...
    sim.asking.again(step)    the computes evaluated in this block will be wanted at step

or, before it has evaluated anything, ``sim.asking.everyone(step)``. Asking for a step that nobody announced ends in
"Energy was not tallied on needed timestep". Between blocks a value stays what it was, even when atoms moved meanwhile.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from pylmp.model.settings import ATOM_ENERGY, ATOM_VIRIAL, ENERGY, VIRIAL

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

__all__ = ["ATOM_ENERGY", "ATOM_VIRIAL", "ENERGY", "VIRIAL", "Asking"]


SHARED = 2  # the highest level


def level_of(wanted: int) -> int:
    """What a force evaluation has to do: 0 forces alone, 1 energy and virial too, SHARED each atom's share of them too."""
    return SHARED if wanted & (ATOM_ENERGY | ATOM_VIRIAL) else 1 if wanted else 0


def levels(sim: Simulation) -> tuple[int, ...]:
    """The levels that this simulation can ask for."""
    shared = any(level_of(compute.tallies) == SHARED for compute in sim.computes.values())
    return (0, 1, SHARED) if shared else (0, 1)


class Asking:
    """steps: what will be wanted (ENERGY | VIRIAL | ATOM_ENERGY | ATOM_VIRIAL) by step."""

    def __init__(self, sim: Simulation) -> None:
        self._sim = sim
        self.steps: dict[int, int] = {}

    def block(self) -> None:
        """A consumer begins: nothing is evaluated yet."""
        for compute in self._sim.computes.values():
            compute.evaluated.clear()

    def again(self, step: int) -> None:
        """What was evaluated since block() will be wanted at step."""
        for compute in self._sim.computes.values():
            if compute.tallies and compute.evaluated:
                self.ask(step, compute.tallies)

    def everyone(self, step: int) -> None:
        """Any compute may be wanted at step."""
        for compute in self._sim.computes.values():
            self.ask(step, compute.tallies)

    def ask(self, step: int, tallies: int) -> None:
        """Sum these at step."""
        if tallies:
            self.steps[step] = self.steps.get(step, 0) | tallies

    def take(self, step: int) -> int:
        """What is wanted at step, which comes now: on steps with output whatever any compute reads."""
        if step == self._sim.output.due_step:
            self.everyone(step)
        return self.steps.pop(step, 0)

    def init(self, step: int) -> None:
        """A run begins at step: its first output may want anything, and nothing evaluated before counts."""
        self.steps = {at: wanted for at, wanted in self.steps.items() if at >= step}
        for compute in self._sim.computes.values():
            compute.invoked.clear()
        self.everyone(step)
