"""create_bonds many GROUP1 GROUP2 TYPE RMIN RMAX, create_bonds single/bond TYPE ID1 ID2 [special yes|no]"""

from __future__ import annotations

import numpy as np

from pylmp.io.neighbor_info import Request, announce
from pylmp.kernels.exact.neighbor import FULL
from pylmp.model.ghosts import Ghosts, ghost_cutoff
from pylmp.model.lost import remove_lost
from pylmp.model.neighbor import NeighborList
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word


@command("create_bonds", needs_box=True)
def create_bonds(sim: Simulation, args: Args) -> None:
    """Bond all pairs of two groups within a range of distances, or one pair."""
    if sim.atoms.n == 0:
        args.fail("Create_bonds command with no atoms existing", args.owner)
    if not sim.has_bonds:
        args.fail("Cannot use create_bonds with non-molecular system", args.owner, hint="atom_style bond")
    if len(args) < 4:
        args.illegal(args.owner, hint="create_bonds many G1 G2 TYPE RMIN RMAX")
    style = args.word()
    if style.text in ("single/angle", "single/dihedral", "single/improper"):
        raise Unsupported(f"LAMMPS has create_bonds {style.text}, pylmp's native engines do not", style.span)
    if style.text == "many":
        _many(sim, args)
    elif style.text == "single/bond":
        _single(sim, args)
    else:
        args.illegal(style, hint="many or single/bond")


def _type(sim: Simulation, args: Args, word: Word) -> int:
    kind = args.as_integer(word)
    if not 1 <= kind <= sim.bond_types:
        args.fail("Invalid bond type in create_bonds command", word, hint=f"bond types are 1 to {sim.bond_types}")
    return kind


def _single(sim: Simulation, args: Args) -> None:
    if len(args) < 3:
        args.illegal(args.owner)
    kind = _type(sim, args, args.word())
    words = args.word(), args.word()
    first, second = (args.as_integer(word) for word in words)
    special = True
    while len(args):
        key = args.word()
        if key.text != "special" or not len(args):
            args.illegal(key, hint="special yes|no")
        special = args.yes()
    if first == second:
        args.fail("Bond atoms must be different", words[1])
    rows = sim.atoms.rows_by_tag()
    found = [int(rows[tag]) if 0 < tag < len(rows) else -1 for tag in (first, second)]
    if min(found) < 0:
        args.fail("Create_bonds single/bond atoms do not exist", words[0 if found[0] < 0 else 1])
    _store(sim, args, found[0], kind, second)
    if not sim.newton_bond:
        _store(sim, args, found[1], kind, first)
    sim.bonds += 1
    if special:
        build_special(sim)


def _store(sim: Simulation, args: Args, row: int, kind: int, partner: int) -> None:
    atoms = sim.atoms
    slot = int(atoms.num_bond[row])
    if slot >= atoms.bond_per_atom:
        args.fail("New bond exceeded bonds per atom in create_bonds", args.owner, hint="extra/bond/per/atom in create_box")
    atoms.bond_type[row, slot], atoms.bond_atom[row, slot] = kind, partner
    atoms.bond_history[row, slot] = 0.0
    atoms.num_bond[row] = slot + 1


def _many(sim: Simulation, args: Args) -> None:
    if len(args) < 5:
        args.illegal(args.owner, hint="create_bonds many G1 G2 TYPE RMIN RMAX")
    names = args.word(), args.word()
    bits = [sim.groups.bit(name.text) for name in names]
    for name, bit in zip(names, bits, strict=True):
        if not bit:
            args.fail(f"Group ID {name.text} requested by create_bonds does not exist", name)
    kind = _type(sim, args, args.word())
    words = args.word(), args.word()
    low, high = (args.as_number(word) for word in words)
    if low > high:
        args.fail("Inconsistent cutoffs for create_bonds many", words[0], hint="rmin comes first")
    if len(args):
        args.fail("No optional keywords allowed with create_bonds many", args.peek())
    _check(sim, args, words[1], high)
    listed = _full_list(sim)
    rows, partners = _pairs(sim, listed, bits, low, high)
    before = _count(sim)
    for row, partner in zip(rows.tolist(), partners.tolist(), strict=True):
        if sim.atoms.num_bond[row] >= sim.atoms.bond_per_atom:
            args.fail(
                f"New bond exceeded bonds per atom limit  of {sim.atoms.bond_per_atom} in create_bonds", args.owner,
                hint="extra/bond/per/atom in create_box",
            )  # fmt: skip
        _store(sim, args, row, kind, partner)
    sim.atoms.clear_ghosts()
    added = (_count(sim) - before) // (1 if sim.newton_bond else 2)
    sim.bonds += added
    sim.console.both(f"Added {added} bonds, new total = {sim.bonds}\n")
    build_special(sim)


def _check(sim: Simulation, args: Args, word: Word, high: float) -> None:
    """What must hold before pairs can be listed; ends with the system's own init."""
    if sim.pair is None:
        args.fail("Create_bonds requires a pair style be defined", args.owner, hint="pair_style zero CUTOFF will do")
    if sim.special.lj[0] != 0.0 or sim.special.coul[0] != 0.0:
        args.fail(
            "Create_bonds command requires special_bonds 1-2 weights be 0.0", args.owner,
            hint="special_bonds lj/coul 0 1 1 before, the weights of the run after",
        )  # fmt: skip
    sim.init()
    if high > sim.neighbor_cutoff:
        args.fail("Create_bonds max distance > neighbor cutoff", word, hint="a larger pair cutoff or skin")


def _full_list(sim: Simulation) -> NeighborList:
    """Wrap atoms, make ghosts, list all neighbors of all atoms."""
    atoms = sim.atoms
    requests = (Request("command create_bonds", True, True), Request(f"pair {sim.pair.style.name}"))
    announce(sim, requests)
    atoms.clear_ghosts()
    sim.box.wrap(atoms.x[: atoms.n], atoms.image[: atoms.n])
    sim.box.shrink(atoms.x[: atoms.n])
    remove_lost(sim)
    cutoff = ghost_cutoff(sim, warn=True)
    Ghosts(sim).build(sim, cutoff)
    listed = NeighborList(sim, FULL)
    listed.build(sim, cutoff)
    return listed


def _pairs(sim: Simulation, listed: NeighborList, bits: list[int], low: float, high: float):  # type: ignore[no-untyped-def]
    """(rows, partner IDs) of the new slots in list order; distances are inclusive."""
    atoms = sim.atoms
    rows = np.repeat(np.arange(atoms.n), np.diff(listed.first))
    others = listed.neighbors[: listed.count].astype(np.int64)
    mine, yours = atoms.mask[rows], atoms.mask[others]
    wanted = ((mine & bits[0]) != 0) & ((yours & bits[1]) != 0) | ((mine & bits[1]) != 0) & ((yours & bits[0]) != 0)
    if sim.newton_bond:
        wanted &= atoms.tag[rows] < atoms.tag[others]
    d = atoms.x[rows] - atoms.x[others]
    r2 = d[:, 0] * d[:, 0] + d[:, 1] * d[:, 1] + d[:, 2] * d[:, 2]
    wanted &= (r2 >= low * low) & (r2 <= high * high)
    return rows[wanted], atoms.tag[others[wanted]]


def _count(sim: Simulation) -> int:
    return int(sim.atoms.num_bond[: sim.atoms.n].sum())
