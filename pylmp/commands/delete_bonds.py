"""delete_bonds GROUP multi|atom|bond|angle|dihedral|improper|stats [TYPES] [any] [undo] [remove] [special]"""

from __future__ import annotations

import re

import numpy as np
from numpy.typing import NDArray

from pylmp.io.ready import initialise, wrap_atoms
from pylmp.model.ghosts import Ghosts
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.model.topology import KIND, Entries, Kind, entries
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_STYLES = ("multi", "atom", "bond", "angle", "dihedral", "improper", "stats")
_KEYWORDS = ("any", "undo", "remove", "special")


@command("delete_bonds", needs_box=True)
def delete_bonds(sim: Simulation, args: Args) -> None:
    """Turn bonds, angles, dihedrals, impropers off or on, or remove those that are off or broken; always count them."""
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

    for kind in sim.style.kinds:
        _change(sim, kind, style.text, types, bit, options)
    if "remove" in options:
        for kind in sim.style.kinds:
            _remove(sim, kind, bit, options)
    _report(sim)
    if "special" in options:
        build_special(sim)


def _types(sim: Simulation, args: Args, style: Word) -> range:
    """The type range of a style that takes one. 0 and ``*``, which only the manual knows, begin at type 0 (broken bonds)."""
    if style.text in ("multi", "stats"):
        return range(0)
    if not len(args):
        args.illegal(style, hint=f"delete_bonds GROUP {style.text} TYPES")
    sim.labels.translate(args, style.text)
    word = args.word()
    high = sim.atom_types if style.text == "atom" else KIND[style.text].types(sim)
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


def _change(sim: Simulation, kind: Kind, style: str, types: range, bit: int, options: set[str]) -> None:
    """Turn the chosen ones of a kind off, or on. Off is a negative type; 0, a broken bond, is neither turned off nor on."""
    if style not in ("multi", "atom", kind.name):
        return
    found = entries(sim, kind)
    found = found.take(_in_group(sim, found, bit, options))
    wanted = np.array(types, np.int64)
    if style == "atom":
        found = found.take(np.isin(sim.atoms.type[found.at(sim)], wanted).any(axis=1))
    elif style == kind.name:
        found = found.take(np.isin(np.abs(found.types), wanted))
    switched = np.abs(found.types)
    kind.kinds(sim)[found.rows, found.slots] = switched if "undo" in options else -switched


def _in_group(sim: Simulation, found: Entries, bit: int, options: set[str]) -> NDArray[np.bool_]:
    """(k,) bool: all atoms are in the group; with any, at least one. Raises ScriptError where one was lost."""
    at = found.at(sim)
    lost = (at < 0).any(axis=1)
    if lost.any():
        k = int(np.argmax(lost))
        gone = " ".join(str(tag) for tag in found.tags[k][at[k] < 0])
        raise ScriptError(
            f"{found.kind.name.capitalize()} atom missing in delete_bonds",
            hint=f"atom {gone}, bonded to {int(sim.atoms.tag[found.rows[k]])}, was lost",
        )
    inside = (sim.atoms.mask[at] & bit) != 0
    return np.asarray(inside.any(axis=1) if "any" in options else inside.all(axis=1))


def _remove(sim: Simulation, kind: Kind, bit: int, options: set[str]) -> None:
    """Drop the group's slots of a kind that are off or broken. A slot that moves into a hole is looked at in its turn."""
    found = entries(sim, kind, lambda types: types <= 0)
    found = found.take(_in_group(sim, found, bit, options))
    gone: dict[int, set[int]] = {}
    for row, slot in zip(found.rows.tolist(), found.slots.tolist(), strict=True):
        gone.setdefault(row, set()).add(slot)
    used = kind.numbers(sim)
    for row, doomed in gone.items():
        slot = 0
        while slot < used[row]:
            if slot not in doomed:
                slot += 1
                continue
            last = int(used[row]) - 1
            sim.atoms.drop_slot(row, slot, kind.name)
            doomed.discard(slot)
            if last in doomed:
                doomed.discard(last)
                doomed.add(slot)
    kind.recount(sim)


def _report(sim: Simulation) -> None:
    for kind in sim.style.kinds:
        types = entries(sim, kind).types
        share = 1 if sim.newton_bond else kind.size
        on, off = int((types > 0).sum()) // share, int((types <= 0).sum()) // share
        sim.console.both(f"  {kind.total(sim)} total {kind.plural}, {on} turned on, {off} turned off\n")
