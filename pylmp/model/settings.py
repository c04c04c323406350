"""Settings a script changes one by one: neighbor lists, communication cutoff, special bonds, output of runs."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass
class NeighborSettings:
    """neighbor and neigh_modify."""

    skin: float = 0.3
    every: int = 1
    delay: int = 0
    check: bool = True
    one: int = 2000
    page: int = 100000


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
class SpecialSettings:
    """special_bonds: weights of 1-2, 1-3, 1-4 pairs."""

    lj: tuple[float, float, float] = (0.0, 0.0, 0.0)
    coul: tuple[float, float, float] = (0.0, 0.0, 0.0)
    angle: bool = False
    dihedral: bool = False

    @property
    def weighted(self) -> bool:
        return self.lj != (1.0, 1.0, 1.0) or self.coul != (1.0, 1.0, 1.0)


@dataclass
class Tally:
    """Energies and virials of the last step that asked for them. Virials are (6,) xx yy zz xy xz yz.

    step    which they belong to
    read    the last step at which somebody wanted them
    """

    step: int = -1
    read: int = -1
    pair: float = 0.0
    bond: float = 0.0
    pair_virial: list[float] = field(default_factory=lambda: [0.0] * 6)
    bond_virial: list[float] = field(default_factory=lambda: [0.0] * 6)

    def current(self, step: int) -> bool:
        """Somebody wants those of step: are these they?"""
        self.read = step
        return self.step == step
