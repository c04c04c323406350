"""Types in a data file: numbers of the file or labels, turned into numbers of the simulation; the sections of type labels.

Source: LAMMPS manual, read_data.html, Howto_type_labels.html; sentences as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

import re

from pylmp.io.data_file import DataFile
from pylmp.model.labels import is_label
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported


class TypeMap:
    """offsets: what read_data offset adds, by kind ("atom", "bond", ...)."""

    def __init__(self, sim: Simulation, file: DataFile, offsets: dict[str, int]) -> None:
        self.sim, self.file, self.offsets = sim, file, offsets
        self._local: dict[str, dict[int, int]] = {}  # where the file has labels of its own

    def number(self, kind: str, word: str) -> int | None:
        """The simulation's type number for a word of the file; None if it is neither a number nor a known label."""
        if re.fullmatch(r"\d{1,9}", word, re.ASCII):
            number = int(word)
            return self._local.get(kind, {}).get(number, number) + self.offsets.get(kind, 0)
        return self.sim.labels.number(kind, word) or None

    def coefficient(self, kind: str, number: int) -> int:
        """The type whose coefficients a row gives; 0 for one that the file has no label for, where it has labels."""
        local = self._local.get(kind)
        return (local.get(number, 0) if local else number) + self.offsets.get(kind, 0)

    def read_labels(self, kind: str, types: int, line: int) -> None:
        """A section of lines ``type label``. A label that the simulation knows already means its type, a new one the next unnamed."""
        sim, file = self.sim, self.file
        section = f"{kind.capitalize()} Type Labels"
        if any(self.offsets.values()):
            raise Unsupported("LAMMPS has read_data offset with type labels, pylmp's native engines do not", file.span(line))
        sim.console.both(f"  reading {kind} labelmap ...\n")
        found: dict[int, str] = {}
        for at in file.take(types, f"one label for each of {types} {kind} types"):
            words, text = file.words(at), file.lines[at].strip()
            if len(words) != 2:
                file.fail(f"Invalid format in section: {section}: {text}", at, hint="type label")
            number, label = file.integer(words[0], at), words[1]
            if not is_label(label):
                file.fail(f"Invalid type label {label}", at, label, hint="no digit, * or # in front")
            if not 1 <= number <= types:
                file.fail(f"Invalid {kind} type {number} in {section} section of data file: {text}", at, words[0])
            found[number] = label
        if len(set(found.values())) < types:
            file.fail(f"{section} map is incomplete", line, hint=f"{types} types with different labels")
        self._local[kind] = {number: self._place(kind, found[number], line) for number in range(1, types + 1)}

    def _place(self, kind: str, label: str, line: int) -> int:
        labels = self.sim.labels
        if number := labels.number(kind, label):
            return number
        types = getattr(self.sim, f"{kind}_types")
        free = next((k for k in range(1, types + 1) if k not in labels.of(kind)), 0)
        if not free:
            hint = f"extra/{kind}/types in the first read_data or create_box; {label} is new"
            self.file.fail("Topology type exceeds system topology type", line, hint=hint)
        labels.assign(kind, free, label)
        return free
