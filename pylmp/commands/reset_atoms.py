"""reset_atoms id [sort yes|no], reset_atoms mol GROUP keywords..., reset_atoms image GROUP

Keywords of mol: compress yes|no, single yes|no, offset N. Source: LAMMPS manual, reset_atoms.html.
"""

from __future__ import annotations

import numpy as np

from pylmp.io.ready import initialise, wrap_atoms
from pylmp.model.atoms import Floats, Ints
from pylmp.model.fragments import fragments
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.model.topology import BOND, entries
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_PER_BIN, _MARGIN = 10, 0.0001


@command("reset_atoms", needs_box=True)
def reset_atoms(sim: Simulation, args: Args) -> None:
    """Number atoms or molecules anew, or bring image flags near zero."""
    word = args.word()
    if word.text not in _PARTS:
        args.fail(f"Unknown command: reset_atoms {' '.join(w.text for w in args.words)}", word, hint="id mol image")
    inner = Args(f"reset_atoms {word.text}", args.rest(), word, args.manual)
    _PARTS[word.text](sim, inner)


def renamed(sim: Simulation, args: Args, name: str, part: str) -> None:
    """An older name of reset_atoms PART."""
    sim.console.both("\n")
    sim.console.warning(f"'{name}' has been renamed to 'reset_atoms {part}'. Please update your input.")
    sim.console.both("\n")
    line = " ".join(["reset_atoms", part, *(word.text for word in args.rest())])
    sim.script.execute(line, args.owner.span if args.owner else None)


def _prepare(sim: Simulation) -> None:
    initialise(sim)
    wrap_atoms(sim)


def _group(sim: Simulation, args: Args, name: Word) -> int:
    bit = sim.groups.bit(name.text)
    if not bit:
        args.fail(f"Could not find {args.what} group {name.text}", name)
    return bit


# ---- atom IDs ---------------------------------------------------------------------------------------------------


def _id(sim: Simulation, args: Args) -> None:
    sim.console.both("Resetting atom IDs ...\n")
    sort = False
    while len(args):
        key = args.word()
        if key.text != "sort":
            args.fail(f"Unknown reset_atoms id keyword: {key.text}", key, hint="sort yes|no")
        args.need(1)
        sort = args.yes()
    _prepare(sim)
    atoms, n = sim.atoms, sim.atoms.n
    order = _spatial(sim) if sort and n else np.arange(n)
    new = np.zeros(int(atoms.tag[:n].max(initial=0)) + 1, np.int64)
    new[atoms.tag[order]] = np.arange(1, n + 1)
    found = [entries(sim, kind) for kind in sim.style.kinds]
    missing = sum(int((each.at(sim) < 0).sum()) for each in found)
    if missing:
        raise ScriptError(
            f"reset_atoms id is missing {missing} bond topology atom IDs - use comm_modify cutoff",
            hint="bonds to atoms that are gone: delete_atoms ... bond yes",
        )
    for each in found:
        tags = new[each.tags]
        each.kind.members(sim)[each.rows, each.slots] = tags[:, 1] if each.kind is BOND else tags
    atoms.tag[:n] = new[atoms.tag[:n]]
    if sim.has_bonds:
        build_special(sim)


def _spatial(sim: Simulation) -> Ints:
    """Rows in bins of about ten atoms, z slowest, then y, then x; within a bin by x, then y, then z."""
    x: Floats = sim.atoms.x[: sim.atoms.n]
    lo, hi = x.min(axis=0), x.max(axis=0)
    flat = lo == hi
    lo, hi = np.where(flat, lo - 0.5, lo), np.where(flat, hi + 0.5, hi)
    lo = lo - _MARGIN * (hi - lo)
    hi = hi + _MARGIN * (hi - lo)
    length = hi - lo
    size = float(length[0] * length[1] * length[2] / (sim.natoms // _PER_BIN + 1)) ** (1.0 / sim.dimension)
    count = (length / size).astype(np.int64) + 1
    cell = ((x - lo) * (1.0 / length) * count).astype(np.int64)
    place = (cell[:, 2] * count[1] + cell[:, 1]) * count[0] + cell[:, 0]
    return np.lexsort((x[:, 2], x[:, 1], x[:, 0], place))


# ---- molecule IDs -----------------------------------------------------------------------------------------------


def _mol(sim: Simulation, args: Args) -> None:
    if not sim.has_bonds:
        args.fail("Can only use reset_atoms mol on molecular systems", args.owner)
    name = args.word()
    compress, single, offset = True, False, -1
    while len(args):
        key = args.word()
        if key.text not in ("compress", "single", "offset"):
            args.fail(f"Unknown reset_atoms mol keyword: {key.text}", key, hint="compress single offset")
        args.need(1, key.text)
        if key.text == "compress":
            compress = args.yes()
        elif key.text == "single":
            single = args.yes()
        else:
            offset = args.integer()
            if offset < -1:
                args.fail(f"Illegal reset_atoms mol offset: {offset}", hint="0 or more, or -1")
    sim.console.both("Resetting molecule IDs ...\n")
    _prepare(sim)
    bit = _group(sim, args, name)
    atoms, n = sim.atoms, sim.atoms.n
    chosen, molecule = (atoms.mask[:n] & bit) != 0, atoms.molecule[:n]
    molecule[chosen] = fragments(sim, chosen, single)[chosen]
    count = "unknown"
    if compress:
        if np.isin(molecule[~chosen], molecule[chosen]).any():
            sim.console.warning("One or more chunks do not contain all atoms in molecule")
        if offset < 0:
            offset = 0 if name.text == "all" else int(molecule[~chosen].max(initial=0))
        known = np.unique(molecule[chosen & (molecule > 0)])
        inside = chosen & (molecule > 0)
        molecule[inside] = np.searchsorted(known, molecule[inside]) + 1 + offset
        count = str(len(known))
    sim.console.both(f"  number of new molecule IDs = {count}\n  reset_atoms mol CPU = 0.000 seconds\n")


# ---- image flags ------------------------------------------------------------------------------------------------


def _image(sim: Simulation, args: Args) -> None:
    """Atoms of the group move by the mean of the smallest and the largest flag of their fragment, of all its atoms."""
    if not sim.has_bonds:
        args.fail("Cannot use reset_atoms image used when bonds are not allowed", args.owner)
    name = args.word()
    if len(args):
        word = args.word()
        args.fail(f"Unknown reset_atoms image keyword: {word.text}", word)
    bit = _group(sim, args, name)
    sim.console.both("Resetting image flags ...\n")
    _prepare(sim)
    atoms, n = sim.atoms, sim.atoms.n
    _, which = np.unique(fragments(sim, np.ones(n, bool), single=True), return_inverse=True)
    flags, size = atoms.image[:n], int(which.max(initial=-1)) + 1
    least, most = np.full((size, 3), np.iinfo(np.int64).max), np.full((size, 3), np.iinfo(np.int64).min)
    np.minimum.at(least, which, flags)
    np.maximum.at(most, which, flags)
    chosen = (atoms.mask[:n] & bit) != 0
    flags[chosen] -= ((least + most)[which] // 2)[chosen]
    sim.console.both("  reset_atoms image CPU = 0.000 seconds\n")


_PARTS = {"id": _id, "mol": _mol, "image": _image}
