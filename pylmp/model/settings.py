"""Settings a script changes one by one: neighbor lists, communication cutoff, special bonds, output of runs."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.model.exclusions import Exclusions
from pylmp.model.mixing import GEOMETRIC


@dataclass
class NeighborSettings:
    """neighbor and neigh_modify. style: bin, or nsq (all pairs are looked at). once: lists are built at set-up only.

    bin_size    of a bin; 0: half the neighbor cutoff
    """

    skin: float = 0.3
    style: str = "bin"
    every: int = 1
    delay: int = 0
    check: bool = True
    one: int = 2000
    page: int = 100000
    once: bool = False
    bin_size: float = 0.0
    exclude: Exclusions = field(default_factory=Exclusions)


@dataclass
class CommSettings:
    """comm_modify: the ghost cutoff a user asks for (0: none), and whether ghosts carry velocities."""

    cutoff: float = 0.0
    velocity: bool = False


@dataclass
class SortSettings:
    """atom_modify sort: every so many steps, with bins of this size (0: half the neighbor cutoff)."""

    every: int = 1000
    bin_size: float = 0.0


@dataclass
class PairSettings:
    """pair_modify: mixing rule of unlike types, energies shifted to zero at the cutoff, corrections for what lies beyond it.

    trim      hybrid may cut this style's neighbor list to its own cutoff
    compute   the style acts
    fdotr     the virial is summed over the forces on all atoms, not over pairs
    lj coul   this style's own weights of 1-2, 1-3, 1-4 pairs; None: those of special_bonds
    """

    mix: str = GEOMETRIC
    shift: bool = False
    tail: bool = False
    trim: bool = True
    compute: bool = True
    fdotr: bool = True
    lj: tuple[float, float, float] | None = None
    coul: tuple[float, float, float] | None = None


@dataclass
class SpecialSettings:
    """special_bonds: weights of 1-2, 1-3, 1-4 pairs."""

    lj: tuple[float, float, float] = (0.0, 0.0, 0.0)
    coul: tuple[float, float, float] = (0.0, 0.0, 0.0)
    angle: bool = False
    dihedral: bool = False

    @property
    def weighted(self) -> bool:
        return self.lj != (1.0, 1.0, 1.0) or self.coul != (1.0, 1.0, 1.0)


ENERGY, VIRIAL, ATOM_ENERGY, ATOM_VIRIAL = 1, 2, 4, 8  # what a step may have to sum


@dataclass
class Tally:
    """Energies and virials of the last steps that asked for them. Virials are (6,) xx yy zz xy xz yz.

    wanted           what the last force evaluation summed: ENERGY | VIRIAL | ATOM_ENERGY | ATOM_VIRIAL
    step             of that evaluation
    pair_shares bond_shares   (rows, 7) of owned and ghost atoms: energy, virial
    """

    step: int = -1
    wanted: int = 0
    pair: float = 0.0
    bond: float = 0.0
    pair_virial: list[float] = field(default_factory=lambda: [0.0] * 6)
    bond_virial: list[float] = field(default_factory=lambda: [0.0] * 6)
    pair_shares: Floats = field(default_factory=lambda: np.zeros((0, 7)))
    bond_shares: Floats = field(default_factory=lambda: np.zeros((0, 7)))

    def has(self, what: int, step: int) -> bool:
        """Was what (ENERGY, ...) summed at step?"""
        return self.step == step and bool(self.wanted & what)
