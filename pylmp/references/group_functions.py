"""count() mass() charge() xcm() vcm() fcm() bound() gyration() ke() angmom() torque() inertia() omega() of a group, or of its
atoms inside a region.

Source: LAMMPS manual, variable.html; order of operations as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.motion import angular_velocity
from pylmp.model.simulation import Simulation
from pylmp.model.sums import total
from pylmp.text.formula_error import FormulaError

Chosen = NDArray[np.bool_]
_AXES = ("x", "y", "z")
_FACES = tuple(f"{axis}{end}" for axis in _AXES for end in ("min", "max"))
_PAIRS = ("xx", "yy", "zz", "xy", "yz", "xz")
_BIG = 1.0e20


class Members:
    """The atoms a function is about: masses m (k,), velocities v, forces f (k, 3)."""

    def __init__(self, sim: Simulation, chosen: Chosen) -> None:
        self.sim = sim
        self.chosen = chosen
        self.m: Floats = sim.masses()[chosen]
        self.v, self.f, self.x = (array[: sim.atoms.n][chosen] for array in (sim.atoms.v, sim.atoms.f, sim.atoms.x))
        self.mass = total(self.m)

    def unwrapped(self) -> Floats:
        """(k, 3) positions as if no atom had ever been wrapped."""
        if not len(self.x):
            return self.x
        return self.sim.box.unwrap(self.x, self.sim.atoms.image[: self.sim.atoms.n][self.chosen])

    def mean(self, values: Floats) -> list[float]:
        """Mass-weighted mean of (k, 3) values; 0 for no atoms."""
        sums = [total(values[:, d] * self.m) for d in range(3)]
        return [q / self.mass for q in sums] if self.mass > 0.0 else sums

    def around(self) -> tuple[Floats, Floats, Floats]:
        """Positions relative to the center of mass, unwrapped."""
        x = self.unwrapped()
        a, b, c = (x[:, d] - q for d, q in enumerate(self.mean(x)))
        return a, b, c


def _moment(m: Members, values: Floats, weights: Floats | float) -> tuple[float, float, float]:
    a, b, c = m.around()
    x, y, z = values.T
    return (
        total(weights * (b * z - c * y)), total(weights * (c * x - a * z)), total(weights * (a * y - b * x)),
    )  # fmt: skip


def _inertia(m: Members) -> tuple[tuple[float, float, float], ...]:
    a, b, c = m.around()
    xx, yy, zz = total(m.m * (b * b + c * c)), total(m.m * (a * a + c * c)), total(m.m * (a * a + b * b))
    xy, yz, xz = total(-(m.m * a * b)), total(-(m.m * b * c)), total(-(m.m * a * c))
    return (xx, xy, xz), (xy, yy, yz), (xz, yz, zz)


def _angmom(m: Members) -> tuple[float, float, float]:
    return _moment(m, m.v, m.m)


def _gyration(m: Members, at: int) -> float:
    a, b, c = m.around()
    radius = total((a * a + b * b + c * c) * m.m)
    return math.sqrt(radius / m.mass) if m.mass > 0.0 else 0.0


def _ke(m: Members, at: int) -> float:
    x, y, z = m.v.T
    return 0.5 * m.sim.units.mvv2e * total((x * x + y * y + z * z) * m.m)


def _bound(m: Members, at: int) -> float:
    column = m.x[:, at // 2]
    return float(column.max(initial=-_BIG)) if at % 2 else float(column.min(initial=_BIG))


def _charge(m: Members, at: int) -> float:
    return total(m.sim.atoms.q[: m.sim.atoms.n][m.chosen])


def _tensor(m: Members, at: int) -> float:
    row, column = ("xyz".index(letter) for letter in _PAIRS[at])
    return _inertia(m)[row][column]


# Name: the words its second argument may be, what it computes; at is the number of that word.
FUNCTIONS: dict[str, tuple[tuple[str, ...], Callable[[Members, int], float]]] = {
    "count": ((), lambda m, at: float(len(m.m))), "mass": ((), lambda m, at: m.mass), "charge": ((), _charge),
    "xcm": (_AXES, lambda m, at: m.mean(m.unwrapped())[at]), "vcm": (_AXES, lambda m, at: m.mean(m.v)[at]),
    "fcm": (_AXES, lambda m, at: total(m.f[:, at])), "bound": (_FACES, _bound), "gyration": ((), _gyration), "ke": ((), _ke),
    "angmom": (_AXES, lambda m, at: _angmom(m)[at]), "torque": (_AXES, lambda m, at: _moment(m, m.f, 1.0)[at]),
    "inertia": (_PAIRS, _tensor), "omega": (_AXES, lambda m, at: angular_velocity(_inertia(m), _angmom(m))[at]),
}  # fmt: skip


def value(sim: Simulation, function: str, names: tuple[str, ...]) -> float:
    """What a function of a group, one of its words where it has them, and perhaps a region is worth."""
    words, compute = FUNCTIONS[function]
    needed = 2 if words else 1
    wrong = FormulaError(f"Invalid {function}() function in variable formula", hint=" ".join(words))
    bit = sim.groups.bit(names[0])
    if not bit:
        raise FormulaError(f"Group {names[0]} in variable formula does not exist", hint=f"groups: {' '.join(sim.groups.names)}")
    if not needed <= len(names) <= needed + 1:
        raise wrong
    chosen = (sim.atoms.mask[: sim.atoms.n] & bit) != 0
    if words and names[1] not in words:
        raise wrong
    if len(names) > needed:
        chosen &= region(sim, names[-1]).inside(sim.atoms.x[: sim.atoms.n])
    return compute(Members(sim, chosen), words.index(names[1]) if words else 0)


def region(sim: Simulation, name: str) -> Any:
    found = sim.regions.get(name)
    if found is None:
        raise FormulaError(f"Region {name} in variable formula does not exist", hint=f"regions: {' '.join(sim.regions)}")
    return found
