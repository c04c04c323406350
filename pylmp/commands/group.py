"""group ID STYLE arguments..."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.model.groups import MAX_GROUPS
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

Mask = NDArray[np.bool_]
_CONDITIONS: dict[str, Any] = {
    "<": np.less, "<=": np.less_equal, ">": np.greater, ">=": np.greater_equal, "==": np.equal, "!=": np.not_equal,
}  # fmt: skip


@command("group", needs_box=True)
def group(sim: Simulation, args: Args) -> None:
    """Add atoms to a group, or combine groups."""
    args.need(2)
    name, style = args.word(), args.word()
    if style.text in ("delete", "clear"):
        _remove(sim, args, name, style)
        return
    if style.text in ("dynamic", "static", "include", "variable"):
        raise Unsupported(f"LAMMPS has group style {style.text}, pylmp's native engines do not", style.span)
    if style.text not in ("type", "id", "molecule", "region", "union", "subtract", "intersect", "empty"):
        args.fail(f"Unknown group command keyword: {style.text}", style, hint="type id molecule region union subtract intersect")
    bit, new = sim.groups.bit(name.text), False
    if bit == 0:
        bit, new = sim.groups.free_bit(), True
        if bit == 0:
            args.fail(f"Too many groups (max {MAX_GROUPS})", name)
    add, drop = _select(sim, args, style)
    if new:
        sim.groups.names[name.text] = bit
    mask = sim.atoms.mask[: sim.atoms.n]
    mask[add] |= bit
    mask[drop] &= ~bit
    sim.console.both(f"{int(((mask & bit) != 0).sum())} atoms in group {name.text}\n")


def _remove(sim: Simulation, args: Args, name: Word, style: Word) -> None:
    bit = sim.groups.bit(name.text)
    if name.text == "all":
        args.fail(f"Cannot {style.text} group all", name)
    if bit == 0:
        args.fail(f"Could not find group {style.text} group ID {name.text}", name)
    if style.text == "delete":
        for kind, users in (("fix", sim.fixes), ("compute", sim.computes.values())):
            for user in users:
                if user.group == name.text:
                    args.fail(f"Cannot delete group {name.text} currently used by {kind} ID {user.id}", name)
        del sim.groups.names[name.text]
    sim.atoms.mask[: sim.atoms.n] &= ~bit


def _select(sim: Simulation, args: Args, style: Word) -> tuple[Mask, Mask]:
    """Atoms to add and atoms to take out."""
    atoms = sim.atoms
    nobody = np.zeros(atoms.n, bool)
    mask = atoms.mask[: atoms.n]
    if style.text == "empty":
        if len(args):
            args.fail("Illegal group empty command", args.peek())
        return nobody, nobody
    if style.text == "region":
        if len(args) != 1:
            args.fail("Illegal group region command", args.owner)
        word = args.word()
        if word.text not in sim.regions:
            args.fail(f"Region {word.text} for group region does not exist", word)
        return sim.regions[word.text].inside(atoms.x[: atoms.n]), nobody
    if style.text in ("type", "id", "molecule"):
        values = {"type": atoms.type, "id": atoms.tag, "molecule": atoms.molecule}[style.text][: atoms.n]
        if style.text == "molecule" and sim.atom_style == "atomic":
            args.fail("Group molecule command requires atom attribute molecule", style)
        return _match(args, style, values), nobody
    if not len(args) or (style.text != "union" and len(args) < 2):
        args.fail(f"Illegal group {style.text} command: missing argument(s)", style)
    bits = []
    for word in args.rest():
        bits.append(sim.groups.bit(word.text))
        if not bits[-1]:
            args.fail(f"Group ID {word.text} does not exist", word)
    members = [(mask & b) != 0 for b in bits]
    if style.text == "union":
        return np.logical_or.reduce(members), nobody
    if style.text == "intersect":
        return np.logical_and.reduce(members), nobody
    return members[0] & ~np.logical_or.reduce(members[1:]), np.logical_or.reduce(members[1:])


def _match(args: Args, style: Word, values: NDArray[np.int64]) -> Mask:
    """A condition (`<= 5`, `<> 2 4`) or a list of numbers and ranges `a:b` or `a:b:step`."""
    if not len(args):
        args.fail(f"Illegal group {style.text} command: missing argument(s)", style)
    first = args.peek()
    if first is not None and first.text in (*_CONDITIONS, "<>"):
        args.word()
        count = 2 if first.text == "<>" else 1
        if len(args) != count:
            args.illegal(first)
        bounds = [args.integer() for _ in range(count)]
        if first.text == "<>":
            return (values >= bounds[0]) & (values <= bounds[1])
        return np.asarray(_CONDITIONS[first.text](values, bounds[0]))
    chosen = np.zeros(len(values), bool)
    for word in args.rest():
        parts = word.text.split(":")
        for part in parts:
            if not re.fullmatch(r"-?\d+", part):
                why = "Syntax error" if part == "" or len(parts) > 3 else f"Not a valid integer number: '{part}'"
                args.fail(f"Incorrect range string '{word.text}': {why}", word, hint="n, a:b or a:b:step")
        start, stop, step = int(parts[0]), int(parts[min(1, len(parts) - 1)]), int(parts[2]) if len(parts) == 3 else 1
        if step < 1:
            args.fail("Illegal range increment value", word)
        chosen |= (values >= start) & (values <= stop) & ((values - start) % step == 0)
    return chosen
