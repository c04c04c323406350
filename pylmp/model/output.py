"""When thermo lines and dump frames are due. What they contain is theirs to know."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


class Output:
    """thermo: the table (pylmp/thermo), dumps: by ID in order of definition (pylmp/dumps)."""

    def __init__(self) -> None:
        self.thermo: Any = None
        self.dumps: dict[str, Any] = {}

    def init(self, sim: Simulation) -> None:
        """Check everything that will be written."""

    def setup(self, sim: Simulation) -> None:
        """Write what is due before the first step of a run: header and first thermo line, dump frames."""

    def write(self, sim: Simulation) -> None:
        """Write what is due at sim.step."""

    def next_step(self, sim: Simulation) -> int:
        """The next step after sim.step at which something is due that needs energies and virial."""
        return sim.end
