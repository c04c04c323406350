"""bond_style STYLE keywords... | none | hybrid STYLE keywords... STYLE keywords..."""

from __future__ import annotations

from typing import Any

from pylmp.fixes.store_local import StoreLocal
from pylmp.model import bond_memory, bond_volumes
from pylmp.model.bond import Bond, BondPart
from pylmp.model.registry import BONDS, command
from pylmp.model.simulation import Simulation
from pylmp.model.style import BondStyle
from pylmp.model.unknown import unknown_style
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word


@command("bond_style")
def bond_style(sim: Simulation, args: Args) -> None:
    """Choose the bond style. What bonds remember is forgotten, also when the same style is named again."""
    if not len(args):
        args.illegal(hint="bond_style STYLE keywords")
    name = args.word()
    if not sim.has_bonds:
        args.fail("Bond_style command when no bonds allowed", args.owner, hint="atom_style bond, before the box")
    _forget(sim)
    if name.text == "none":
        sim.bond = None
        return
    hybrid = name.text == "hybrid"
    parts = _hybrid(sim, args) if hybrid else [_part(sim, args, name, args.rest(), name.text)]
    sim.bond = Bond("hybrid" if hybrid else parts[0].style.name, parts, sim.bond_types)
    sim.atoms.set_history(sim.bond.memory)
    for part in parts:
        if part.options.get("store/local"):
            _record(sim, part)
        bond_memory.take(sim, part)


def _forget(sim: Simulation) -> None:
    for part in sim.bond.parts if sim.bond else ():
        if part.recorder in sim.fixes:
            sim.fixes.remove(part.recorder)
    sim.bond_lists = []
    bond_volumes.forget(sim)


def find(sim: Simulation, args: Args, name: Word) -> BondStyle:
    """The style of a name, /omp names included. Names only the manual knows are noted, refused under --strict."""
    plain = name.text.removesuffix("/omp")
    style: BondStyle | None = BONDS.find(plain)
    if style is None or (plain != name.text and not style.omp):
        unknown_style(args, name, "bond", BONDS)
    if not style.release:
        if sim.strict:
            hint = (
                "bond_style quartic" if "breakable" in plain and "un" not in plain else "the release has no such style"
            )
            args.fail(f"Unrecognized bond style '{name.text}'", name, hint=hint, code="D004")
        known = "calls it quartic" if plain == "quartic/breakable" else "has no such style"
        sim.console.warning(f"[D004] bond_style {plain} is of the manual page; LAMMPS 22 Jul 2025 {known}")
    return style


def _part(sim: Simulation, args: Args, name: Word, words: list[Word], called: str) -> BondPart:
    style = find(sim, args, name)
    if not sim.has_box and style.history:
        args.fail(
            "Fix BOND_HISTORY command before simulation box is defined",
            name,
            hint="create_box or read_data comes first",
        )
    options = style.parse(sim, Args(f"bond_style {called}", words, name, style.manual))
    return BondPart(style, options, sim.bond_types)


def _hybrid(sim: Simulation, args: Args) -> list[BondPart]:
    """Words up to the next style name belong to the style before."""
    if not len(args):
        args.fail(
            "Illegal bond_style hybrid command: missing argument(s)",
            args.words[0],
            hint="bond_style hybrid STYLE STYLE",
        )
    parts: list[BondPart] = []
    while len(args):
        name = args.word()
        if name.text in ("none", "hybrid"):
            args.fail(f"Bond style hybrid cannot have {name.text} as an argument", name)
        words = []
        while (word := args.peek()) is not None and BONDS.find(word.text.removesuffix("/omp")) is None:
            words.append(args.word())
        part = _part(sim, args, name, words, "hybrid")
        if any(part.style.name == other.style.name for other in parts):
            args.fail("Bond style hybrid cannot use same bond style twice", name)
        parts.append(part)
    if len({part.style.mixable for part in parts} - {None}) > 1:
        args.fail(
            "Cannot hybridize bond styles with different topology settings", args.words[1],
            hint="bpm styles mix with quartic",
        )  # fmt: skip
    if sum(bool(part.style.history) for part in parts) > 1:
        raise Unsupported(
            "LAMMPS has two bond styles with a memory in one hybrid, pylmp's native engines do not", args.words[1].span,
            hint="one bpm style, beside styles without a memory", manual=args.manual,
        )  # fmt: skip
    return parts


def _record(sim: Simulation, part: BondPart) -> None:
    """The internal fix that keeps records of broken bonds."""
    identity, every, attributes = part.options["store/local"]
    part.recorder = StoreLocal(sim, identity, every, attributes)
    taken: Any = next((fix for fix in sim.fixes if fix.id == identity), None)
    if taken is None:
        sim.fixes.insert(sum(fix.internal for fix in sim.fixes), part.recorder)
