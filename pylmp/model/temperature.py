"""What computes of a temperature share: degrees of freedom, the kinetic energy tensor, and a drift that does not count.

T = sum(m v^2) / (dof kB). The number of degrees of freedom is counted when a run is set up, and again at every evaluation only if
compute_modify dynamic/dof says so (or atoms come and go by definition). Order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.sums import total, totals
from pylmp.text.diagnostic import ScriptError

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation
    from pylmp.text.words import Args

Rows = NDArray[np.bool_]

_ROWS = 2**16  # that are looked at together: a bound on memory


class Temperature(Compute):
    """Base of temp, temp/partial, temp/com, temp/region.

    bias         some part of the velocities is no heat: thermostats leave it alone
    """

    length = 6
    extensive_vector = True
    bias: ClassVar[bool] = False

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        self.extra_dof = float(sim.dimension)
        self._dof: float | None = None

    # ---- degrees of freedom -----------------------------------------------------------------------------------

    def count_dof(self, sim: Simulation) -> float:
        """dimension*N - extra_dof."""
        return sim.dimension * float(self.members(sim).sum()) - self.extra_dof

    def setup(self, sim: Simulation) -> None:
        self._dof = self.count_dof(sim)

    def dof(self, sim: Simulation) -> float:
        if self._dof is None or self.dynamic or self.group_varies(sim):
            self._dof = self.count_dof(sim)
        return self._dof

    # ---- what it is -------------------------------------------------------------------------------------------

    def scalar(self, sim: Simulation) -> float:
        rows = self.members(sim)
        v, terms = self.thermal(sim, rows), sim.masses()
        if len(v) < len(terms):
            terms = terms[rows]
        for begin in range(0, len(v), _ROWS):
            part, m = v[begin : begin + _ROWS], terms[begin : begin + _ROWS]
            m *= part[:, 0] * part[:, 0] + part[:, 1] * part[:, 1] + part[:, 2] * part[:, 2]
        t = total(terms)
        dof = self.dof(sim)
        if dof < 0.0 and rows.any():
            raise ScriptError("Temperature compute degrees of freedom < 0", hint="more atoms, or a smaller extra/dof")
        return self.of(sim, t, dof) if dof > 0.0 else t * 0.0  # not 0.0 where t is infinite

    @staticmethod
    def of(sim: Simulation, t: float, dof: float) -> float:
        """The temperature of sum(m v^2)."""
        return t * (sim.units.mvv2e / (dof * sim.units.boltz))

    def vector(self, sim: Simulation) -> Floats:
        """(6,) sum(m v_a v_b): xx yy zz xy xz yz."""
        rows = self.members(sim)
        m = sim.masses()[rows]
        x, y, z = self.thermal(sim, rows).T
        products = np.stack([m * x * x, m * y * y, m * z * z, m * x * y, m * x * z, m * y * z], axis=1)
        return totals(products) * sim.units.mvv2e

    # ---- the drift --------------------------------------------------------------------------------------------

    def thermal(self, sim: Simulation, rows: Rows) -> Floats:
        """(k, 3) velocities of the chosen owned atoms without their drift, to read only."""
        v = sim.atoms.v[: sim.atoms.n]
        return v if rows.all() else v[rows]

    def remove_bias(self, sim: Simulation, rows: Rows) -> Any:
        """Take the drift out of the velocities of the chosen atoms, in place; returns what restore_bias needs."""
        return None

    def restore_bias(self, sim: Simulation, rows: Rows, kept: Any) -> None:
        """Put the drift back."""
