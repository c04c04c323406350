"""What a compute is: a quantity measured when somebody asks for it."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args


class Compute:
    """Base of every compute style. A subclass defines what it offers:

    scalar(sim) -> float
    vector(sim) -> (k,) float64
    per_atom(sim) -> (n,) or (n, k) float64 over owned atoms in local order (0 outside the group)
    local(sim) -> (rows,) or (rows, k) float64

    extensive_scalar, extensive_vector  thermo divides them by the number of atoms when norm is on
    needs_tally  it reads energies or virial, which the engine sums only on steps that ask for them
    """

    style: ClassVar[str] = ""
    extensive_scalar = False
    extensive_vector = False
    needs_tally = False
    ready = False  # a run was set up since its definition

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        self.id = identity
        self.group = group
        self.bit = bit

    def init(self, sim: Simulation) -> None:
        """Called at the start of every run."""

    def members(self, sim: Simulation) -> NDArray[np.bool_]:
        """(n,) bool: the owned atoms of this compute's group."""
        return (sim.atoms.mask[: sim.atoms.n] & self.bit) != 0
