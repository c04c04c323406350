"""One pair of atoms alone, outside the neighbor list: what bond_style quartic takes out, what computes ask for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from typing import TYPE_CHECKING, Any

import numpy as np

from pylmp.kernels.exact import coefficients
from pylmp.model.atoms import Floats, Ints
from pylmp.text.diagnostic import Unsupported

if TYPE_CHECKING:
    from pylmp.kernels.kinds import Function
    from pylmp.model.occasional import Pairs
    from pylmp.model.pair import PairPart
    from pylmp.model.simulation import Simulation


@dataclass(frozen=True)
class Alone:
    """law(r2, dot, table, at, data) -> (force over r, energy) of all styles together; table (nt+1, nt+1, width)."""

    law: Function
    table: Floats
    data: Floats
    velocity: bool

    @property
    def width(self) -> int:
        return int(self.table.shape[2])


def in_order(parts: list[PairPart], acting: Iterable[list[PairPart]]) -> list[PairPart]:
    """parts such that those of every pair of types stand as pair_coeff named them: so LAMMPS adds them up.

    Raises Unsupported where three or more would have to be added in different orders for different types.
    """
    before: dict[int, set[int]] = {k: set() for k in range(len(parts))}
    for named in acting:
        order = [parts.index(part) for part in named if part in parts]
        for k, later in enumerate(order[1:] if len(order) > 2 else (), 1):
            before[later].add(order[k - 1])
    try:
        return [parts[k] for k in TopologicalSorter(before).static_order()]
    except CycleError:
        raise Unsupported(
            "LAMMPS adds up the pair styles that bond_style quartic takes out in another order for other types",
            hint="name the styles in the same order in all pair_coeff commands",
        ) from None


def compose(parts: list[PairPart]) -> Alone:
    """The styles' laws of a pair alone, one after the other over one table. parts: those that have a law, at least one."""
    law = None
    width, length = 0, 0
    tables, datas = [], []
    for part in parts:
        tabled = part.style.data is not None
        load = coefficients(part.width, tabled)
        law = _first(part.alone, load) if law is None else _then(law, part.alone, load, width)
        table = part.table.copy()
        if tabled:
            table[:, :, -1] += float(length)  # where its data begin
            datas.append(part.data)
            length += len(part.data)
        tables.append(table)
        width += part.width
    data = np.concatenate(datas) if datas else np.zeros(1)
    return Alone(law, np.concatenate(tables, axis=2), data, any(part.style.velocity for part in parts))


def _first(alone: Function, load: Function) -> Function:
    def law(r2: Any, dot: Any, table: Any, at: Any, data: Any) -> Any:
        return alone(r2, dot, 1.0, load(table, at, data, table, 0))

    return law


def _then(before: Function, alone: Function, load: Function, offset: int) -> Function:
    def law(r2: Any, dot: Any, table: Any, at: Any, data: Any) -> Any:
        force, energy = before(r2, dot, table, at, data)
        more_force, more_energy = alone(r2, dot, 1.0, load(table, at + offset, data, table, 0))
        return force + more_force, energy + more_energy

    return law


def evaluate(
    parts: list[PairPart], r2: Floats, dot: Floats, first: Ints, second: Ints, factor: Floats | float
) -> tuple[Floats, Floats]:
    """(force over r, energy) of many pairs of atoms of types first and second; factor: their special weights."""
    force, energy = np.zeros(len(r2)), np.zeros(len(r2))
    for part in parts:
        columns = (*part.table[first, second].T, *((part.data,) if part.style.data is not None else ()))
        with np.errstate(all="ignore"):
            more_force, more_energy = part.alone(r2, dot, factor, columns)
        force += more_force
        energy += more_energy
    return force, energy


def weighted(sim: Simulation, pairs: Pairs) -> tuple[Floats, Floats]:
    """(force over r, energy) of listed pairs, each alone, with their special weights."""
    atoms = sim.atoms
    apart = atoms.v[pairs.i] - atoms.v[pairs.j]
    dot = pairs.d[:, 0] * apart[:, 0] + pairs.d[:, 1] * apart[:, 1] + pairs.d[:, 2] * apart[:, 2]
    factor = np.array([1.0, *sim.special.lj])[pairs.kind]
    force, energy = sim.pair.single(pairs.r2, dot, atoms.type[pairs.i], atoms.type[pairs.j], factor)
    return force, energy
