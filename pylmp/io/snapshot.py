"""read_dump and rerun: a snapshot of a dump becomes the state of a simulation.

Source: LAMMPS manual, read_dump.html; what happens to boxes, images and the order of atoms as measured on LAMMPS 22 Jul 2025.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pylmp.commands.create_box import describe
from pylmp.io.dump_file import MANUAL, DumpFile, Snapshot
from pylmp.model.atoms import Floats, Ints
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.words import Args

PLACES = ("x", "y", "z")
FIELDS = (*PLACES, "vx", "vy", "vz", "q", "ix", "iy", "iz", "fx", "fy", "fz")
_LABELS = {axis: (axis, f"{axis}s", f"{axis}u", f"{axis}su") for axis in PLACES}
_SCALED, _UNWRAPPED = ("s", "su"), ("u", "su")
_YES_NO = ("box", "timestep", "replace", "purge", "trim", "scaled", "wrapped")


@dataclass
class Request:
    """What the words behind the file's name ask for. fields: as given; labels: names of columns instead of fields' own."""

    fields: list[str] = field(default_factory=list)
    labels: dict[str, str] = field(default_factory=dict)
    box: bool = True
    timestep: bool = True
    replace: bool = True
    purge: bool = False
    trim: bool = False
    add: str = "no"
    scaled: bool = False
    wrapped: bool = True


def read_request(sim: Simulation, args: Args, in_pieces: bool) -> Request:
    """Take fields, then keywords. Raises ScriptError with LAMMPS's sentences."""
    request, pieces = Request(), 0
    while (word := args.peek()) is not None and (word.text in FIELDS or word.text in ("id", "type")):
        args.word()
        if word.text == "q" and not sim.style.charged:
            args.fail("Read dump of charge property that isn't supported by atom style", word, hint="atom_style charge or full")
        if word.text in FIELDS:
            request.fields.append(word.text)
    if not request.fields:
        args.fail("Read_dump command has no or invalid attribute fields", args.peek() or args.owner, hint=" ".join(FIELDS))
    if sim.dimension == 2 and set(request.fields) & {"z", "vz", "iz", "fz"}:
        args.fail("Illegal read_dump command", hint="no z fields in two dimensions")
    if len(set(request.fields)) < len(request.fields):
        args.fail("Duplicate fields in read_dump command", hint="each field once")
    while len(args):
        key = args.word()
        if key.text in _YES_NO:
            args.need(1, key.text)
            setattr(request, key.text, args.yes())
        elif key.text == "add":
            args.need(1, key.text)
            choice = args.word()
            if choice.text not in ("yes", "no", "keep"):
                args.fail(f"Unknown read_dump add keyword {choice.text}", choice, hint="yes, no or keep")
            request.add = choice.text
        elif key.text == "label":
            args.need(2, key.text)
            name = args.word()
            if name.text not in (*request.fields, "id", "type"):
                args.fail("Illegal read_dump command", name, hint="one of the fields, id or type")
            request.labels[name.text] = args.word().text
        elif key.text == "nfile":
            args.need(1, key.text)
            pieces = args.integer()
        elif key.text == "format":
            _format(args)
        else:
            args.fail(f"Unknown read_dump keyword: {key.text}", key, hint=" ".join((*_YES_NO, "add label nfile format")))
    if pieces and not in_pieces:
        args.fail("Dump file is not a multi-proc file", hint="nfile belongs to a name with %")
    if in_pieces and not pieces:
        args.fail("Dump file is a multi-proc file", hint="nfile says how many files there are")
    if in_pieces:
        raise Unsupported("LAMMPS has read_dump of files in pieces, pylmp's native engines do not", manual=MANUAL)
    if request.purge and (request.replace or request.trim):
        args.fail("If read_dump purges it cannot replace or trim", hint="replace no")
    return request


def _format(args: Args) -> None:
    args.need(1, "format")
    style = args.word()
    if style.text in ("xyz", "molfile", "adios"):
        raise Unsupported(f"LAMMPS has read_dump format {style.text}, pylmp's native engines do not", style.span, manual=MANUAL)
    if style.text != "native":
        args.fail(f"Unrecognized reader style '{style.text}'", style, hint="native")
    if len(args):
        args.illegal(args.peek())


