"""The scene: everything about a run that shapes its machine code, and nothing else."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


@dataclass(frozen=True)
class BondScene:
    """One bond style of the scene: its name, and its keywords as (name, value) pairs."""

    style: str
    options: tuple[tuple[str, object], ...]
    can_break: bool


@dataclass(frozen=True)
class PairScene:
    """One pair style of the scene and its keywords."""

    style: str
    options: tuple[tuple[str, object], ...]


@dataclass(frozen=True)
class Scene:
    """Stated when a run begins; hashable. What is absent here is absent from the compiled code."""

    dimension: int
    periodic: tuple[bool, bool, bool]
    triclinic: bool
    newton_pair: bool
    newton_bond: bool
    atom_types: int
    pair: str
    pairs: tuple[PairScene, ...]
    bonds: tuple[BondScene, ...]
    weighted: bool  # some 1-2, 1-3 or 1-4 pairs are scaled or left out
    ghost_velocity: bool
    fixes: tuple[str, ...]


def state(sim: Simulation) -> Scene:
    """The scene of sim as it stands."""
    pair, bond = sim.pair, sim.bond
    parts = bond.parts if bond else ()
    return Scene(
        dimension=sim.dimension,
        periodic=sim.box.periodic,
        triclinic=sim.box.triclinic,
        newton_pair=sim.newton_pair,
        newton_bond=sim.newton_bond,
        atom_types=sim.atom_types,
        pair=pair.name if pair else "none",
        pairs=tuple(PairScene(part.style.name, tuple(sorted(part.options.items()))) for part in pair.parts) if pair else (),
        bonds=tuple(
            BondScene(part.style.name, tuple(sorted(part.options.items())), part.can_break) for part in parts
        ),
        weighted=sim.special.weighted,
        ghost_velocity=sim.ghost_velocity,
        fixes=tuple(fix.style for fix in sim.fixes),
    )
