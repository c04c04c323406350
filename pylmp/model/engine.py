"""What carries out a run. The door chooses an engine; the run command knows only this protocol."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from pylmp.model.minimize import MinPlan, MinReport
    from pylmp.model.scene import Scene
    from pylmp.model.simulation import Simulation


@dataclass
class RunPlan:
    """One segment of a run command.

    steps         how many
    begin, end    the steps that ramps refer to (start/stop of the command, else this run's)
    setup         do the set-up (pre yes, or the first run)
    """

    steps: int
    begin: int
    end: int
    setup: bool = True


@dataclass
class RunReport:
    """What the log says after a run: seconds by section, neighbor counts; full_neighbors: of a full list, None without one."""

    steps: int
    seconds: float
    sections: dict[str, float]
    neighbors: int
    ghosts: int
    builds: int
    dangerous: int
    full_neighbors: int | None = None
    processor: dict[str, float] = field(default_factory=dict)  # the processor's seconds by section, under timer full


class Engine(Protocol):
    name: str

    def minimize(self, sim: Simulation, scene: Scene, plan: MinPlan) -> tuple[RunReport, MinReport]:
        """Move the atoms to a minimum of the energy."""
        ...

    def replay(self, sim: Simulation, scene: Scene, frames: Iterator[None]) -> RunReport:
        """Forces and output of each state that frames makes sim's, one after the other."""
        ...

    def run(self, sim: Simulation, scene: Scene, plan: RunPlan) -> RunReport:
        """Carry out plan, calling sim.output at the steps that are due."""
        ...
