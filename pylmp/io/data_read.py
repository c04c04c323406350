"""read_data: fill a simulation from a data file.

A file with bonds is read twice, as LAMMPS does, to count and to store; the box is set twice, and shrinking faces move outward twice.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pylmp.commands.create_box import announce
from pylmp.io.data_coeffs import Section, read_bond_coeffs, read_masses, read_pair_coeffs, warn_style
from pylmp.io.data_file import DataFile, Header
from pylmp.io.data_rows import read_atoms, read_bonds, read_velocities
from pylmp.model.atoms import Atoms, Floats, Ints
from pylmp.model.box import Box
from pylmp.model.simulation import Simulation
from pylmp.model.special import build_special
from pylmp.model.triclinic import Triclinic
from pylmp.text.diagnostic import Unsupported

_EDGE = 1.0e-6  # of the box length: how far outside a periodic face a wrapped atom may lie
_FARTHEST = 1.0e6  # box lengths: nobody means an atom farther out
_LARGEST_ID = 20_000_000  # tables by ID are kept
_ANGULAR = "angle", "dihedral", "improper"
Mask = NDArray[np.bool_]


@dataclass
class Options:
    """What the words after the file name ask for. add: None, "append", "merge" or a number of IDs; group: its bit, 0 none."""

    add: str | int | None = None
    molecule_offset: int = 0
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    group: int = 0
    atom_types: int = 0
    bond_types: int = 0
    bond_per_atom: int = 0
    special_per_atom: int = 0
    coeffs: bool = True


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
        self.atoms_read = False
        self.bonds: tuple[Ints, Ints] | None = None

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
        if self.header.count("atoms") and not self.atoms_read:
            file.fail("No valid atoms found in data file", len(file.lines), hint="a section Atoms")
        if self.header.count("bonds"):
            if self.bonds is None:
                count = self.header.count("bonds")
                file.fail(f"Bonds section for {count} bonds not found", self.header.lines["bonds"], "bonds")
            announce(sim)
            self._store_bonds(*self.bonds)
        x = sim.atoms.x[: sim.atoms.n]
        sim.box.enter(x)
        sim.box.shrink(sim.atoms)
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
        for kind in ("bond", *_ANGULAR):
            for name in (f"{kind}s", f"{kind} types"):
                if header.count(name):
                    self._check_kind(kind, header.lines[name])
        if header.count("bonds") and not header.count("bond types"):
            file.fail("Bonds defined but no bond types", header.lines["bonds"], hint="a line such as: 1 bond types")
        if sim.dimension == 2 and not header.lo[2] < 0.0 < header.hi[2]:
            file.fail("Read_data zlo/zhi for 2d simulation must straddle 0.0", 0, hint="-0.5 0.5 zlo zhi")

    def _check_kind(self, kind: str, line: int) -> None:
        sim = self.sim
        if kind == "bond" and sim.has_bonds:
            return
        if kind == "bond" or sim.atom_style != "molecular":
            self.file.fail(f"No {kind}s allowed with this atom style", line, hint=f"atom_style is {sim.atom_style}")
        raise Unsupported(f"LAMMPS has {kind}s, pylmp's native engines do not", self.file.span(line))

    def _make_box(self) -> None:
        sim, header, options = self.sim, self.header, self.options
        types = header.count("atom types") + options.atom_types
        bond_types = header.count("bond types") + options.bond_types
        lo, hi = np.array(header.lo), np.array(header.hi)
        if header.tilt is None:
            sim.box = Box(lo, hi, sim.boundary, sim.dimension)
        else:
            sim.box = Triclinic(lo, hi, sim.boundary, sim.dimension, np.array(header.tilt))
        announce(sim)
        sim.define_types(types, bond_types)
        slots = max(options.bond_per_atom, header.count("extra bond per atom"))
        sim.atoms = Atoms(slots if sim.has_bonds else 0, 1)
        sim.extra_special = max(options.special_per_atom, header.count("extra special per atom"))
        sim.natoms = sim.bonds = sim.step = 0

    def _grow_box(self) -> None:
        """The box that holds the old one and the shifted new one."""
        sim, header, shift = self.sim, self.header, np.array(self.options.shift)
        box = sim.box
        if box.shrinking:
            raise Unsupported("LAMMPS has read_data add in shrink-wrapped boxes, pylmp's native engines do not")
        if header.count("atom types") > sim.atom_types or header.count("bond types") > sim.bond_types:
            name = "atom types" if header.count("atom types") > sim.atom_types else "bond types"
            self.file.fail(
                f"The data file has more {name} than the simulation", self.header.lines[name],
                hint=f"extra/{name.replace(' ', '/')} in the first read_data",
            )  # fmt: skip
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
        elif name == "Bonds" and count("bonds"):
            self._after_atoms(name, line)
            self._scan_bonds()
        elif name == "Masses":
            read_masses(sim, file, count("atom types"))
        elif name in ("Pair Coeffs", "PairIJ Coeffs"):
            read_pair_coeffs(self._coefficients(name, style, line), count("atom types"))
        elif name == "Bond Coeffs" and sim.has_bonds:
            read_bond_coeffs(self._coefficients(name, style, line), count("bond types"))
        elif name.endswith("Type Labels"):
            raise Unsupported("LAMMPS has type labels, pylmp's native engines do not", file.span(line))
        else:
            file.fail(
                f"Invalid data file section: {name}",
                line,
                hint=f"not with atom_style {sim.atom_style} and these counts",
            )

    def _coefficients(self, name: str, style: str, line: int) -> Section:
        return Section(self.sim, self.file, name, style, line, self.options.coeffs)

    def _after_atoms(self, name: str, line: int) -> None:
        if not self.atoms_read:
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
        read = read_atoms(file, lines, sim.atom_types, sim.has_bonds, sim.dimension == 2)
        if len(read.tag) and read.tag.max() + self.id_offset > _LARGEST_ID:
            far = int(read.line[np.argmax(read.tag)])
            raise Unsupported(f"LAMMPS has atom IDs above {_LARGEST_ID}, pylmp's native engines do not", file.span(far))
        for d, periodic in enumerate(sim.box.periodic):
            if not periodic and read.image[:, d].any():
                sim.console.warning(
                    f"Non-zero imageflag(s) in {'xyz'[d]} direction for non-periodic boundary reset to zero"
                )
                read.image[:, d] = 0
        image = _ten_bits(read.image)
        x = read.x + shift if shift.any() else read.x
        inside = self._place(x, image, read.line)
        rows = sim.atoms.append(x[inside], read.type[inside])
        new = slice(rows.start, rows.stop)
        sim.atoms.tag[new] = read.tag[inside] + self.id_offset
        molecule = read.molecule[inside]
        sim.atoms.molecule[new] = molecule + self.molecule_offset if sim.has_bonds else 0
        sim.atoms.image[new] = _ten_bits(image[inside])
        sim.atoms.mask[new] |= self.options.group
        sim.console.both(f"  {len(rows)} atoms\n")
        if len(rows) != count or self.atoms_read:
            lost = int(read.line[np.argmin(inside)]) if not inside.all() else line
            file.fail(
                "Did not assign all atoms correctly",
                lost,
                hint=f"{count} atoms inside the box, each on a line of its own",
            )
        self.atoms_read = True
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
            far = np.abs(x[:, d] - box.lo[d]) > _FARTHEST * box.length[d]
            if periodic and far.any():
                self.file.fail(
                    "Atom is too far outside the periodic box",
                    int(lines[np.argmax(far)]),
                    hint=f"within {_FARTHEST:g} lengths",
                )
        box.remap(x, image)
        lo, hi = box.frame
        edge = np.where(box.periodic, _EDGE * (hi - lo), 0.0)
        framed = x.copy()
        box.enter(framed)
        inside: Mask = (framed >= lo - edge) & (framed < hi + edge)
        return np.asarray(inside.all(axis=1))

    def _scan_bonds(self) -> None:
        sim, file, count = self.sim, self.file, self.header.count("bonds")
        sim.console.both("  scanning bonds ...\n")
        first = file.at
        lines = file.take(count, f"the header promises {count} bonds")
        kinds, pairs = read_bonds(file, lines, sim.bond_types, sim.atoms.rows_by_tag(), self.id_offset)
        ends = pairs[:, :1] if sim.newton_bond else pairs
        owners = sim.atoms.rows_by_tag()[ends.ravel()]
        most = int(np.bincount(owners, minlength=1).max(initial=0))
        if self.options.add is None:
            most += sim.atoms.bond_per_atom  # so far what extra/bond/per/atom asked for
        sim.console.both(f"  {most} = max bonds/atom\n")
        if self.bonds is not None or len(kinds) != count:
            file.fail(
                "Bonds assigned incorrectly", first, hint=f"one section with {count} bonds, each on a line of its own"
            )
        sim.atoms.widen_bonds(most)
        self.bonds = kinds, pairs

    def _store_bonds(self, kinds: Ints, pairs: Ints) -> None:
        """Slots in file order; with newton bond off at both ends."""
        sim, atoms = self.sim, self.sim.atoms
        sim.console.both("  reading bonds ...\n")
        rows = atoms.rows_by_tag()
        for kind, (one, two) in zip(kinds.tolist(), pairs.tolist(), strict=True):
            for tag, partner in ((one, two), (two, one)):
                row = int(rows[tag])
                slot = int(atoms.num_bond[row])
                atoms.bond_type[row, slot], atoms.bond_atom[row, slot] = kind, partner
                atoms.num_bond[row] = slot + 1
                if sim.newton_bond:
                    break
        sim.bonds += len(kinds)
        sim.console.both(f"  {len(kinds)} bonds\n")


def _ten_bits(image: Ints) -> Ints:
    """Image flags as LAMMPS keeps them, -512 to 511."""
    return ((image + 512) & 1023) - 512
