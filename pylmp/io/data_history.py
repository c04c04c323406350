"""What LAMMPS's data files lack to continue a run exactly, as comment lines at the end of the file: LAMMPS passes over them.

    # Bond History
    #
    # step 1000
    # time 10
    # margins 0.001 0.001 0.001              shrink-wrapped boxes only: how far faces stay outside the atoms,
    # least 0 0 0 10 10 10                   and boundary m: where faces stay at least
    # style bpm/spring/plastic r0 ep         a line a style that remembers
    # slots 2
    # atom partner type ...
    # 1 2 1 1.0000000000000002 0
    # 2 1 1 1.0000000000000002 0

A row is a bond slot of an atom, in the order in which the atoms store them: sums of forces go in that order. Type 0 is a broken bond, a
negative one is turned off; neither is known to the section Bonds. Numbers are the shortest that read back as the same bits.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pylmp.io.data_file import DataFile
from pylmp.io.data_topology import Scanned
from pylmp.model import bond_memory
from pylmp.model.atoms import Floats, Ints
from pylmp.model.simulation import Simulation
from pylmp.model.topology import BOND, entries
from pylmp.model.waiting import Waiting
from pylmp.text.diagnostic import ScriptError
from pylmp.text.number import shortest

if TYPE_CHECKING:
    from pylmp.model.bond import BondPart

TITLE = "# Bond History"
_MANUAL = "bond_bpm_spring_plastic.html"


def history_text(sim: Simulation) -> str:
    """The lines. Raises ScriptError if no run has set up what bonds remember."""
    parts = [part for part in sim.bond.parts if part.memory] if sim.bond else []
    for part in parts:
        if not part.stored:
            says = f"Cannot write bond history: bonds of style {part.style.name} remember nothing yet"
            raise ScriptError(says, hint="run 0 sets r0 of every bond", manual=_MANUAL)
    lines = [TITLE, "#", f"# step {sim.step}", f"# time {shortest(sim.output.time())}"]
    box = sim.box
    if box.shrinking:
        lines.append("# margins " + _words(box.margin))
        lines.append("# least " + _words(np.concatenate([box.least_lo, box.least_hi])))
    lines += [f"# style {part.style.name} {' '.join(part.style.history)}" for part in parts]
    found, memory = entries(sim, BOND), _remembered(sim)
    lines += [f"# slots {len(found)}", "# atom partner type ..."]
    widths = _widths(sim.bond_types, [(part, part.memory) for part in parts])
    rows = zip(found.tags.tolist(), found.types.tolist(), memory[found.rows, found.slots].tolist(), strict=True)
    for (atom, partner), kind, values in rows:
        lines.append(" ".join(["#", str(atom), str(partner), str(kind), *map(shortest, values[: widths[max(kind, -kind)]])]))
    return "\n".join(lines) + "\n"


def _words(values: Floats) -> str:
    return " ".join(map(shortest, values.tolist()))


def _widths(types: int, parts: list[tuple[BondPart, int]]) -> list[int]:
    """How many numbers a bond remembers, by type; 0 for type 0."""
    return [next((memory for part, memory in parts if kind and part.mine[kind]), 0) for kind in range(types + 1)]


def _remembered(sim: Simulation) -> Floats:
    """(capacity, slots, memory) what each slot remembers now, as the next run would take it from the bond lists."""
    atoms = sim.atoms
    kept, states = atoms.bond_history.copy(), [(listed, listed.fresh, listed.misplaced) for listed in sim.bond_lists]
    for listed in sim.bond_lists:
        listed.copy_back(sim)
    now = atoms.bond_history.copy()
    atoms.bond_history[:] = kept
    for listed, fresh, misplaced in states:
        listed.fresh, listed.misplaced = fresh, misplaced
    return now


class History:
    """The lines of one file: read(), then restore() into the simulation whose atoms and bonds were read."""

    def __init__(self, file: DataFile) -> None:
        self.file = file
        titles = [number for number, line in enumerate(file.lines) if line.strip() == TITLE]
        if not titles:
            hint = "write_data FILE bond/history writes one"
            file.fail("No bond history in data file", max(0, len(file.lines) - 1), hint=hint)
        self.at = titles[0] + 2
        self.settings: dict[str, list[float]] = {}
        self.styles: dict[str, int] = {}

    def _take(self) -> list[str]:
        """The words of the next line."""
        file = self.file
        if self.at >= len(file.lines):
            file.fail("Unexpected end of bond history in data file", max(0, len(file.lines) - 1))
        words = file.lines[self.at].split()
        if words[:1] != ["#"] or len(words) < 2:
            file.fail(f"Invalid line in bond history of data file: {file.lines[self.at].strip()}", self.at, hint="# words")
        self.at += 1
        return words[1:]

    def _head(self) -> int:
        """The lines before the rows; returns how many rows there are."""
        wanted = {"step": 1, "time": 1, "margins": 3, "least": 6}
        while True:
            key, *words = self._take()
            line = self.at - 1
            if key == "slots" and len(words) == 1:
                count = self.file.integer(words[0], line)
                if count < 0:
                    self.file.fail(f"Invalid number of slots {count} in bond history of data file", line)
                self._take()
                return count
            if key == "style" and words:
                self.styles[words[0]] = len(words) - 1
            elif len(words) == wanted.get(key):
                self.settings[key] = [self.file.number(word, line) for word in words]
            else:
                self.file.fail(f"Unknown line in bond history of data file: {self.file.lines[line].strip()}", line)

    def restore(self, sim: Simulation, scanned: Scanned | None) -> None:
        """Slots, what they remember, step and time. scanned: the section Bonds, with which the rows must agree."""
        sim.console.both("  reading bond history ...\n")
        file, first = self.file, self.at - 2
        count = self._head()
        table, values, lines = [], [], []
        most = max(self.styles.values(), default=0)
        for _ in range(count):
            words = self._take()
            line = self.at - 1
            if not 3 <= len(words) <= 3 + most:
                file.fail(f"Incorrect format in bond history of data file: {file.lines[line].strip()}", line, hint="atom partner type ...")
            table.append([file.integer(word, line) for word in words[:3]])
            values.append([file.number(word, line) for word in words[3:]] + [0.0] * (most + 3 - len(words)))
            lines.append(line)
        slots = np.array(table, np.int64).reshape(-1, 3)
        self._compare(sim, slots, np.array(lines, np.int64), scanned, first)
        self._store(sim, slots, np.array(values, float).reshape(len(slots), most))
        sim.step = int(self.settings.get("step", [0])[0])
        sim.output.clock.set(sim.step, self.settings.get("time", [0.0])[0])
        sim.console.both(f"  {len(slots)} slots, step {sim.step}\n")

    def restore_box(self, sim: Simulation, lo: list[float], hi: list[float]) -> None:
        """Faces as they stand in the file, and how far they stay outside the atoms."""
        sim.box.place(np.array(lo), np.array(hi))
        if "margins" in self.settings and "least" in self.settings:
            sim.box.margin = np.array(self.settings["margins"])
            sim.box.least_lo, sim.box.least_hi = np.split(np.array(self.settings["least"]), 2)

    def _compare(self, sim: Simulation, slots: Ints, lines: Ints, scanned: Scanned | None, first: int) -> None:
        """Every row that is not broken must be a bond of the section Bonds, and every bond a row."""
        by_tag = sim.atoms.rows_by_tag()
        in_range = np.all((slots[:, :2] > 0) & (slots[:, :2] < len(by_tag)), axis=1)
        there = np.all(by_tag[np.where(in_range[:, None], slots[:, :2], 0)] >= 0, axis=1)
        known = np.asarray(in_range & there & (slots[:, 0] != slots[:, 1]) & (np.abs(slots[:, 2]) <= sim.bond_types))
        if not known.all():
            line = int(lines[int(np.argmin(known))])
            self.file.fail(f"Invalid atom ID or bond type in bond history of data file: {self.file.lines[line].strip()}", line)
        whole = slots[slots[:, 2] != 0]
        rows = np.column_stack([whole[:, :2], np.abs(whole[:, 2])])
        bonds = np.zeros((0, 3), np.int64)
        if scanned is not None:
            bonds = np.column_stack([scanned.tags, scanned.types])
        if not sim.newton_bond:
            bonds = np.concatenate([bonds, bonds[:, [1, 0, 2]]])
        order = [np.lexsort(table.T[::-1]) for table in (rows, bonds)]
        if rows.shape != bonds.shape or (rows[order[0]] != bonds[order[1]]).any():
            hint = "the section Bonds was edited, or the file was written with another newton setting"
            self.file.fail("Bond history of data file does not fit its bonds", first, hint=hint)

    def _store(self, sim: Simulation, slots: Ints, values: Floats) -> None:
        atoms = sim.atoms
        rows = atoms.rows_by_tag()[slots[:, 0]]
        counts = np.bincount(rows, minlength=atoms.n)
        atoms.widen("bond", int(counts.max(initial=0)))
        place = np.empty(len(rows), np.int64)
        place[np.argsort(rows, kind="stable")] = np.arange(len(rows)) - np.repeat(np.cumsum(counts) - counts, counts)
        atoms.bond_type[: atoms.n], atoms.bond_atom[: atoms.n] = 0, 0
        atoms.num_bond[: atoms.n] = counts
        atoms.bond_type[rows, place], atoms.bond_atom[rows, place] = slots[:, 2], slots[:, 1]
        BOND.recount(sim)
        if self.styles:
            sim.waiting = Waiting("data file")
        for name, width in self.styles.items():
            kept = np.zeros((atoms.capacity, atoms.bond_per_atom, width))
            kept[rows, place] = values[:, :width]
            sim.waiting.add(bond_memory.flag_id(name), bond_memory.FLAG, bond_memory.KNOWN)
            sim.waiting.add_atoms(sim, bond_memory.per_atom_id(name), bond_memory.PER_ATOM, kept.reshape(atoms.capacity, -1))
