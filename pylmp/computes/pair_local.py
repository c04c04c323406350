"""compute ID GROUP pair/local values... [cutoff type]: a row a pair of atoms within the pair style's cutoff, in list order.

dist dx dy dz; eng force fx fy fz from the pair law itself, special weights applied. Source: LAMMPS manual, compute_pair_local.html.
"""

from __future__ import annotations

import re

import numpy as np
from numpy.typing import NDArray

from pylmp.model.atoms import Floats
from pylmp.model.compute import Compute
from pylmp.model.occasional import Pairs, listed_pairs
from pylmp.model.pair_alone import weighted
from pylmp.model.registry import COMPUTES
from pylmp.model.simulation import Simulation
from pylmp.model.wish import Wish
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args

_VALUES = ("dist", "dx", "dy", "dz", "eng", "force", "fx", "fy", "fz")


def pairs_of(sim: Simulation, members: NDArray[np.bool_], bit: int, interacting: bool) -> Pairs:
    """Listed pairs with both atoms in a group, each once; interacting: those within the cutoff of their types only."""
    atoms, pairs = sim.atoms, listed_pairs(sim, Wish())
    take = members[pairs.i] & ((atoms.mask[pairs.j] & bit) != 0)
    if interacting and sim.pair is not None:
        take &= pairs.r2 < np.square(sim.pair.cut[atoms.type[pairs.i], atoms.type[pairs.j]])
    if not sim.newton_pair:  # a pair across a periodic face is listed twice
        take &= (pairs.j < atoms.n) | _first_of_two(sim, pairs)
    return pairs.take(np.flatnonzero(take))


def _first_of_two(sim: Simulation, pairs: Pairs) -> NDArray[np.bool_]:
    """LAMMPS's choice of one of the two entries: by whether the sum of both IDs is even; of an atom's own image by position."""
    one, other = sim.atoms.tag[pairs.i], sim.atoms.tag[pairs.j]
    odd = (one + other) % 2 == 1
    x, y, z = -pairs.d.T  # of j relative to i
    ahead = (z > 0.0) | ((z == 0.0) & ((y > 0.0) | ((y == 0.0) & (x >= 0.0))))
    return np.where(one > other, odd, np.where(one < other, ~odd, ahead))


@COMPUTES.register("pair/local")
class PairLocal(Compute):
    style = "pair/local"

    def __init__(self, sim: Simulation, identity: str, group: str, bit: int, args: Args) -> None:
        super().__init__(sim, identity, group, bit, args)
        args.need(1)
        self.names: list[str] = []
        while (word := args.peek()) is not None and (word.text in _VALUES or re.fullmatch(r"p[1-9]\d*", word.text)):
            self.names.append(args.word().text)
        while len(args):
            read_cutoff(self, args)
        self.columns = len(self.names)

    def wish(self, sim: Simulation) -> Wish:
        return Wish()

    def init(self, sim: Simulation) -> None:
        if sim.pair is None and not set(self.names) <= {"dist", "dx", "dy", "dz"}:
            raise ScriptError("No pair style is defined for compute pair/local", hint="pair_style comes first")
        if any(name not in _VALUES for name in self.names):
            raise ScriptError("Pair style does not have extra field requested by compute pair/local", hint=" ".join(_VALUES))

    def local(self, sim: Simulation) -> Floats:
        """(rows,) or (rows, columns)"""
        pairs = pairs_of(sim, self.members(sim), self.bit, True)
        distance = np.sqrt(pairs.r2)
        values = {"dist": distance, **{f"d{axis}": pairs.d[:, k] for k, axis in enumerate("xyz")}}
        if not set(self.names) <= set(values):
            over_r, energy = weighted(sim, pairs)
            values |= {"eng": energy, "force": distance * over_r}
            values |= {f"f{axis}": pairs.d[:, k] * over_r for k, axis in enumerate("xyz")}
        table = np.stack([values[name] for name in self.names], axis=1)
        return table[:, 0] if self.columns == 1 else table


def read_cutoff(compute: Compute, args: Args) -> None:
    """The keyword cutoff type, or cutoff radius, which needs atoms with one."""
    key = args.word()
    if key.text != "cutoff":
        args.fail(f"Unknown {args.what} keyword: {key.text}", key, hint="cutoff type")
    args.need(1, key.text)
    value = args.word()
    if value.text == "radius":
        args.fail(f"{args.what.capitalize()} with ID {compute.id} requires atom attribute radius", value, hint="cutoff type")
    if value.text != "type":
        args.fail(f"Unknown {args.what} cutoff keyword: {value.text}", value, hint="cutoff type")
