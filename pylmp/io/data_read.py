"""read_data: fill a simulation from a data file.

A file with bonds, angles, ... is read twice, as LAMMPS does, to count and to store; the box is set twice, and shrinking faces move outward twice.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pylmp.commands.create_box import announce
from pylmp.io.data_coeffs import Section, coefficients_of, read_bonded_coeffs, read_masses, read_pair_coeffs, warn_style
from pylmp.io.data_file import DataFile, Header
from pylmp.io.data_history import History
from pylmp.io.data_rows import read_atoms, read_velocities
from pylmp.io.data_topology import Scanned, keep, scan
from pylmp.io.data_types import TypeMap
from pylmp.kernels.exact.wrapping import ten_bits
from pylmp.model.atoms import MOST_SLOTS, MOST_TYPES, Atoms, Floats, Ints
from pylmp.model.box import FARTHEST, Box
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.model.topology import BOND, KIND, KINDS
from pylmp.model.triclinic import Triclinic
from pylmp.text.diagnostic import Unsupported

_EDGE = 1.0e-6  # of the box length: how far outside a periodic face a wrapped atom may lie
_LARGEST_ID = 20_000_000  # tables by ID are kept
Mask = NDArray[np.bool_]


@dataclass
class Options:
    """What the words after the file name ask for.

    add                  None, "append", "merge" or a number of IDs
    offsets              what is added to types, by kind ("atom", "bond", ...)
    group                its bit, 0 none
    types, per_atom      extra/KIND/types, extra/KIND/per/atom (special too) by kind
    history              the lines of write_data bond/history are to be read
    """

    add: str | int | None = None
    molecule_offset: int = 0
    offsets: dict[str, int] = field(default_factory=dict)
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    group: int = 0
    types: dict[str, int] = field(default_factory=dict)
    per_atom: dict[str, int] = field(default_factory=dict)
    coeffs: bool = True
    history: bool = False


def read_data(sim: Simulation, path: Path, text: str, options: Options) -> None:
    """Read text, the content of path. Raises ScriptError at a place in the file."""
    Reader(sim, DataFile(path, text), options).read()


class Reader:
    """One data file on its way into one simulation."""

    def __init__(self, sim: Simulation, file: DataFile, options: Options) -> None:
        self.sim, self.file, self.options = sim, file, options
        self.header = Header()
        self.old = sim.atoms.n if options.add is not None else 0  # atoms that were there before
        self.id_offset = self.molecule_offset = 0
        self.types = TypeMap(sim, file, options.offsets)
        self.seen: set[str] = set()  # sections read
        self.scanned: list[Scanned] = []
        self.history = History(file) if options.history else None

    def read(self) -> None:
        sim, file = self.sim, self.file
        sim.console.both("Reading data file ...\n")
        self.header = file.header()
        self._check_header()
        if self.options.add is None:
            self._make_box()
        else:
            self._grow_box()
        for name, style, line in file.sections():
            self._section(name, style, line)
        if self.header.count("atoms") and "Atoms" not in self.seen:
            file.fail("No valid atoms found in data file", len(file.lines), hint="a section Atoms")
        for kind in KINDS:
            if (count := self.header.count(kind.plural)) and kind.plural.capitalize() not in self.seen:
                says = f"{kind.plural.capitalize()} section for {count} {kind.plural} not found"
                file.fail(says, self.header.lines[kind.plural], kind.plural)
        if self.scanned:
            announce(sim)
        for found in self.scanned:
            keep(sim, found)
        x = sim.atoms.x[: sim.atoms.n]
        if self.history is not None:
            self.history.restore(sim, next((found for found in self.scanned if found.kind is BOND), None))
            self.history.restore_box(sim, self.header.lo, self.header.hi)
        else:
            sim.box.enter(x)
            sim.box.shrink(sim.atoms, sim.natoms)
            sim.box.leave(x)
        if sim.has_bonds:
            build_special(sim)
        sim.console.both("  read_data CPU = 0.000 seconds\n")

    # ---- header and box -----------------------------------------------------------------------------------------

    def _check_header(self) -> None:
        sim, file, header = self.sim, self.file, self.header
        if header.units and header.units != sim.units.name:
            sim.console.warning(
                f"Inconsistent units in data file: current = {sim.units.name}, data file = {header.units}"
            )
        for name in ("ellipsoids", "lines", "triangles", "bodies"):
            if name in header.counts:
                file.fail(f"No {name} allowed with this atom style", header.lines[name])
        for name, count in header.counts.items():
            most = MOST_TYPES if name.endswith("types") else MOST_SLOTS if name.startswith("extra") else count
            if count > most:
                file.fail(f"Data file asks for too many {name}: {count}", header.lines[name], hint=f"at most {most}")
        for kind in KINDS:
            for name in (kind.plural, f"{kind.name} types"):
                if header.count(name) and kind not in sim.style.kinds:
                    hint = f"atom_style is {sim.atom_style}"
                    file.fail(f"No {kind.plural} allowed with this atom style", header.lines[name], hint=hint)
        for kind in KINDS:
            if header.count(kind.plural) and not header.count(f"{kind.name} types"):
                says = f"{kind.plural.capitalize()} defined but no {kind.name} types"
                file.fail(says, header.lines[kind.plural], hint=f"a line such as: 1 {kind.name} types")
        if sim.dimension == 2 and not header.lo[2] < 0.0 < header.hi[2]:
            file.fail("Read_data zlo/zhi for 2d simulation must straddle 0.0", 0, hint="-0.5 0.5 zlo zhi")
        for axis, low, high in zip("xyz", header.lo, header.hi, strict=True):
            if not low < high:
                file.fail("Box bounds are invalid or missing", header.lines[f"{axis}lo"], hint="the lower bound first")

    def _make_box(self) -> None:
        sim, header, options = self.sim, self.header, self.options
        lo, hi = np.array(header.lo), np.array(header.hi)
        if header.tilt is None:
            sim.box = Box(lo, hi, sim.boundary, sim.dimension)
        else:
            sim.box = Triclinic(lo, hi, sim.boundary, sim.dimension, np.array(header.tilt))
        announce(sim)
        names = ("atom", *(kind.name for kind in KINDS))
        sim.define_types(*(header.count(f"{name} types") + options.types.get(name, 0) for name in names))
        room = {
            kind.name: max(options.per_atom.get(kind.name, 0), header.count(f"extra {kind.name} per atom"))
            for kind in sim.style.kinds
        }
        sim.extra_slots = dict(room)
        sim.atoms = Atoms(room.pop("bond", 0), 1, **room)
        sim.extra_special = max(options.per_atom.get("special", 0), header.count("extra special per atom"))
        sim.natoms = sim.bonds = sim.angles = sim.dihedrals = sim.impropers = sim.step = 0

    def _grow_box(self) -> None:
        """The box that holds the old one and the shifted new one."""
        sim, header, shift = self.sim, self.header, np.array(self.options.shift)
        sim.extra_slots.update((kind, count) for kind, count in self.options.per_atom.items() if kind != "special")
        box = sim.box
        if says := header.other_tilt(box.tilt.tolist() if box.triclinic else None):
            self.file.fail(says, header.tilted)
        if box.shrinking:
            raise Unsupported("LAMMPS has read_data add in shrink-wrapped boxes, pylmp's native engines do not")
        lo, hi = np.minimum(box.lo, header.lo + shift), np.maximum(box.hi, header.hi + shift)
        if (lo < box.lo).any() or (hi > box.hi).any():
            sim.console.warning("Non-zero image flags with growing box can produce bad coordinates")
        box.place(lo, hi)
        announce(sim)
        tags, molecules = sim.atoms.tag[: self.old], sim.atoms.molecule[: self.old]
        if self.options.add == "append":
            self.id_offset, self.molecule_offset = int(tags.max(initial=0)), int(molecules.max(initial=0))
        elif isinstance(self.options.add, int):
            self.id_offset, self.molecule_offset = self.options.add, self.options.molecule_offset

    # ---- sections -----------------------------------------------------------------------------------------------

    def _section(self, name: str, style: str, line: int) -> None:
        sim, file, count = self.sim, self.file, self.header.count
        if name == "Atoms":
            warn_style(sim, "Atom", style, sim.atom_style)
            self._atoms(line)
        elif name == "Velocities":
            self._after_atoms(name, line)
            sim.console.both("  reading velocities ...\n")
            lines = file.take(count("atoms"), f"the header promises {count('atoms')} atoms")
            rows, values = read_velocities(file, lines, self._rows_by_tag())
            sim.atoms.v[rows] = values
            sim.console.both(f"  {len(lines)} velocities\n")
        elif (kind := KIND.get(name.lower()[:-1])) is not None and count(kind.plural):
            self._after_atoms(name, line)
            adds = self.options.add is not None
            self.scanned.append(scan(sim, file, kind, count(kind.plural), self.types, self.id_offset, adds))
            if name in self.seen:
                file.fail(f"{name} assigned incorrectly", line, hint="one section of a kind")
        elif name == "Masses":
            read_masses(sim, file, count("atom types"), self.types)
        elif name in ("Pair Coeffs", "PairIJ Coeffs"):
            read_pair_coeffs(self._coefficients(name, style, line), count("atom types"))
        elif name.endswith(" Coeffs") and (kind := coefficients_of(name)) in sim.style.kinds:
            assert kind is not None
            read_bonded_coeffs(self._coefficients(name, style, line), kind, count(f"{kind.name} types"))
        elif name.endswith(" Type Labels"):
            self._labels(name.split()[0].lower(), name, line)
        else:
            hint = f"not with atom_style {sim.atom_style} and these counts"
            file.fail(f"Invalid data file section: {name}", line, hint=hint)
        self.seen.add(name)

    def _coefficients(self, name: str, style: str, line: int) -> Section:
        return Section(self.sim, self.file, name, style, line, self.options.coeffs, self.types)

    def _labels(self, kind: str, name: str, line: int) -> None:
        rows = f"{kind.capitalize()}s"
        if rows in self.seen:
            self.file.fail(f"Must read {name} before {rows}", line)
        if any(seen == "Masses" or seen.endswith("Coeffs") for seen in self.seen):
            self.file.fail("Must read Type Labels before any section involving types", line)
        types = self.header.count(f"{kind} types")
        if types:
            self.types.read_labels(kind, types, line)
        else:
            self.file.at -= 1  # LAMMPS looks for the next section at once

    def _after_atoms(self, name: str, line: int) -> None:
        if "Atoms" not in self.seen:
            self.file.fail(f"Must read Atoms before {name}", line)

    def _rows_by_tag(self) -> Ints:
        """Rows of the IDs in the file, the offset of read_data add taken off."""
        rows = self.sim.atoms.rows_by_tag()
        return np.concatenate([[-1], rows[self.id_offset + 1 :]]) if self.id_offset else rows

    def _atoms(self, line: int) -> None:
        sim, file, shift = self.sim, self.file, np.array(self.options.shift)
        sim.console.both("  reading atoms ...\n")
        count = self.header.count("atoms")
        lines = file.take(count, f"the header promises {count} atoms")
        read = read_atoms(file, lines, sim.style, self.types, sim.dimension == 2)
        if len(read.tag) and read.tag.max() + self.id_offset > _LARGEST_ID:
            far = int(read.line[np.argmax(read.tag)])
            raise Unsupported(f"LAMMPS has atom IDs above {_LARGEST_ID}, pylmp's native engines do not", file.span(far))
        for d, periodic in enumerate(sim.box.periodic):
            if not periodic and read.image[:, d].any():
                sim.console.warning(
                    f"Non-zero imageflag(s) in {'xyz'[d]} direction for non-periodic boundary reset to zero"
                )
                read.image[:, d] = 0
        image = ten_bits(read.image)
        x = read.x + shift if shift.any() else read.x.copy()
        inside = self._place(x, image, read.line)
        if self.history is not None:  # as they were written, also where entering a tilted box would round them
            still = (ten_bits(read.image) == ten_bits(image)).all(axis=1)
            x = np.where(still[:, None], read.x, x)
        rows = sim.atoms.append(x[inside], np.asarray(read.columns["type"], np.int64)[inside])
        new = slice(rows.start, rows.stop)
        offsets = {"tag": self.id_offset, "molecule": self.molecule_offset, "q": 0}
        for name, values in read.columns.items():
            if name in offsets:
                getattr(sim.atoms, name)[new] = values[inside] + offsets[name]
        sim.atoms.image[new] = ten_bits(image[inside])
        sim.atoms.mask[new] |= self.options.group
        sim.console.both(f"  {len(rows)} atoms\n")
        if len(rows) != count or "Atoms" in self.seen:
            lost = int(read.line[np.argmin(inside)]) if not inside.all() else line
            file.fail(
                "Did not assign all atoms correctly",
                lost,
                hint=f"{count} atoms inside the box, each on a line of its own",
            )
        sim.natoms += count
        tags, places = np.unique(sim.atoms.tag[: sim.atoms.n], return_index=True)
        if len(tags) != sim.atoms.n:
            twice = int(np.setdiff1d(np.arange(sim.atoms.n), places)[0])
            where = int(read.line[inside][max(0, twice - self.old)])
            file.fail("Duplicate atom IDs exist", where, hint=f"ID {int(sim.atoms.tag[twice])} is there twice")

    def _place(self, x: Floats, image: Ints, lines: Ints) -> Mask:
        """Wrap x and image in place; (k,) bool: which atoms lie in the box then."""
        box = self.sim.box
        for d, periodic in enumerate(box.periodic):
            far = np.abs(x[:, d] - box.lo[d]) > FARTHEST * box.length[d]
            if periodic and far.any():
                self.file.fail(
                    "Atom is too far outside the periodic box",
                    int(lines[np.argmax(far)]),
                    hint=f"within {FARTHEST:g} lengths",
                )
        box.remap(x, image)
        lo, hi = box.frame
        edge = np.where(box.periodic, _EDGE * (hi - lo), 0.0)
        framed = x.copy()
        box.enter(framed)
        inside: Mask = (framed >= lo - edge) & (framed < hi + edge)
        return np.asarray(inside.all(axis=1))
