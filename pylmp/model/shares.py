"""The atoms' shares of energy and virial, brought together: what ghosts were given goes to the atoms they are images of."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from pylmp.model.atoms import Floats

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


def shares(sim: Simulation, parts: Iterable[str], columns: slice, others: Iterable[Floats] = ()) -> Floats:
    """(n, k) of each owned atom: parts (pair, bond) in this order, then others (n, k).

    columns: of a tally's shares, energy first, then the virial. As in LAMMPS they are those of the last force evaluation, also where
    atoms were moved since.
    """
    tallied = {"pair": sim.tally.pair_shares, "bond": sim.tally.bond_shares}
    tables = [tallied[part][:, columns] for part in parts]
    n = sim.atoms.n
    width = len(range(*columns.indices(7)))
    result = np.zeros((max([n, *map(len, tables)]), width))
    for table in tables:
        result[: len(table)] += table
    for other in others:
        result[: len(other)] += other
    if len(result) > n and (sim.newton_pair or sim.newton_bond):
        sim.lists.ghosts.fold(result)
    return result[:n]
