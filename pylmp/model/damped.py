"""What min_style fire and quickmin share: dynamics that is stopped when it goes uphill."""

from __future__ import annotations

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.minimize import Minimizer
from pylmp.model.sums import total


class DampedMinimizer(Minimizer):
    """Velocities of all atoms belong to the minimization; they begin at 0."""

    def prepare(self) -> None:
        self.v[:] = 0.0

    def power(self) -> float:
        """v.f, summed atom by atom."""
        return total(rowwise(self.v, self.f))

    def limited(self, dt: float, v: Floats | None = None) -> float:
        """dt, shortened until no component of v moves farther than dmax; atom after atom, as LAMMPS does."""
        v = self.v if v is None else v
        fastest = np.abs(v).max(axis=1)
        dmax = self.settings.dmax
        for speed in fastest[dt * fastest > dmax]:
            if dt * speed > dmax:
                dt = dmax / float(speed)
        return dt

    def drift(self, dt: float) -> None:
        """x += dt v"""
        self.x[:] += dt * self.v

    def kick(self, dt: float) -> None:
        """v += (dt/m) f"""
        self.v[:] += self.push(dt)

    def push(self, dt: float) -> Floats:
        """(n, 3) (dt/m) f"""
        return np.asarray((dt * self.sim.units.ftm2v / self.sim.masses())[:, None] * self.f)


def rowwise(a: Floats, b: Floats) -> Floats:
    """(n,) dot product of each row."""
    return np.asarray(a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1] + a[:, 2] * b[:, 2])
