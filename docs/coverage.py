"""Writes docs/coverage.md: every command and style of the registries, the deck that compares it with LAMMPS, and what only LAMMPS has.

usage: python docs/coverage.py
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from pylmp.model.atom_style import ATOM_STYLES
from pylmp.model.registry import REGISTRIES, THERMOS
from pylmp.model.unknown import only_lammps
from pylmp.text.diagnostic import MANUAL
from pylmp.text.variable_styles import READERS as VARIABLE_STYLES

ROOT = Path(__file__).parents[1]
PAGES = {"dump": "dump.html", "region": "region.html", "minimize": "min_style.html", "thermo": "thermo_style.html"}
TITLES = {
    "command": "Commands", "bond": "Bond styles", "pair": "Pair styles", "fix": "Fixes", "compute": "Computes", "region": "Regions",
    "dump": "Dumps", "minimize": "Minimizers", "thermo": "Thermo styles", "angle": "Angle styles", "dihedral": "Dihedral styles",
    "improper": "Improper styles",
}  # fmt: skip
HEAD = """# What runs here, and what shows it

Written by `python docs/coverage.py` from the registries and the decks. *identical*: the deck is run here and on LAMMPS 22 Jul 2025 in the
tests, and every number, dump and answer is equal to the last bit. *same text*: scripts in the named file print the same here and on
LAMMPS. *without effect*: accepted with a warning.
*LAMMPS only*: known, refused with exit code 5; `--engine lammps` runs it. `/omp` names of bond styles run the plain law.
[engines.md](engines.md) lists which decks the fast engine runs, and what falls back to the exact one.
"""


class Decks:
    """Where each command and style is used, and what decks say of themselves."""

    def __init__(self) -> None:
        self.own: dict[str, str] = {}
        self.used: dict[str, str] = {}
        self.differs: dict[str, str] = {}
        for path in sorted((ROOT / "tests" / "decks").glob("*/*.in")) + sorted((ROOT / "inputs").glob("*/in.*")):
            where, text = path.relative_to(ROOT).as_posix(), path.read_text()
            for name in re.findall(r"^# covers: (.*)$", text, re.M):
                for item in name.split(","):
                    self.own.setdefault(item.strip(), where)
            for note in re.findall(r"^# differs: (.*)$", text, re.M):
                self.differs[where] = note
            for name in _uses(text):
                self.used.setdefault(name, where)
        self.said: dict[str, str] = {}
        for path in sorted((ROOT / "tests" / "corpus").glob("language*.cases")):
            for name in _uses(path.read_text()):
                self.said.setdefault(name, path.relative_to(ROOT).as_posix())

    def row(self, kind: str, name: str, link: str) -> str:
        key = f"{kind} {name}"
        bare = self.own.get(name, "") if kind == "command" else ""
        deck = self.own.get(key) or bare or self.used.get(key) or ""
        status = "identical" if deck else "same text" if key in self.said else "without effect"
        deck = deck or self.said.get(key, "")
        shown = f"[{Path(deck).name}](../{deck})" if deck else ""
        return f"| [`{name}`]({link}) | {status} | {shown} | {self.differs.get(deck, '')} |"


def _uses(text: str) -> Iterator[str]:
    """Commands and styles that a script names."""
    place = {"fix": 3, "compute": 3, "dump": 3, "region": 2, "min_style": 1, "thermo_style": 1, "pair_style": 1, "bond_style": 1}
    kinds = {"min_style": "minimize", "thermo_style": "thermo", "pair_style": "pair", "bond_style": "bond"}
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["variable"] and len(words) > 2:
            yield f"variable {words[2]}"
        if words[:1] == ["atom_style"] and len(words) > 1:
            yield f"atom {words[1]}"
        for k, word in enumerate(words):
            if k and not (word.startswith('"') and words[0] == "if"):
                continue
            command = word.lstrip('"')
            yield f"command {command}"
            if command in place and len(words) > k + place[command]:
                kind = kinds.get(command, command)
                for style in words[k + place[command] :] if kind in ("pair", "bond") else [words[k + place[command]]]:
                    yield f"{kind} {style.strip(chr(34))}"


def table(decks: Decks, title: str, kind: str, rows: list[tuple[str, str]], lacking: list[str]) -> list[str]:
    lines = ["", f"## {title}", "", "| name | status | deck | differs |", "|---|---|---|---|"]
    lines += [decks.row(kind, name, link) for name, link in rows]
    return [*lines, *(["", f"LAMMPS only: {', '.join(f'`{name}`' for name in lacking)}"] if lacking else [])]


def coverage() -> str:
    """The text of docs/coverage.md."""
    decks = Decks()
    lines = []
    for kind, title in TITLES.items():
        rows = []
        for name, value in {**REGISTRIES, "thermo": THERMOS}[kind]:
            page = PAGES.get(kind) or getattr(value, "manual", "") or f"{kind}_{name.replace('/', '_')}.html"
            rows.append((name, MANUAL + page))
        lines += table(decks, title, kind, rows, only_lammps(kind))
    rows = [(name, f"{MANUAL}atom_style.html") for name in ATOM_STYLES]
    lines += table(decks, "Atom styles", "atom", rows, only_lammps("atom"))
    rows = [(name, f"{MANUAL}variable.html") for name in VARIABLE_STYLES if name != "python"]
    lines += table(decks, "Variable styles", "variable", rows, ["python"])
    return HEAD + "\n".join(lines) + "\n"


if __name__ == "__main__":
    (ROOT / "docs" / "coverage.md").write_text(coverage())
