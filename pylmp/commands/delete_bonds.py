"""delete_bonds GROUP multi|atom|bond|angle|dihedral|improper|stats [TYPES] [any] [undo] [remove] [special]"""

from __future__ import annotations

import re

import numpy as np
from numpy.typing import NDArray

from pylmp.io.ready import initialise, wrap_atoms
from pylmp.model.bond import bond_pairs
from pylmp.model.ghosts import Ghosts
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_STYLES = ("multi", "atom", "bond", "angle", "dihedral", "improper", "stats")
_KEYWORDS = ("any", "undo", "remove", "special")


@command("delete_bonds", needs_box=True)
def delete_bonds(sim: Simulation, args: Args) -> None:
    """Turn bonds off or on, or remove those that are off or broken; always count them."""
    if sim.natoms == 0:
        args.fail(
            "Delete_bonds command with no atoms existing", args.owner, hint="create_atoms or read_data comes first"
        )
    if not sim.has_bonds:
        args.fail("Cannot use delete_bonds with non-molecular system", args.owner, hint="atom_style bond")
    if len(args) < 2:
        args.illegal(args.owner, hint="delete_bonds GROUP STYLE ...")
    sim.console.both("System init for delete_bonds ...\n")
    initialise(sim)
    sim.console.both("Deleting bonds ...\n")
    name, style = args.word(), args.word()
    bit = sim.groups.bit(name.text)
    if bit == 0:
        args.fail(f"Group ID {name.text} requested by delete_bonds does not exist", name)
    if style.text not in _STYLES:
        args.illegal(style, hint=" ".join(_STYLES))
    types = _types(sim, args, style)
    words = args.rest()
    for word in words:
        if word.text not in _KEYWORDS:
            args.illegal(word, hint=" ".join(_KEYWORDS))
    options = {word.text for word in words}
    # IDs of new ghosts stay in the rows beyond the owned atoms, where the bond lists of the last run look when the next run
    # takes over what they remember: like LAMMPS, it finds the bonds whose ends still are in the same rows.
    wrap_atoms(sim, Ghosts(sim) if any(listed.memory for listed in sim.bond_lists) else None)
    sim.atoms.clear_ghosts()

    if style.text != "stats" or "remove" in options:
        _change(sim, style.text, types, bit, options)
    _report(sim)
    if "special" in options:
        build_special(sim)


def _change(sim: Simulation, style: str, types: range, bit: int, options: set[str]) -> None:
    """Turn the chosen bonds off or on; remove the group's bonds that are off or broken."""
    rows, slots, partners = _members(sim, bit, "any" in options)
    chosen = _chosen(sim, style, types, rows, slots, partners)
    _toggle(sim, rows[chosen], slots[chosen], undo="undo" in options)
    if "remove" in options:
        _remove(sim, rows, slots)
        total = int(sim.atoms.num_bond[: sim.atoms.n].sum())
        sim.bonds = total if sim.newton_bond else total // 2


def _types(sim: Simulation, args: Args, style: Word) -> range:
    """The type range of a style that takes one. 0 and ``*``, which only the manual knows, begin at type 0 (broken bonds)."""
    counts = {"atom": sim.atom_types, "bond": sim.bond_types}
    if style.text in ("multi", "stats"):
        return range(0)
    if not len(args):
        args.illegal(style, hint=f"delete_bonds GROUP {style.text} TYPES")
    word = args.word()
    high = counts.get(style.text, 0)
    departs = re.fullmatch(r"0+|0*\*\d*|0+\*\d+", word.text)
    if departs is None or sim.strict:
        return args.as_range(word, 0, high)
    first, star, last = word.text.partition("*")
    stop = int(last) if last else (high if star else 0)
    if stop > high:
        args.fail(f"Numeric index {stop} is out of bounds (0-{high})", word)
    sim.console.warning(
        f"[D003] delete_bonds ... {style.text} {word.text} is of the manual page; LAMMPS 22 Jul 2025 refuses types that begin "
        "at 0. Broken bonds are removed there by: delete_bonds all stats remove"
    )
    return range(stop + 1)


def _members(sim: Simulation, bit: int, any_end: bool) -> tuple[NDArray[np.int64], ...]:
    """(rows, slots, partner rows) of bonds with both ends in the group; with any_end, with at least one."""
    rows, slots, partners = bond_pairs(sim, lambda kinds: np.ones(kinds.shape, bool))
    if (partners < 0).any():
        k = int(np.argmax(partners < 0))
        atoms = sim.atoms
        raise ScriptError(
            "Bond atom missing in delete_bonds",
            hint=f"atom {int(atoms.bond_atom[rows[k], slots[k]])}, bonded to {int(atoms.tag[rows[k]])}, was lost",
        )
    mask = (sim.atoms.mask[: sim.atoms.n] & bit) != 0
    keep = (mask[rows] | mask[partners]) if any_end else (mask[rows] & mask[partners])
    return rows[keep], slots[keep], partners[keep]


def _chosen(
    sim: Simulation,
    style: str,
    types: range,
    rows: NDArray[np.int64],
    slots: NDArray[np.int64],
    partners: NDArray[np.int64],
) -> NDArray[np.bool_]:
    """(k,) bool: which of these bonds the style selects."""
    atoms = sim.atoms
    if style == "multi":
        return np.ones(len(rows), bool)
    wanted = np.array(types, np.int64)
    if style == "atom":
        return np.isin(atoms.type[rows], wanted) | np.isin(atoms.type[partners], wanted)
    if style == "bond":
        return np.isin(np.abs(atoms.bond_type[rows, slots]), wanted)
    return np.zeros(len(rows), bool)


def _toggle(sim: Simulation, rows: NDArray[np.int64], slots: NDArray[np.int64], undo: bool) -> None:
    """Off is a negative type; a broken bond (0) is neither turned off nor on."""
    kinds = sim.atoms.bond_type[rows, slots]
    sim.atoms.bond_type[rows, slots] = np.abs(kinds) if undo else -np.abs(kinds)


def _remove(sim: Simulation, rows: NDArray[np.int64], slots: NDArray[np.int64]) -> None:
    """Drop the slots of these bonds that are off or broken. A slot that moves into a hole is looked at in its turn."""
    atoms = sim.atoms
    off = atoms.bond_type[rows, slots] <= 0
    gone: dict[int, set[int]] = {}
    for row, slot in zip(rows[off].tolist(), slots[off].tolist(), strict=True):
        gone.setdefault(row, set()).add(slot)
    for row, doomed in gone.items():
        slot = 0
        while slot < atoms.num_bond[row]:
            if slot not in doomed:
                slot += 1
                continue
            last = int(atoms.num_bond[row]) - 1
            atoms.drop_slot(row, slot)
            doomed.discard(slot)
            if last in doomed:
                doomed.discard(last)
                doomed.add(slot)


def _report(sim: Simulation) -> None:
    atoms = sim.atoms
    used = np.arange(atoms.bond_per_atom)[None, :] < atoms.num_bond[: atoms.n, None]
    kinds = atoms.bond_type[: atoms.n]
    on, off = int((used & (kinds > 0)).sum()), int((used & (kinds <= 0)).sum())
    if not sim.newton_bond:
        on, off = on // 2, off // 2
    lines = [f"  {sim.bonds} total bonds, {on} turned on, {off} turned off"]
    if sim.atom_style == "molecular":
        lines += [f"  0 total {kind}, 0 turned on, 0 turned off" for kind in ("angles", "dihedrals", "impropers")]
    sim.console.both("\n".join(lines) + "\n")