class Reader:
    """Snapshots of some files one after the other, and what to do with each."""

    def __init__(self, sim: Simulation, names: list[str], request: Request) -> None:
        self.sim = sim
        self.names = names
        self.request = request

    def snapshots(self) -> Iterator[Snapshot]:
        for name in self.names:
            yield from DumpFile(name).snapshots()

    # ---- columns ------------------------------------------------------------------------------------------------

    def columns(self, snapshot: Snapshot) -> dict[str, int]:
        """Where each field stands; also id, and type where atoms may be added."""
        request = self.request
        wanted = ["id", *(["type"] if request.add != "no" else []), *request.fields]
        found = {}
        for name in wanted:
            labels = (request.labels[name],) if name in request.labels else _LABELS.get(name, (name,))
            label = next((label for label in labels if label in snapshot.columns), None)
            if label is None:
                raise ScriptError(
                    "One of the requested read_dump per-atom fields not found in dump file", manual=MANUAL,
                    hint=f"{snapshot.file.name} has {' '.join(snapshot.columns)}",
                )  # fmt: skip
            found[name] = snapshot.columns.index(label)
        return found

    def _kind(self, snapshot: Snapshot, columns: dict[str, int]) -> tuple[bool, bool]:
        """Coordinates are scaled; wrapped."""
        kinds = set()
        for axis in PLACES:
            if axis not in columns:
                continue
            ending = snapshot.columns[columns[axis]].removeprefix(axis)
            if axis in self.request.labels:
                kinds.add((self.request.scaled, self.request.wrapped))
            else:
                kinds.add((ending in _SCALED, ending not in _UNWRAPPED))
        if len(kinds) > 1:
            raise ScriptError("Read_dump xyz fields do not have consistent scaling/wrapping", manual=MANUAL)
        scaled, wrapped = kinds.pop() if kinds else (False, False)  # without coordinates LAMMPS takes them for unwrapped
        if scaled and snapshot.tilt is not None and not all(axis in columns for axis in PLACES):
            raise ScriptError("All read_dump x,y,z fields must be specified for scaled, triclinic coords", manual=MANUAL)
        return scaled, wrapped

    # ---- one snapshot -------------------------------------------------------------------------------------------

    def check(self, snapshot: Snapshot) -> tuple[dict[str, int], bool, bool]:
        """Columns, scaled, wrapped; raises ScriptError for what does not fit."""
        if (snapshot.tilt is not None) != self.sim.box.triclinic:
            raise ScriptError("Read_dump triclinic status does not match simulation", manual=MANUAL)
        columns = self.columns(snapshot)
        return (columns, *self._kind(snapshot, columns))

    def apply(self, snapshot: Snapshot, say: Callable[[str], None] = lambda text: None) -> None:
        """Make the simulation's state that of the snapshot."""
        sim, request, atoms = self.sim, self.request, self.sim.atoms
        columns, scaled, wrapped = self.check(snapshot)
        names = list(columns)
        table = dict(zip(names, snapshot.table([columns[name] for name in names]).T, strict=True))
        places = self._places(snapshot, table, scaled)
        if request.box:
            self._box(snapshot)
        atoms.clear_ghosts()
        before = atoms.n
        purged = before if request.purge else 0
        if purged:
            atoms.keep(np.zeros(0, np.int64))
        for name in ("id", "type", "ix", "iy", "iz"):
            if name in table and (bad := np.flatnonzero(~(np.abs(table[name]) < 2.0**31))).size:
                snapshot.file.fail(f"Invalid {name} in dump file", snapshot.first + int(bad[0]), hint="a whole number")
        tags = table["id"].astype(np.int64)
        rows = self._rows(tags)
        known = rows >= 0
        replaced = trimmed = added = 0
        if request.replace:
            self._overwrite(rows[known], table, places, known, wrapped)
            replaced = int(known.sum())
        if request.trim:
            missing = ~np.isin(atoms.tag[: atoms.n], tags)
            trimmed = int(missing.sum())
            atoms.drop(missing)
        if request.add != "no":
            added = self._add(snapshot, table, places, ~known, wrapped)
        self._settle()
        say(f"  {describe(sim.box)}\n")
        for count, what in (
            (before, "atoms before read"), (snapshot.count, "atoms in snapshot"), (purged, "atoms purged"),
            (replaced, "atoms replaced"), (trimmed, "atoms trimmed"), (added, "atoms added"), (sim.natoms, "atoms after read"),
        ):  # fmt: skip
            say(f"  {count} {what}\n")

    def _rows(self, tags: Ints) -> Ints:
        by_tag = self.sim.atoms.rows_by_tag()
        near = (tags >= 0) & (tags < len(by_tag))
        return np.where(near, by_tag[np.where(near, tags, 0)], -1)

    def _places(self, snapshot: Snapshot, table: dict[str, Floats], scaled: bool) -> dict[str, Floats]:
        """Coordinates as distances in the snapshot's own box."""
        places = {axis: table[axis] for axis in PLACES if axis in table}
        if not scaled:
            return places
        length = snapshot.hi - snapshot.lo
        if snapshot.tilt is None:
            return {axis: s * length["xyz".index(axis)] + snapshot.lo["xyz".index(axis)] for axis, s in places.items()}
        (xy, xz, yz), (x, y, z) = snapshot.tilt, (places[axis] for axis in PLACES)
        lo = snapshot.lo
        return {
            "x": length[0] * x + xy * y + xz * z + lo[0], "y": length[1] * y + yz * z + lo[1], "z": length[2] * z + lo[2],
        }  # fmt: skip

    def _box(self, snapshot: Snapshot) -> None:
        sim = self.sim
        if (bad := np.flatnonzero(~(snapshot.lo < snapshot.hi))).size:
            snapshot.file.fail("Box bounds are invalid or missing", snapshot.first - 4 + int(bad[0]))
        sim.box.place(snapshot.lo, snapshot.hi, snapshot.tilt)
        sim.box.set_initial(sim.console)

    def _overwrite(
        self, rows: Ints, table: dict[str, Floats], places: dict[str, Floats], which: NDArray[np.bool_], wrapped: bool
    ) -> None:  # fmt: skip
        """Give rows what the snapshot says; where image flags are not said, unwrapped coordinates begin in the box itself."""
        atoms = self.sim.atoms
        for axis, values in places.items():
            atoms.x[rows, PLACES.index(axis)] = values[which]
        for name, array in (("v", atoms.v), ("f", atoms.f)):
            for d, axis in enumerate(PLACES):
                if f"{name}{axis}" in table:
                    array[rows, d] = table[f"{name}{axis}"][which]
        if "q" in table:
            atoms.q[rows] = table["q"][which]
        if not wrapped:
            atoms.image[rows] = 0
        for d, axis in enumerate(PLACES):
            if f"i{axis}" in table:
                atoms.image[rows, d] = table[f"i{axis}"][which].astype(np.int64)

    def _add(
        self, snapshot: Snapshot, table: dict[str, Floats], places: dict[str, Floats], new: NDArray[np.bool_], wrapped: bool
    ) -> int:  # fmt: skip
        """Atoms of the snapshot that are not there yet."""
        sim, atoms = self.sim, self.sim.atoms
        tags, kinds = table["id"].astype(np.int64), table["type"][new].astype(np.int64)
        if (bad := np.flatnonzero((kinds < 1) | (kinds > sim.atom_types))).size:
            row = snapshot.first + int(np.flatnonzero(new)[bad[0]])
            snapshot.file.fail("Invalid atom type in dump file", row, hint=f"types are 1 to {sim.atom_types}")
        rows = np.array(atoms.append(np.zeros((int(new.sum()), 3)), kinds), np.int64)
        self._overwrite(rows, table, places, new, wrapped)
        if self.request.add == "keep":
            atoms.tag[rows] = tags[new]
        else:
            atoms.number()
        return len(rows)

    def _settle(self) -> None:
        """Atoms into the box; faces that follow them; atoms outside are lost."""
        sim, atoms = self.sim, self.sim.atoms
        sim.box.remap(atoms.x[: atoms.n], atoms.image[: atoms.n])
        sim.box.enter(atoms.x[: atoms.n])
        sim.box.shrink(atoms, sim.natoms)
        sim.box.leave(atoms.x[: atoms.n])
        sim.natoms = atoms.n


def find(reader: Reader, step: int) -> Snapshot | None:
    """The snapshot of a step."""
    return next((snapshot for snapshot in reader.snapshots() if snapshot.step == step), None)



