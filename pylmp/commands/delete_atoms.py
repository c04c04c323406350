"""delete_atoms group|region|overlap|random|variable arguments... [compress yes|no] [bond yes|no] [mol yes|no]

Source: LAMMPS manual, delete_atoms.html. The order of the atoms that stay is LAMMPS's: each hole takes the last atom.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pylmp.io.neighbor_info import Request
from pylmp.io.ready import full_list, initialise
from pylmp.kernels.random import RanMars
from pylmp.kernels.subset import select_subset
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.topology import Kind, entries
from pylmp.model.variables import Variables
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest
from pylmp.text.words import Args, Word

Mask = NDArray[np.bool_]


@dataclass
class _Options:
    compress: bool = True
    bond: bool = False
    mol: bool = False


@command("delete_atoms", needs_box=True)
def delete_atoms(sim: Simulation, args: Args) -> None:
    """Remove atoms; with bond yes the bonds they were part of, with mol yes the rest of their molecules."""
    args.need(1)
    style = args.word()
    if style.text == "porosity":
        args.fail("The delete_atoms 'porosity' keyword has been removed.", style, hint="random fraction")
    if style.text not in _STYLES:
        args.fail(f"Unknown delete_atoms sub-command: {style.text}", style, hint=" ".join(_STYLES))
    count, select = _STYLES[style.text]
    args.need(count, style.text)
    words = [args.word() for _ in range(count)]
    doomed, options = select(sim, args, words)
    atoms = sim.atoms
    before = sim.natoms, [kind.total(sim) for kind in sim.style.kinds]  # atoms that were lost on the way count as deleted
    everyone = style.text == "group" and words[0].text == "all"
    if options.bond:
        for kind in sim.style.kinds:
            _cut(sim, kind, doomed)
    if options.mol and not everyone:  # bonds to those who go on its account stay (measured)
        molecule = atoms.molecule[: atoms.n]
        doomed = doomed | (np.isin(molecule, molecule[doomed]) & (molecule != 0))
    atoms.drop(doomed)
    if options.compress:
        if sim.has_bonds:
            sim.console.warning("Ignoring 'compress yes' for molecular system")
        else:
            atoms.tag[: atoms.n] = 0
            atoms.number()
    _report(sim, before, options)


def _report(sim: Simulation, before: tuple[int, list[int]], options: _Options) -> None:
    """Count anew, and say what went."""
    sim.natoms = sim.atoms.n
    sim.console.both(f"Deleted {before[0] - sim.natoms} atoms, new total = {sim.natoms}\n")
    for kind, old in zip(sim.style.kinds, before[1], strict=True):
        kind.recount(sim)
        if (options.bond or options.mol) and old:
            sim.console.both(f"Deleted {old - kind.total(sim)} {kind.plural}, new total = {kind.total(sim)}\n")


def _cut(sim: Simulation, kind: Kind, doomed: Mask) -> None:
    """Take from the atoms that stay what joins them to a doomed one; the last slot moves into the hole."""
    found = entries(sim, kind)
    gone = np.isin(found.tags, sim.atoms.tag[: sim.atoms.n][doomed]).any(axis=1) & ~doomed[found.rows]
    slots: dict[int, set[int]] = {}
    for row, slot in zip(found.rows[gone].tolist(), found.slots[gone].tolist(), strict=True):
        slots.setdefault(row, set()).add(slot)
    for row, empty in slots.items():
        slot = 0
        while slot < kind.numbers(sim)[row]:
            if slot not in empty:
                slot += 1
                continue
            last = int(kind.numbers(sim)[row]) - 1
            sim.atoms.drop_slot(row, slot, kind.name)
            empty.discard(slot)
            if last in empty:
                empty.discard(last)
                empty.add(slot)


def _read_options(sim: Simulation, args: Args) -> _Options:
    options = _Options()
    while len(args):
        key = args.word()
        if key.text not in ("compress", "bond", "mol"):
            args.fail(f"Unknown delete_atoms option: {key.text}", key, hint="compress bond mol")
        args.need(1, key.text)
        if key.text == "bond" and not sim.has_bonds:
            args.fail("Cannot use delete_atoms bond yes for non-molecular systems", key)
        if key.text == "mol" and not sim.has_bonds:
            args.fail("Delete_atoms mol yes requires atom attribute molecule", key)
        setattr(options, key.text, args.yes())
    return options


# ---- styles: (sim, args, their words) -> atoms to delete (n,), options; they read the options in the order in which LAMMPS does


def _members(sim: Simulation, args: Args, word: Word) -> Mask:
    bit = sim.groups.bit(word.text)
    if not bit:
        args.fail(f"Group ID {word.text} requested by delete_atoms does not exist", word)
    return np.asarray((sim.atoms.mask[: sim.atoms.n] & bit) != 0)


def _group(sim: Simulation, args: Args, words: list[Word]) -> tuple[Mask, _Options]:
    doomed = _members(sim, args, words[0])
    return doomed, _read_options(sim, args)


def _region(sim: Simulation, args: Args, words: list[Word]) -> tuple[Mask, _Options]:
    if words[0].text not in sim.regions:
        args.fail(f"Could not find delete_atoms region ID {words[0].text}", words[0])
    options = _read_options(sim, args)
    return sim.regions[words[0].text].inside(sim.atoms.x[: sim.atoms.n]), options


def _variable(sim: Simulation, args: Args, words: list[Word]) -> tuple[Mask, _Options]:
    name = words[0].text
    style = Variables(sim).style(name)
    if style is None:
        args.fail(f"Variable name {name} for delete_atoms does not exist", words[0])
    if style not in ("atom", "atomfile"):
        args.fail(f"Variable {name} for delete_atoms is invalid style", words[0], hint="an atom-style variable")
    options = _read_options(sim, args)
    return Variables(sim).per_atom(name) != 0.0, options


def _random(sim: Simulation, args: Args, words: list[Word]) -> tuple[Mask, _Options]:
    """fraction F EXACT GROUP REGION SEED, count N ERROR GROUP REGION SEED; REGION may be NULL."""
    kind, amount, strict, group, region, seed = words
    if kind.text == "fraction":
        share = args.as_number(amount)
        if not 0.0 <= share <= 1.0:
            args.fail(f"Delete_atoms random fraction has invalid value: {shortest(share)}", amount, hint="from 0 to 1")
    elif kind.text == "count":
        number = args.as_integer(amount)
        if number < 0:
            args.fail(f"Delete_atoms random count has invalid value: {number}", amount, hint="0 or more")
    else:
        args.fail(f"Unknown delete_atoms random style: {kind.text}", kind, hint="fraction or count")
    exact = Args(args.what, [strict], strict, args.manual).yes()
    eligible = _members(sim, args, group)
    if region.text != "NULL":
        if region.text not in sim.regions:
            args.fail(f"Could not find delete_atoms random region ID {region.text}", region)
        eligible &= sim.regions[region.text].inside(sim.atoms.x[: sim.atoms.n])
    start = args.as_integer(seed)
    options = _read_options(sim, args)
    try:
        random = RanMars(start)
    except ValueError as error:
        args.fail(str(error), seed, hint="1 to 900000000")
    rows = np.flatnonzero(eligible)
    if kind.text == "fraction" and not exact:
        chosen = np.array([random.uniform() <= share for _ in rows], bool)
    else:
        wanted = int(share * len(rows)) if kind.text == "fraction" else number
        if wanted > len(rows):
            says = f"Delete_atoms count of {wanted} exceeds number of eligible atoms {len(rows)}"
            if exact:
                args.fail(says, amount)
            sim.console.warning(says)
        chosen = select_subset(start, min(wanted, len(rows)), len(rows))
    doomed = np.zeros(sim.atoms.n, bool)
    doomed[rows[chosen]] = True
    return doomed, options


def _overlap(sim: Simulation, args: Args, words: list[Word]) -> tuple[Mask, _Options]:
    """Of each pair nearer than CUTOFF one atom: of two owned ones that of the lower row, unless the other goes anyway."""
    near = args.as_number(words[0])
    for word in words[1:]:
        _members(sim, args, word)
    options = _read_options(sim, args)
    sim.console.both("System init for delete_atoms ...\n")
    initialise(sim, Request("command delete_atoms", full=True, occasional=True))
    if sim.pair is None:
        args.fail("Delete_atoms requires a pair style be defined", args.owner, hint="pair_style zero is enough")
    shortest_list, longest_list = (
        float(cut) + sim.neighbor.skin for cut in (sim.pair.cut[1:, 1:].min(), sim.pair.cut.max())
    )
    if near > longest_list:
        raise ScriptError("Delete_atoms cutoff > max neighbor cutoff", words[0].span, hint=f"at most {longest_list:g}")
    if near > shortest_list:
        sim.console.warning("Delete_atoms cutoff > minimum neighbor cutoff")
    atoms = sim.atoms
    first = second = doomed = np.zeros(0, bool)
    for rows, others, r2 in full_list(sim):
        if not len(doomed):
            first, second = ((atoms.mask & sim.groups.bit(word.text)) != 0 for word in words[1:])
            doomed = np.zeros(atoms.n, bool)
        take = (r2 < near * near) & first[rows] & second[others]
        image_goes = (others >= atoms.n) & second[rows] & first[others] & (atoms.tag[rows] > atoms.tag[others])
        take &= ~image_goes
        for i, j in zip(rows[take].tolist(), others[take].tolist(), strict=True):
            if not doomed[i] and (j >= atoms.n or not doomed[j]):
                doomed[i] = True
    atoms.clear_ghosts()
    return doomed, options


_STYLES = {
    "group": (1, _group), "region": (1, _region), "overlap": (3, _overlap), "random": (6, _random), "variable": (1, _variable),
}  # fmt: skip
