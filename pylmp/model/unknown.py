"""Names that are not known here: what LAMMPS has and pylmp lacks is no misspelling.

grammar/names.txt lists LAMMPS's names. What is missing here follows from it and from the registries: nobody keeps a list.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any, NoReturn

from pylmp.model.atom_style import ATOM_STYLES
from pylmp.model.registry import REGISTRIES, Registry
from pylmp.text.diagnostic import Unsupported
from pylmp.text.grammar import folder
from pylmp.text.words import Args, Word

_SUFFIX = re.compile(r"/(omp|opt|kk|gpu|intel)$")
_WORDS = {"hybrid", "hybrid/overlay", "none"}  # styles that their command makes itself
# Where a command names a style: what kind, which word.
STYLED = {
    "pair_style": ("pair", 1), "bond_style": ("bond", 1), "angle_style": ("angle", 1), "dihedral_style": ("dihedral", 1),
    "improper_style": ("improper", 1), "kspace_style": ("kspace", 1), "atom_style": ("atom", 1), "min_style": ("minimize", 1),
    "run_style": ("integrate", 1), "fix": ("fix", 3), "compute": ("compute", 3), "dump": ("dump", 3), "write_dump": ("dump", 2),
    "region": ("region", 2),
}  # fmt: skip


@cache
def _names() -> dict[str, frozenset[str]]:
    """kind -> the names of LAMMPS's styles of that kind, or of its commands."""
    parts = re.split(r"^(\w+):$", (folder() / "names.txt").read_text(), flags=re.MULTILINE)
    return {kind: frozenset(names.split()) for kind, names in zip(parts[1::2], parts[2::2], strict=True)}


def _here(kind: str, name: str) -> bool:
    others: dict[str, Callable[[str], bool]] = {
        "kspace": lambda name: name == "none", "integrate": lambda name: name == "verlet", "atom": lambda name: name in ATOM_STYLES,
    }  # fmt: skip
    if kind in others:
        return others[kind](name)
    return REGISTRIES[kind].find(name) is not None or (name in _WORDS and kind in ("pair", "bond", "angle", "dihedral", "improper"))


def is_elsewhere(kind: str, name: str) -> bool:
    """LAMMPS has a style (or a command) of that name, pylmp does not."""
    plain = _SUFFIX.sub("", name)  # the list leaves out accelerated variants; which of them exist of a style known here is not known
    return plain in _names()[kind] and not _here(kind, plain)


def only_lammps(kind: str) -> list[str]:
    """The styles of a kind (or the commands) that LAMMPS has and pylmp does not."""
    return sorted(name for name in _names().get(kind, ()) if not _here(kind, name))


def lacking(kind: str, name: str) -> str:
    """What LAMMPS has, in words: fix rigid, pair_style eam, the command temper."""
    if kind == "command":
        return f"the command {name}"
    owner = {"minimize": "min_style", "integrate": "run_style"}.get(kind, kind if kind in ("fix", "compute", "dump", "region") else f"{kind}_style")
    return f"{owner} {name}"


def unsupported(kind: str, word: Word, name: str = "") -> Unsupported:
    """The error for a name that only LAMMPS has."""
    name = name or word.text
    page = name if kind == "command" else f"{kind}_style" if kind in ("kspace", "atom") else f"{kind}_{name.replace('/', '_')}"
    return Unsupported(
        f"LAMMPS has {lacking(kind, name)}, pylmp's native engines do not", word.span,
        hint="--engine lammps runs this script on LAMMPS", manual=f"{page}.html",
    )  # fmt: skip


def unknown_style(args: Args, name: Word, kind: str, registry: Registry[Any]) -> NoReturn:
    """LAMMPS's sentence with a guess at what was meant; or that only LAMMPS has it."""
    if is_elsewhere(kind, name.text):
        raise unsupported(kind, name)
    near = registry.near(name.text)
    hint = f"did you mean {near}?" if near else f"known: {' '.join(registry.names())}"
    args.fail(f"Unrecognized {kind} style '{name.text}'", name, hint=hint)
