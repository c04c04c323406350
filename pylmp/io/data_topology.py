"""The sections Bonds, Angles, Dihedrals, Impropers of a data file.

LAMMPS reads them twice: to count what each atom must store, and to store it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from pylmp.io.data_file import DataFile
from pylmp.io.data_rows import END, INTEGER, TYPE, wrong_format
from pylmp.io.data_types import TypeMap
from pylmp.model.atoms import Ints
from pylmp.model.simulation import Simulation
from pylmp.model.topology import Kind, crowd, store


@dataclass
class Scanned:
    """types (k,), tags (k, size) of one section."""

    kind: Kind
    types: Ints
    tags: Ints


def scan(sim: Simulation, file: DataFile, kind: Kind, count: int, types: TypeMap, id_offset: int, adds: bool) -> Scanned:
    """Read a section of count lines, make room for it. adds: to atoms that were there before."""
    sim.console.both(f"  scanning {kind.plural} ...\n")
    first = file.at
    lines = file.take(count, f"the header promises {count} {kind.plural}")
    found = _rows(sim, file, kind, lines, types, id_offset)
    stored = crowd(sim, kind, found.tags)
    most = int(stored.max(initial=0))
    if not adds:
        most += sim.atoms.slots(kind.name)  # so far what extra/KIND/per/atom asked for
    sim.console.both(f"  {most} = max {kind.plural}/atom\n")
    if len(found.types) != count:
        hint = f"one section with {count} {kind.plural}, each on a line of its own"
        file.fail(f"{kind.plural.capitalize()} assigned incorrectly", first, hint=hint)
    room = int((kind.numbers(sim)[: sim.atoms.n] + stored).max(initial=0))
    sim.atoms.widen(kind.name, max(most, room))
    return found


def keep(sim: Simulation, found: Scanned) -> None:
    """Store what was scanned."""
    kind = found.kind
    sim.console.both(f"  reading {kind.plural} ...\n")
    store(sim, kind, found.types, found.tags)
    kind.set_total(sim, kind.total(sim) + len(found.types))
    sim.console.both(f"  {len(found.types)} {kind.plural}\n")


def _rows(sim: Simulation, file: DataFile, kind: Kind, lines: range, types: TypeMap, id_offset: int) -> Scanned:
    """The lines ``number type atom atom ...``; the number is not read."""
    good = re.compile(r"\s*[^\s#]\S*\s+" + r"\s+".join([TYPE] + [INTEGER] * kind.size) + END, re.ASCII)
    section, known_types, rows_by_tag = kind.plural.capitalize(), kind.types(sim), sim.atoms.rows_by_tag()
    kinds, members = [], []
    for line in lines:
        found = good.fullmatch(file.lines[line])
        words = ["", *found.groups()] if found else file.words(line)
        if not words:
            continue
        text = file.lines[line].strip()
        if len(words) != kind.size + 2:
            wrong_format(file, section, line, "number type" + "".join(f" atom{k + 1}" for k in range(kind.size)))
        tags = [file.integer(word, line) + id_offset for word in words[2:]]
        number = types.number(kind.name, words[1])
        hint = f"{kind.name} types are 1 to {known_types}"
        if number is None:
            file.fail(f"Invalid {section} section of data file: {text}", line, words[1], hint=hint)
        if not 1 <= number <= known_types:
            file.fail(f"Invalid {kind.name} type {number} in {section} section of data file: {text}", line, hint=hint)
        known = all(0 < tag < len(rows_by_tag) and rows_by_tag[tag] >= 0 for tag in tags)
        if not known or len(set(tags)) < len(tags):
            hint = f"{kind.size} different atoms of the file"
            file.fail(f"Invalid atom ID in {section} section of data file: {text}", line, hint=hint)
        kinds.append(number)
        members.append(tags)
    return Scanned(kind, np.array(kinds, np.int64), np.array(members, np.int64).reshape(-1, kind.size))
