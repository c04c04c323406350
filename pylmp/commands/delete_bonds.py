"""delete_bonds GROUP multi|atom T|bond T|angle T|dihedral T|improper T|stats [any] [undo] [remove] [special]"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.model.bond import bond_pairs
from pylmp.model.ghosts import ghost_cutoff
from pylmp.model.lost import remove_lost
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.text.words import Args, Word

_TYPED = ("atom", "bond", "angle", "dihedral", "improper")


@command("delete_bonds", needs_box=True)
def delete_bonds(sim: Simulation, args: Args) -> None:
    """Turn bonds off or on, remove those that are off or broken, count them."""
    if sim.natoms == 0:
        args.fail("Delete_bonds command with no atoms existing", args.owner)
    if not sim.has_bonds:
        args.fail("Cannot use delete_bonds with non-molecular system", args.owner, hint="atom_style bond")
    if len(args) < 2:
        args.illegal(args.owner, hint="delete_bonds all stats")
    group = args.word()
    bit = sim.groups.bit(group.text)
    if not bit:
        args.fail(f"Group ID {group.text} requested by delete_bonds does not exist", group)
    style = args.word()
    if style.text not in (*_TYPED, "multi", "stats"):
        args.illegal(style, hint="multi atom bond angle dihedral improper stats")
    kinds = range(0)
    if style.text in _TYPED:
        if not len(args):
            args.illegal(style)
        kinds = _kinds(sim, args, style, args.word())
    flags = dict.fromkeys(("any", "undo", "remove", "special"), False)
    while len(args):
        key = args.word()
        if key.text not in flags:
            args.illegal(key, hint="any undo remove special")
        flags[key.text] = True
    _prepare(sim)
    if style.text in ("multi", "atom", "bond"):
        _toggle(sim, style.text, kinds, bit, flags)
    if flags["remove"]:
        _remove(sim, bit, flags["any"])
    _report(sim)
    if flags["special"]:
        build_special(sim)


def _kinds(sim: Simulation, args: Args, style: Word, word: Word) -> range:
    """The range of types. The manual allows type 0 (broken bonds) and *; the release's parser refuses a bound of 0."""
    high = {"atom": sim.atom_types, "bond": sim.bond_types}.get(style.text, 0)
    if style.text == "bond" and word.text in ("0", "*", f"*{high}", f"0*{high}", "0*") and not sim.strict:
        sim.console.warning(
            f"[D003] delete_bonds ... bond {word.text} is of the manual page; LAMMPS 22 Jul 2025 refuses type 0 "
            "(Invalid range string) and removes broken bonds with: delete_bonds all stats remove"
        )
        return range(0, 1 if word.text == "0" else high + 1)
    return args.as_range(word, 0, high)


def _prepare(sim: Simulation) -> None:
    """Init the system, wrap the atoms, and bring what bonds remember back to the atoms."""
    sim.console.both("System init for delete_bonds ...\n")
    sim.init()
    sim.console.both("Deleting bonds ...\n")
    atoms = sim.atoms
    for listed in sim.bond_lists:
        listed.copy_back(sim)
    atoms.clear_ghosts()
    sim.box.wrap(atoms.x[: atoms.n], atoms.image[: atoms.n])
    sim.box.shrink(atoms.x[: atoms.n])
    remove_lost(sim)
    ghost_cutoff(sim, warn=True)


def _ends(sim: Simulation, bit: int, either: bool):  # type: ignore[no-untyped-def]
    """(rows, slots, partner rows, in the group) of every bond slot."""
    rows, slots, partners = bond_pairs(sim, lambda kinds: np.ones(kinds.shape, bool))
    inside = (sim.atoms.mask[: sim.atoms.n] & bit) != 0
    mine, yours = inside[rows], inside[partners] & (partners >= 0)
    return rows, slots, partners, (mine | yours) if either else (mine & yours)


def _toggle(sim: Simulation, style: str, kinds: range, bit: int, flags: dict[str, bool]) -> None:
    atoms = sim.atoms
    rows, slots, partners, chosen = _ends(sim, bit, flags["any"])
    now = atoms.bond_type[rows, slots]
    wanted: NDArray[np.bool_] = chosen
    if style == "bond":
        wanted = wanted & np.isin(np.abs(now), np.arange(kinds.start, kinds.stop))
    elif style == "atom":
        some = np.arange(kinds.start, kinds.stop)
        wanted = wanted & (np.isin(atoms.type[rows], some) | np.isin(atoms.type[partners], some))
    wanted = wanted & ((now < 0) if flags["undo"] else (now > 0))
    atoms.bond_type[rows[wanted], slots[wanted]] = -now[wanted]


def _remove(sim: Simulation, bit: int, either: bool) -> None:
    """Remove slots of type 0 or less, last slot into the hole."""
    atoms = sim.atoms
    rows, slots, _, chosen = _ends(sim, bit, either)
    doomed: dict[int, set[int]] = {}
    off = chosen & (atoms.bond_type[rows, slots] <= 0)
    for row, slot in zip(rows[off].tolist(), slots[off].tolist(), strict=True):
        doomed.setdefault(row, set()).add(int(atoms.bond_atom[row, slot]))
    for row, others in doomed.items():
        slot = 0
        while slot < atoms.num_bond[row]:
            if atoms.bond_type[row, slot] <= 0 and int(atoms.bond_atom[row, slot]) in others:
                atoms.drop_slot(row, slot)
            else:
                slot += 1
    whole = int(atoms.num_bond[: atoms.n].sum())
    sim.bonds = whole if sim.newton_bond else whole // 2


def _report(sim: Simulation) -> None:
    atoms = sim.atoms
    used = np.arange(atoms.bond_per_atom)[None, :] < atoms.num_bond[: atoms.n, None]
    kinds: Any = atoms.bond_type[: atoms.n][used]
    on, off = int((kinds > 0).sum()), int((kinds <= 0).sum())
    if not sim.newton_bond:
        on, off = on // 2, off // 2
    sim.console.both(f"  {sim.bonds} total bonds, {on} turned on, {off} turned off\n")
    if sim.atom_style == "molecular":
        for name in ("angles", "dihedrals", "impropers"):
            sim.console.both(f"  0 total {name}, 0 turned on, 0 turned off\n")
