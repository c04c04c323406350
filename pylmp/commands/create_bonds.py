"""create_bonds many GROUP1 GROUP2 TYPE RMIN RMAX | single/bond TYPE ATOM1 ATOM2 [special yes|no]

single/angle TYPE A B C, single/dihedral and single/improper TYPE A B C D alike.
"""

from __future__ import annotations

import numpy as np

from pylmp.io.neighbor_info import Request
from pylmp.io.ready import full_list, initialise
from pylmp.model.atoms import Ints
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.model.topology import BOND, KINDS, Kind, crowd, store
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_SINGLE = {f"single/{kind.name}": kind for kind in KINDS}


@command("create_bonds", needs_box=True)
def create_bonds(sim: Simulation, args: Args) -> None:
    """Bond all pairs of two groups within a range of distances; or make one bond, angle, dihedral or improper."""
    if not sim.has_bonds:
        args.fail(
            "Cannot use create_bonds with non-molecular system", args.owner, hint="atom_style bond, before the box"
        )
    if len(args) < 4:
        args.missing(hint="create_bonds many GROUP1 GROUP2 TYPE RMIN RMAX, or single/bond TYPE ATOM1 ATOM2")
    style = args.word()
    if style.text == "many":
        _many(sim, args)
    elif style.text in _SINGLE:
        _single(sim, args, style)
    else:
        args.illegal(style, hint="many or single/bond")


def _many(sim: Simulation, args: Args) -> None:
    if len(args) != 5:
        word = args.words[6] if len(args) > 5 else args.words[-1]
        args.fail("No optional keywords allowed with create_bonds many", word, hint="GROUP1 GROUP2 TYPE RMIN RMAX")
    groups = [args.word(), args.word()]
    bits = [sim.groups.bit(word.text) for word in groups]
    for word, bit in zip(groups, bits, strict=True):
        if bit == 0:
            args.fail(f"Group ID {word.text} requested by create_bonds does not exist", word)
    type_word, low_word, high_word = args.word(), args.word(), args.word()
    kind, low, high = args.as_integer(type_word), args.as_number(low_word), args.as_number(high_word)
    if low > high:
        args.fail("Inconsistent cutoffs for create_bonds many", low_word, hint="the smaller distance comes first")
    _check_type(sim, args, BOND, kind, type_word)

    initialise(sim, Request("command create_bonds", full=True, occasional=True))
    if sim.pair is None:
        args.fail("Create_bonds requires a pair style be defined", args.owner, hint="pair_style zero is enough")
    shortest, longest = (float(cut) + sim.neighbor.skin for cut in (sim.pair.cut[1:, 1:].min(), sim.pair.cut.max()))
    if high > longest:
        args.fail("Create_bonds max distance > neighbor cutoff", high_word, hint=f"at most {longest:g}")
    if high > shortest:
        sim.console.warning("Create_bonds max distance > minimum neighbor cutoff")
    if sim.special.lj[0] != 0.0 or sim.special.coul[0] != 0.0:
        args.fail(
            "Create_bonds command requires special_bonds 1-2 weights be 0.0",
            args.owner,
            hint="special_bonds lj/coul 0 1 1",
        )
    rows, others = _pairs(sim, bits, low, high)
    before = sim.bonds
    _append(sim, rows, others, kind)
    BOND.recount(sim)
    sim.console.both(f"Added {sim.bonds - before} bonds, new total = {sim.bonds}\n")
    build_special(sim)


def _pairs(sim: Simulation, bits: list[int], low: float, high: float) -> tuple[Ints, Ints]:
    """Rows of the atoms that store a new bond, and its other ends, in the order of LAMMPS's full neighbor list."""
    atoms = sim.atoms
    found, partners = [np.zeros(0, np.int64)], [np.zeros(0, np.int64)]
    first = second = np.zeros(0, bool)
    for rows, others, r2 in full_list(sim):
        if not len(first):
            first, second = ((atoms.mask & bit) != 0 for bit in bits)
        take = (first[rows] & second[others]) | (first[others] & second[rows])
        take &= (r2 >= low * low) & (r2 <= high * high)
        if sim.newton_bond:
            take &= atoms.tag[rows] < atoms.tag[others]
        found.append(rows[take])
        partners.append(atoms.tag[others[take]])
    atoms.clear_ghosts()
    return np.concatenate(found), np.concatenate(partners)


def _append(sim: Simulation, rows: Ints, partners: Ints, kind: int) -> None:
    """New slots for bonds of rows (ascending) with atoms of these IDs."""
    atoms = sim.atoms
    new = np.bincount(rows, minlength=atoms.n)
    if (atoms.num_bond[: atoms.n] + new > atoms.bond_per_atom).any():
        raise ScriptError(
            f"New bond exceeded bonds per atom limit of {atoms.bond_per_atom} in create_bonds",
            hint="a larger extra/bond/per/atom in create_box or read_data", manual="create_bonds.html",
        )  # fmt: skip
    slots = atoms.num_bond[rows] + np.arange(len(rows)) - np.repeat(np.cumsum(new) - new, new)
    atoms.bond_type[rows, slots] = kind
    atoms.bond_atom[rows, slots] = partners
    atoms.bond_history[rows, slots] = 0.0
    atoms.num_bond[: atoms.n] += new


def _single(sim: Simulation, args: Args, style: Word) -> None:
    kind = _SINGLE[style.text]
    if len(args) < kind.size + 1:
        args.fail(f"Illegal create_bonds {style.text} command: missing argument(s)", args.words[-1], hint="the type, then atom IDs")
    type_word = args.word()
    type_ = args.as_integer(type_word)
    ends = [args.word() for _ in range(kind.size)]
    tags = [args.as_integer(word) for word in ends]
    if len(set(tags)) < len(tags):
        says = f"{kind.name.capitalize()} atoms must be different" if kind.size < 4 else "Illegal create_bonds command"
        args.fail(says, ends[-1], hint="no atom twice")
    finds_special = True
    while len(args):
        key = args.word()
        if key.text != "special" or not len(args):
            args.illegal(key, hint="special yes|no")
        finds_special = args.yes()
    _check_type(sim, args, kind, type_, type_word)
    _add(sim, args, kind, type_, ends, tags)
    if finds_special:
        build_special(sim)


def _add(sim: Simulation, args: Args, kind: Kind, type_: int, ends: list[Word], tags: list[int]) -> None:
    atoms = sim.atoms
    by_tag = atoms.rows_by_tag()
    for word, tag in zip(ends, tags, strict=True):
        if not 0 < tag < len(by_tag) or by_tag[tag] < 0:
            args.fail(f"Create_bonds single/{kind.name} atoms do not exist", word)
    table = np.array([tags])
    full = kind.numbers(sim)[: atoms.n] + crowd(sim, kind, table) > atoms.slots(kind.name)
    if full.any():
        args.fail(
            f"New {kind.name} exceeded {kind.plural} per atom in create_bonds", args.owner,
            hint=f"a larger extra/{kind.name}/per/atom in create_box or read_data",
        )  # fmt: skip
    store(sim, kind, np.array([type_]), table)
    kind.set_total(sim, kind.total(sim) + 1)


def _check_type(sim: Simulation, args: Args, kind: Kind, type_: int, word: Word) -> None:
    types = kind.types(sim)
    if not 1 <= type_ <= types:
        args.fail(f"Invalid {kind.name} type in create_bonds command", word, hint=f"{kind.name} types are 1 to {types}")
