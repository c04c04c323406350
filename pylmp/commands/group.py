"""group ID STYLE arguments..."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pylmp.model.dynamic_group import DynamicGroup
from pylmp.model.groups import MAX_GROUPS
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.variables import Variables
from pylmp.text.words import Args, Word

Mask = NDArray[np.bool_]
_CONDITIONS: dict[str, Any] = {
    "<": np.less, "<=": np.less_equal, ">": np.greater, ">=": np.greater_equal, "==": np.equal, "!=": np.not_equal,
}  # fmt: skip
_RANGE = re.compile(r"(-?\d+)(?::(-?\d+))?(?::(\d+))?")


@command("group", needs_box=True)
def group(sim: Simulation, args: Args) -> None:
    """Add atoms to a group, combine groups, or let members come and go."""
    args.need(2)
    name, style = args.word(), args.word()
    if style.text in ("delete", "clear"):
        _remove(sim, args, name, style)
        return
    select = _STYLES.get(style.text)
    if select is None and style.text not in ("dynamic", "static"):
        args.fail(f"Unknown group command keyword: {style.text}", style, hint=" ".join(_STYLES))
    bit, new = sim.groups.bit(name.text), False
    if bit == 0:
        bit, new = sim.groups.free_bit(), True
        if bit == 0:
            args.fail(f"Too many groups (max {MAX_GROUPS})", name)
    mask = sim.atoms.mask[: sim.atoms.n]
    if select is not None:
        add, drop = select(sim, args, style, bit)
        mask[add] |= bit
        mask[drop] &= ~bit
    elif style.text == "dynamic":
        made = DynamicGroup(sim, name, args)
        made.target = bit
        _settle(sim, name.text)
        sim.fixes.append(made)
        sim.groups.dynamic.add(name.text)
    else:
        if len(args):
            args.fail("Illegal group static command", args.peek())
        _settle(sim, name.text)
    if new:
        sim.groups.names[name.text] = bit
    if name.text in sim.groups.dynamic:
        sim.console.both(f"dynamic group {name.text} defined\n")
    else:
        sim.console.both(f"{int(((mask & bit) != 0).sum())} atoms in group {name.text}\n")


def _settle(sim: Simulation, name: str) -> None:
    """A group is not dynamic any more; its members of this moment stay."""
    sim.groups.dynamic.discard(name)
    sim.fixes[:] = [fix for fix in sim.fixes if not (isinstance(fix, DynamicGroup) and fix.id == f"GROUP_{name}")]


def _remove(sim: Simulation, args: Args, name: Word, style: Word) -> None:
    bit = sim.groups.bit(name.text)
    if name.text == "all":
        args.fail(f"Cannot {style.text} group all", name)
    if bit == 0:
        args.fail(f"Could not find group {style.text} group ID {name.text}", name)
    if style.text == "delete":
        users = (("fix", sim.fixes), ("compute", sim.computes.values()), ("dump", sim.output.dumps.values()))
        for kind, those in users:
            for user in those:
                if user.group == name.text:
                    args.fail(f"Cannot delete group {name.text} currently used by {kind} ID {user.id}", name)
        _settle(sim, name.text)
        del sim.groups.names[name.text]
    sim.atoms.mask[: sim.atoms.n] &= ~bit


# ---- styles: (sim, args, style, bit of the group) -> atoms to add, atoms to take out --------------------------------


def _nobody(sim: Simulation) -> Mask:
    return np.zeros(sim.atoms.n, bool)


def _empty(sim: Simulation, args: Args, style: Word, bit: int) -> tuple[Mask, Mask]:
    if len(args):
        args.fail("Illegal group empty command", args.peek())
    return _nobody(sim), _nobody(sim)


def _region(sim: Simulation, args: Args, style: Word, bit: int) -> tuple[Mask, Mask]:
    if len(args) != 1:
        args.fail("Illegal group region command", args.owner)
    word = args.word()
    if word.text not in sim.regions:
        args.fail(f"Region {word.text} for group region does not exist", word)
    return sim.regions[word.text].inside(sim.atoms.x[: sim.atoms.n]), _nobody(sim)


def _variable(sim: Simulation, args: Args, style: Word, bit: int) -> tuple[Mask, Mask]:
    word = args.word()
    kind = Variables(sim).style(word.text)
    if kind is None:
        args.fail(f"Variable name {word.text} for group does not exist", word)
    if kind not in ("atom", "atomfile"):
        args.fail(f"Variable {word.text} for group is invalid style", word, hint="an atom-style variable")
    return Variables(sim).per_atom(word.text) != 0.0, _nobody(sim)


def _include(sim: Simulation, args: Args, style: Word, bit: int) -> tuple[Mask, Mask]:
    """All atoms of the molecules that have a member."""
    if len(args) != 1:
        args.fail("Illegal group include command", args.owner, hint="include molecule")
    word = args.word()
    if word.text != "molecule":
        args.fail(f"Unknown group include keyword {word.text}", word, hint="molecule")
    if not sim.has_bonds:
        args.fail("Group include molecule command requires atom attribute molecule", word)
    atoms = sim.atoms
    molecule, mask = atoms.molecule[: atoms.n], atoms.mask[: atoms.n]
    return np.isin(molecule, molecule[(mask & bit) != 0]) & (molecule != 0), _nobody(sim)


def _by_number(sim: Simulation, args: Args, style: Word, bit: int) -> tuple[Mask, Mask]:
    atoms = sim.atoms
    if style.text == "molecule" and not sim.has_bonds:
        args.fail("Group molecule command requires atom attribute molecule", style)
    values = {"type": atoms.type, "id": atoms.tag, "molecule": atoms.molecule}[style.text][: atoms.n]
    if style.text == "type":
        _number_labels(sim, args)
    return _match(args, style, values), _nobody(sim)


def _number_labels(sim: Simulation, args: Args) -> None:
    """Type labels among the words left become numbers."""
    start = args.at
    while len(args):
        if args.words[args.at].text not in (*_CONDITIONS, "<>"):
            sim.labels.translate(args, "atom")
        args.word()
    args.at = start


def _combine(sim: Simulation, args: Args, style: Word, bit: int) -> tuple[Mask, Mask]:
    if len(args) < (1 if style.text == "union" else 2):
        args.fail(f"Illegal group {style.text} command: missing argument(s)", style)
    words = args.rest()
    for word in words:
        if not sim.groups.bit(word.text):
            args.fail(f"Group ID {word.text} does not exist", word)
        if word.text in sim.groups.dynamic:
            says = {
                "union": "Cannot union groups from a dynamic group", "subtract": "Cannot subtract dynamic groups",
                "intersect": "Cannot intersect groups using a dynamic group",
            }  # fmt: skip
            args.fail(says[style.text], word)
    mask = sim.atoms.mask[: sim.atoms.n]
    first, *others = [(mask & sim.groups.bit(word.text)) != 0 for word in words]
    if style.text == "intersect":
        return np.logical_and.reduce([first, *others]), _nobody(sim)
    rest = np.logical_or.reduce([_nobody(sim), *others])
    return (first | rest, _nobody(sim)) if style.text == "union" else (first & ~rest, rest)


_STYLES: dict[str, Callable[..., tuple[Mask, Mask]]] = {
    "type": _by_number, "id": _by_number, "molecule": _by_number, "region": _region, "variable": _variable, "include": _include,
    "union": _combine, "subtract": _combine, "intersect": _combine, "empty": _empty,
}  # fmt: skip


def _match(args: Args, style: Word, values: NDArray[np.int64]) -> Mask:
    """A condition (`<= 5`, `<> 2 4`) or a list of numbers and ranges `a:b` or `a:b:step`."""
    if not len(args):
        args.fail(f"Illegal group {style.text} command: missing argument(s)", style)
    first = args.words[args.at]
    if len(args) > 1 and first.text in (*_CONDITIONS, "<>"):
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
        found = _RANGE.fullmatch(word.text)
        large = next((one for one in found.groups() if one and abs(int(one[:20])) >= 2**31), None) if found else word.text
        if found is None or large is not None:
            why = "Syntax error" if ":" in word.text and not found else f"Not a valid integer number: '{large}'"
            args.fail(f"Incorrect range string '{word.text}': {why}", word, hint="n, a:b or a:b:step")
        start, stop, step = int(found[1]), int(found[2] or found[1]), int(found[3] or 1)
        if step < 1:
            args.fail("Illegal range increment value", word)
        chosen |= (values >= start) & (values <= stop) & ((values - start) % step == 0)
    return chosen
