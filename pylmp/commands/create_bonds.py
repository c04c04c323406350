"""create_bonds many GROUP1 GROUP2 TYPE RMIN RMAX | single/bond TYPE ATOM1 ATOM2 [special yes|no]"""

from __future__ import annotations

import numpy as np

from pylmp.io.neighbor_info import Request
from pylmp.io.ready import initialise, wrap_atoms
from pylmp.kernels.exact import INDEX_MASK
from pylmp.kernels.exact.neighbor import FULL
from pylmp.kernels.store import prepare
from pylmp.model.atoms import Ints
from pylmp.model.ghosts import Ghosts
from pylmp.model.neighbor import NeighborList
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_SINGLE = {"single/bond": 2, "single/angle": 3, "single/dihedral": 4, "single/improper": 4}


@command("create_bonds", needs_box=True)
def create_bonds(sim: Simulation, args: Args) -> None:
    """Bond all pairs of two groups within a range of distances, or two atoms."""
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
    _check_type(sim, args, "bond", kind, type_word)

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
    total = int(sim.atoms.num_bond[: sim.atoms.n].sum())
    sim.bonds = total if sim.newton_bond else total // 2
    sim.console.both(f"Added {sim.bonds - before} bonds, new total = {sim.bonds}\n")
    build_special(sim)


def _pairs(sim: Simulation, bits: list[int], low: float, high: float) -> tuple[Ints, Ints]:
    """Rows of the atoms that store a new bond, and its other ends, in the order of LAMMPS's full neighbor list."""
    atoms = sim.atoms
    ghosts, neighbors = Ghosts(sim), NeighborList(sim, FULL)
    prepare([*ghosts.functions(), *neighbors.functions()], sim.console.screen)
    cutoff = wrap_atoms(sim, ghosts)
    neighbors.build(sim, cutoff)
    rows = np.repeat(np.arange(atoms.n), np.diff(neighbors.first))
    others = (neighbors.neighbors[: neighbors.count] & INDEX_MASK).astype(np.int64)
    d = atoms.x[rows] - atoms.x[others]
    r2 = d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]
    first, second = ((atoms.mask & bit) != 0 for bit in bits)
    take = (first[rows] & second[others]) | (first[others] & second[rows])
    take &= (r2 >= low * low) & (r2 <= high * high)
    if sim.newton_bond:
        take &= atoms.tag[rows] < atoms.tag[others]
    rows, others = rows[take], others[take]
    tags = atoms.tag[others]
    atoms.clear_ghosts()
    return rows, tags


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
    what = style.text.removeprefix("single/")
    type_word = args.word()
    kind = args.as_integer(type_word)
    args.need(_SINGLE[style.text])
    ends = [args.word() for _ in range(_SINGLE[style.text])]
    tags = [args.as_integer(word) for word in ends]
    if len(set(tags)) < len(tags):
        args.fail(f"{what.capitalize()} atoms must be different", ends[-1])
    finds_special = True
    while len(args):
        key = args.word()
        if key.text != "special":
            args.illegal(key, hint="special yes|no")
        if not len(args):
            args.illegal(key, hint="special yes|no")
        finds_special = args.yes()
    _check_type(sim, args, what, kind, type_word)
    _bond(sim, args, kind, ends, tags)
    if finds_special:
        build_special(sim)


def _bond(sim: Simulation, args: Args, kind: int, ends: list[Word], tags: list[int]) -> None:
    atoms = sim.atoms
    by_tag = atoms.rows_by_tag()
    rows = [int(by_tag[tag]) if 0 < tag < len(by_tag) else -1 for tag in tags]
    if min(rows) < 0:
        args.fail("Create_bonds single/bond atoms do not exist", ends[0 if rows[0] < 0 else 1])
    for row, partner in (rows[0], tags[1]), (rows[1], tags[0]):
        slot = int(atoms.num_bond[row])
        if slot == atoms.bond_per_atom:
            args.fail(
                "New bond exceeded bonds per atom in create_bonds", args.owner,
                hint="a larger extra/bond/per/atom in create_box or read_data",
            )  # fmt: skip
        atoms.bond_type[row, slot] = kind
        atoms.bond_atom[row, slot] = partner
        atoms.bond_history[row, slot] = 0.0
        atoms.num_bond[row] = slot + 1
        if sim.newton_bond:
            break
    sim.bonds += 1


def _check_type(sim: Simulation, args: Args, what: str, kind: int, word: Word) -> None:
    types = sim.bond_types if what == "bond" else 0
    if not 1 <= kind <= types:
        args.fail(f"Invalid {what} type in create_bonds command", word, hint=f"{what} types are 1 to {types}")
