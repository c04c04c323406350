"""Momentum, rotation and temperature of a group, summed in LAMMPS's order."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.jacobi import eigen
from pylmp.model.sums import total, totals

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation

_SINGULAR = 1.0e-6  # determinant of an inertia tensor below which its axes are found first
Chosen = NDArray[np.bool_]


def center_of_mass_velocity(sim: Simulation, chosen: Chosen, mass: float | None = None) -> Floats:
    """(3,) sum(m v)/M; 0 without atoms. mass: M where it was known before."""
    return _mean(sim, chosen, sim.atoms.v[: sim.atoms.n][chosen], mass)


def center_of_mass(sim: Simulation, chosen: Chosen, mass: float | None = None) -> Floats:
    """(3,) sum(m x)/M of unwrapped positions; 0 without atoms. mass: M where it was known before."""
    return _mean(sim, chosen, unwrapped(sim, chosen), mass)


def unwrapped(sim: Simulation, chosen: Chosen) -> Floats:
    """(k, 3) positions of the chosen owned atoms with image flags undone."""
    atoms = sim.atoms
    return sim.box.unwrap(atoms.x[: atoms.n][chosen], atoms.image[: atoms.n][chosen])


def _mean(sim: Simulation, chosen: Chosen, values: Floats, mass: float | None) -> Floats:
    m = sim.masses()[chosen]
    whole = total(m) if mass is None else mass
    return totals(values * m[:, None]) / whole if whole > 0.0 else np.zeros(3)


def temperature_dof(sim: Simulation, chosen: Chosen, fewer: int | None = None) -> float:
    """dimension*N - fewer; fewer: the dimension, unless said otherwise."""
    return float(sim.dimension * int(chosen.sum()) - (sim.dimension if fewer is None else fewer))


def temperature_of(sim: Simulation, chosen: Chosen, dof: float) -> float:
    """Temperature of a group from its velocities; 0.0 without degrees of freedom."""
    if dof <= 0.0:
        return 0.0
    m = sim.masses()[chosen]
    v = sim.atoms.v[: sim.atoms.n][chosen]
    t = total((v[:, 0] * v[:, 0] + v[:, 1] * v[:, 1] + v[:, 2] * v[:, 2]) * m)
    return t * (sim.units.mvv2e / (dof * sim.units.boltz))


def remove_rotation(sim: Simulation, chosen: Chosen) -> None:
    """Subtract omega x r, omega from angular momentum and inertia about the center of mass, unwrapped coordinates."""
    atoms = sim.atoms
    m = sim.masses()[chosen]
    v = atoms.v[: atoms.n][chosen]
    x = sim.box.unwrap(atoms.x[: atoms.n][chosen], atoms.image[: atoms.n][chosen])
    center = center_of_mass(sim, chosen)
    a, b, c = (x[:, d] - center[d] for d in range(3))
    momentum = (
        total(m * (b * v[:, 2] - c * v[:, 1])), total(m * (c * v[:, 0] - a * v[:, 2])), total(m * (a * v[:, 1] - b * v[:, 0])),
    )  # fmt: skip
    xx, yy, zz = total(m * (b * b + c * c)), total(m * (a * a + c * c)), total(m * (a * a + b * b))
    xy, yz, xz = -total(m * a * b), -total(m * b * c), -total(m * a * c)
    inertia = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    w = angular_velocity(inertia, momentum)
    v[:, 0] -= w[1] * c - w[2] * b
    v[:, 1] -= w[2] * a - w[0] * c
    v[:, 2] -= w[0] * b - w[1] * a
    atoms.v[: atoms.n][chosen] = v


def angular_velocity(
    i: tuple[tuple[float, float, float], ...], momentum: tuple[float, float, float]
) -> tuple[float, float, float]:
    """Solve I w = L; along the axes that have inertia if I is singular."""
    det = (
        i[0][0] * i[1][1] * i[2][2] + i[0][1] * i[1][2] * i[2][0] + i[0][2] * i[1][0] * i[2][1]
        - i[0][0] * i[1][2] * i[2][1] - i[0][1] * i[1][0] * i[2][2] - i[2][0] * i[1][1] * i[0][2]
    )  # fmt: skip
    if det > _SINGULAR:
        inverse = (
            (i[1][1] * i[2][2] - i[1][2] * i[2][1], -(i[0][1] * i[2][2] - i[0][2] * i[2][1]), i[0][1] * i[1][2] - i[0][2] * i[1][1]),
            (-(i[1][0] * i[2][2] - i[1][2] * i[2][0]), i[0][0] * i[2][2] - i[0][2] * i[2][0], -(i[0][0] * i[1][2] - i[0][2] * i[1][0])),
            (i[1][0] * i[2][1] - i[1][1] * i[2][0], -(i[0][0] * i[2][1] - i[0][1] * i[2][0]), i[0][0] * i[1][1] - i[0][1] * i[1][0]),
        )  # fmt: skip
        rows = [[q / det for q in row] for row in inverse]
        a, b, c = (row[0] * momentum[0] + row[1] * momentum[1] + row[2] * momentum[2] for row in rows)
        return a, b, c
    values, (ex, ey, ez) = eigen([list(row) for row in i])
    normal = ex[1] * ey[2] - ex[2] * ey[1], ex[2] * ey[0] - ex[0] * ey[2], ex[0] * ey[1] - ex[1] * ey[0]
    if normal[0] * ez[0] + normal[1] * ez[1] + normal[2] * ez[2] < 0.0:
        ez = [-q for q in ez]
    body = []
    for value, axis in zip(values, (ex, ey, ez), strict=True):
        along = momentum[0] * axis[0] + momentum[1] * axis[1] + momentum[2] * axis[2]
        body.append(along / value if value != 0.0 and value >= _SINGULAR * max(values) else 0.0)
    a, b, c = (body[0] * ex[d] + body[1] * ey[d] + body[2] * ez[d] for d in range(3))
    return a, b, c
