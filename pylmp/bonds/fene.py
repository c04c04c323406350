"""bond_style fene: E = -K R0^2/2 ln[1 - (r/R0)^2] + 4 epsilon [(sigma/r)^12 - (sigma/r)^6] + epsilon, the second part below 2^(1/6) sigma.

Where 1 - (r/R0)^2 falls below 0.1 the force is that of 0.1 and a warning is printed; at -3 the run ends.

Source: LAMMPS manual, bond_fene.html. Order of operations and limits as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from pylmp.laws import log, select
from pylmp.model.atoms import Floats, Ints
from pylmp.model.bond import beside
from pylmp.model.registry import BONDS
from pylmp.model.style import BondStyle, Coeff, Options, always
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import eight, shortest

WALL2 = 1.2599210498948732  # (2^(1/6))^2: where the LJ term ends
LEAST, WORST = 0.1, -3.0  # of 1 - (r/R0)^2: where the force stops growing; where the run ends
LENGTH = 0.97  # of sigma: LAMMPS's estimate of the bond length


def fene(r2: Any, dot: Any, h: Any, c: Any) -> Any:
    k, r0, epsilon, sigma = c
    q = left(r2, c)
    q = select(q < LEAST, LEAST, q)
    force = -k / q
    energy = -0.5 * k * (r0 * r0) * log(q)
    s2 = sigma * sigma / r2
    s6 = s2 * s2 * s2
    near = r2 < WALL2 * sigma * sigma
    force = force + select(near, 48.0 * epsilon * s6 * (s6 - 0.5) / r2, 0.0)
    energy = energy + select(near, 4.0 * epsilon * s6 * (s6 - 1.0) + epsilon, 0.0)
    return force, energy, h, True


def left(r2: Any, c: Any) -> Any:
    """1 - (r/R0)^2: how far the bond still can stretch."""
    return 1.0 - r2 / (c[1] * c[1])


def too_long(r2: Any, c: Any) -> Any:
    return left(r2, c) < LEAST


def report(sim: Any, part: Any, bonds: Ints) -> None:
    for first, second, kind in bonds.tolist():
        warn(sim, first, second, shortest, bool(left(squared(sim, first, second), part.table[kind]) <= WORST))


def warn(sim: Any, first: int, second: int, number: Any, bad: bool) -> None:
    tag = sim.atoms.tag
    r = np.sqrt(squared(sim, first, second))
    sim.console.warning(f"FENE bond too long: {sim.step} {tag[first]} {tag[second]} {number(float(r))}")
    if bad:
        raise ScriptError(
            "Bad FENE bond", hint=f"bond {tag[first]} {tag[second]} is {eight(r)} long: a smaller timestep, or start closer to rest",
            manual="bond_fene.html",
        )  # fmt: skip


def squared(sim: Any, first: int, second: int) -> Any:
    d = sim.atoms.x[first] - beside(sim, first, second)
    return d[0] * d[0] + d[1] * d[1] + d[2] * d[2]


def report_alone(sim: Any, part: Any, r2: Floats, kinds: Ints) -> None:
    """What compute bond/local says."""
    for r in np.sqrt(r2).tolist():
        sim.console.warning(f"FENE bond too long: {sim.step} {eight(r)}")


def cautions(name: str) -> Any:
    def of(sim: Any, options: Options) -> list[str]:
        wrong = sim.special.lj != (0.0, 1.0, 1.0)
        return [f"Use special bonds = 0,1,1 with bond style {name}"] if wrong else []

    return of


BONDS.add(
    "fene",
    BondStyle(
        name="fene", manual="bond_fene.html",
        coeffs=(
            Coeff("K", "energy/distance^2"), Coeff("R0", "distance"), Coeff("epsilon", "energy"), Coeff("sigma", "distance"),
        ),
        adapts=("k", "r0"), law=lambda options: fene, length=lambda coeffs, options: LENGTH * coeffs[3], watch=always(too_long), report=report,
        report_alone=report_alone, cautions=cautions("fene"), omp=True, release="fene",
    ),
)  # fmt: skip
