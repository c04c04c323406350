"""Special neighbors: which atoms are one, two or three bonds apart (1-2, 1-3, 1-4 pairs).

Source: LAMMPS manual, special_bonds.html; the printed block as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.text.number import shortest

if TYPE_CHECKING:
    from pylmp.model.simulation import Simulation


def build_special(sim: Simulation) -> None:
    """Rebuild every atom's lists from its bonds (also those that are turned off or broken), and print what LAMMPS prints.

    1-3 lists are built only if their weights, or those of 1-4 pairs, differ from 1; 1-4 lists only if theirs do.
    """
    settings, atoms = sim.special, sim.atoms
    fourth = settings.lj[2] != 1.0 or settings.coul[2] != 1.0
    third = fourth or settings.lj[1] != 1.0 or settings.coul[1] != 1.0
    near = _bonded(sim)
    shells = [near]
    if third:
        shells.append(_next_shell(near, near))
    if fourth:
        shells.append(_next_shell(near, shells[1]))
    lists = [_without_repeats(tag, [shell.get(tag, []) for shell in shells]) for tag in atoms.tag[: atoms.n].tolist()]
    longest = max((sum(map(len, one)) for one in lists), default=0)
    room = max(longest, 1 + sim.extra_special) + sim.extra_special
    atoms.widen_special(room)
    atoms.special[: atoms.n] = 0
    for row, one in enumerate(lists):
        counts = np.cumsum([len(shell) for shell in one] + [0] * (3 - len(one)))
        atoms.num_special[row] = counts
        flat = [tag for shell in one for tag in shell]
        atoms.special[row, : len(flat)] = flat
    _announce(sim, shells, room)


def _bonded(sim: Simulation) -> dict[int, list[int]]:
    """ID -> IDs it is bonded to, in slot order; each bond seen from both ends."""
    atoms = sim.atoms
    result: dict[int, list[int]] = {}
    tags = atoms.tag[: atoms.n].tolist()
    for row, tag in enumerate(tags):
        partners = atoms.bond_atom[row, : atoms.num_bond[row]].tolist()
        result.setdefault(tag, []).extend(partners)
        if sim.newton_bond:
            for partner in partners:
                result.setdefault(partner, []).append(tag)
    return result


def _next_shell(near: dict[int, list[int]], shell: dict[int, list[int]]) -> dict[int, list[int]]:
    """One bond further than shell, the way back left out."""
    return {
        tag: [far for middle in middles for far in near.get(middle, []) if far != tag] for tag, middles in shell.items()
    }


def _without_repeats(tag: int, shells: list[list[int]]) -> list[list[int]]:
    seen = {tag}
    result = []
    for shell in shells:
        kept = []
        for other in shell:
            if other not in seen:
                seen.add(other)
                kept.append(other)
        result.append(kept)
    return result


def _announce(sim: Simulation, shells: list[dict[int, list[int]]], room: int) -> None:
    lines = ["Finding 1-2 1-3 1-4 neighbors ..."]
    for name, weights in (("lj:   ", sim.special.lj), ("coul: ", sim.special.coul)):
        lines.append(f"  special bond factors {name} " + " ".join(f"{shortest(w):<8}" for w in weights))
    for number, shell in enumerate(shells, 2):
        lines.append(f"{max(map(len, shell.values()), default=0):6d} = max # of 1-{number} neighbors")
    lines.append(f"{room:6d} = max # of special neighbors")
    lines.append("  special bonds CPU = 0.000 seconds")
    sim.console.both("\n".join(lines) + "\n")
