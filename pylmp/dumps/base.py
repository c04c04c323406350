"""What a dump is: a file that receives a frame on certain steps of a run."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from pylmp.dumps.file import DumpFile
from pylmp.dumps.frame import Field, Layout, order, text, user_formats
from pylmp.dumps.schedule import Schedule
from pylmp.model.atoms import Ints
from pylmp.model.paths import writable
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.printf import Format
from pylmp.text.words import Args, Word


class Dump:
    """Base of the dump styles. A style fills fields and says which rows and how many there are.

    schedule  when frames are due
    due       the step of the next frame
    keys      what sort numbers mean, if not the fields
    sort      "" as stored, "id", or a column number from 1, negative for descending
    formats headers       the user's, by column from 0; for_whole, for_real, for_line: for all columns
    pbc       periodic coordinates are wrapped for the frame
    """

    style: ClassVar[str] = ""
    layout: ClassVar[Layout] = Layout("", " ", "\n")
    verbatim: ClassVar[bool] = False  # the line of dump_modify format is printed blank by blank

    def __init__(
        self, sim: Simulation, identity: str, group: str, bit: int, every: int, path: Word, args: Args
    ) -> None:  # fmt: skip
        self.id, self.group, self.bit = identity, group, bit
        self.schedule = Schedule(every)
        writable(sim, path)
        self.file = DumpFile(args, path)
        if sim.script.dry:
            self.file.vanish()
        self.fields: list[Field] = []
        self.keys: list[Field] = []
        self.pbc = self.units = self.time = False
        self.header = True
        self.sort: int | str = ""
        self.formats: dict[int, Format] = {}
        self.headers: dict[int, str] = {}
        self.for_whole: Format | None = None
        self.for_real: Format | None = None
        self.for_line: list[Format] = []
        self._last = self.due = -1
        self._units_written = False
        self.read(sim, args)

    # ---- what a style defines -------------------------------------------------------------------------------

    def read(self, sim: Simulation, args: Args) -> None:
        """Take the style's words and fill fields."""
        raise NotImplementedError

    def rows(self, sim: Simulation, known: dict[Any, Any]) -> Ints:
        """The rows of a frame: owned atoms by number, or entries."""
        raise NotImplementedError

    def check(self, sim: Simulation) -> None:
        """What must hold when a run begins. Raises ScriptError."""

    def setting(self, sim: Simulation, args: Args, key: Word) -> bool:
        """A dump_modify keyword of this style alone; False: not one."""
        return False

    def format_kind(self, args: Args, what: Word) -> None:
        """Refuse ``format WORD`` where a style has none."""

    def written(self, sim: Simulation) -> None:
        """A frame was written."""

    @property
    def measures(self) -> bool:
        """It evaluates computes or variables."""
        return self.schedule.varies

    @property
    def label(self) -> str:
        """What the header calls the rows."""
        return "ATOMS"

    @property
    def footer(self) -> str:
        """What ends a frame."""
        return ""

    # ---- when -----------------------------------------------------------------------------------------------

    @property
    def written_once(self) -> bool:
        return self._last >= 0

    def init(self, sim: Simulation) -> None:
        """Check, and open the file: once."""
        keys = self.keys or self.fields
        if isinstance(self.sort, int) and abs(self.sort) > len(keys):
            raise ScriptError(f"Dump sort column index {abs(self.sort)} is invalid", hint=f"1 to {len(keys)}")
        if self.for_line and len(self.for_line) < len(self.fields) and not self.verbatim:
            line = " ".join(f.text for f in self.for_line)
            raise ScriptError(f"Dump_modify format line is too short: {line}", hint=f"{len(self.fields)} columns")
        self.schedule.check(sim)
        self.check(sim)
        self.file.open()

    def setup(self, sim: Simulation) -> None:
        """A run begins: write the current step if it is due and was not written."""
        if self.measures:
            sim.asking.block()
        due = self.schedule.starts(sim, self._last)
        if due:
            self.write(sim)
        self.due = self.schedule.following(sim, self.id, started=True)
        if self.measures and due:
            sim.asking.again(self.due)
        elif self.measures:
            sim.asking.everyone(self.due)

    def jump(self, sim: Simulation) -> None:
        """The step number was set: a frame may be due now."""
        now = isinstance(self.schedule.every, int) and self.schedule.time is None and sim.step % self.schedule.every == 0
        self.due = sim.step if now else self.schedule.following(sim, self.id, started=True)

    def write_due(self, sim: Simulation) -> None:
        """Write the frame of the current step in a block of its own, unless it was written; schedule the next one."""
        if self._last == sim.step:
            return
        if self.measures:
            sim.asking.block()
        self.write(sim)
        self.due = self.schedule.following(sim, self.id, started=False)
        if self.measures:
            sim.asking.again(self.due)

    # ---- a frame --------------------------------------------------------------------------------------------

    def write(self, sim: Simulation) -> None:
        """Write the frame of the current step, unless the script wants it left out."""
        self._last = sim.step
        if self.schedule.skips(sim):
            return
        atoms = sim.atoms
        moving: tuple[NDArray[Any], ...] = atoms.x[: atoms.n], atoms.v[: atoms.n], atoms.image[: atoms.n]
        kept = [array.copy() for array in moving] if self.pbc else []
        if kept:
            sim.box.enter(moving[0])
            sim.box.wrap(atoms)
            sim.box.leave(moving[0])
        try:
            frame = self._frame(sim)
        finally:
            for array, before in zip(moving, kept, strict=False):
                array[:] = before
        self.file.write(sim.step, frame)
        self.written(sim)

    def close(self) -> None:
        self.file.close()

    def _frame(self, sim: Simulation) -> str:
        known: dict[Any, Any] = {}
        rows = self.rows(sim, known)
        columns = [np.asarray(field.values(sim, rows, known)) for field in self.fields]
        if self.sort == "id":
            chosen = order(sim.atoms.tag[rows], False)
        elif isinstance(self.sort, int):
            at = abs(self.sort) - 1
            keys = np.asarray(self.keys[at].values(sim, rows, known)) if self.keys else columns[at]
            chosen = order(keys, self.sort < 0)
        else:
            chosen = None
        if chosen is not None:
            columns = [column[chosen] for column in columns]
        layout = self.layout
        if self.verbatim and self.for_line:
            columns, layout = columns[: len(self.for_line)], replace(layout, between="")
        body = text(columns, self.cell_formats(), layout)
        return (self.head(sim, len(rows)) if self.header else "") + body + self.footer

    def cell_formats(self) -> list[Format]:
        """How each column is printed."""
        return user_formats(self)

    def head(self, sim: Simulation, count: int) -> str:
        """What stands above count rows."""
        lines = []
        if self.units and (self.file.one_a_frame or not self._units_written):
            lines += ["ITEM: UNITS", sim.units.name]
            self._units_written = True
        if self.time:
            lines += ["ITEM: TIME", f"{sim.output.time():.16g}"]
        box = sim.box
        lines += ["ITEM: TIMESTEP", str(sim.step), f"ITEM: NUMBER OF {self.label}", str(count)]
        lines.append(
            "ITEM: BOX BOUNDS " + "xy xz yz " * box.triclinic + " ".join(low + high for low, high in box.boundary)
        )
        table = np.stack([*box.bounds, box.tilt][: 2 + box.triclinic], axis=1)
        lines += [" ".join(f"{value:<1.16e}" for value in row) for row in table.tolist()]
        names = " ".join(self.headers.get(k, field.name) for k, field in enumerate(self.fields))
        return "\n".join([*lines, f"ITEM: {self.label} {names}"]) + "\n"

    # ---- columns --------------------------------------------------------------------------------------------

    def column(self, word: Word) -> int | None:
        """Column from 0 that a number (from 1, or from -1 at the end) or a name stands for."""
        names = [field.name for field in self.fields]
        if word.text in names:
            return names.index(word.text)
        if not word.text.removeprefix("-").isdigit():
            return None
        number, count = int(word.text), len(names)
        at = number + count if number < 0 else number - 1
        return at if 0 <= at < count else None

    def format_column(self, args: Args, word: Word) -> int:
        """The column that ``format WORD`` means."""
        at = self.column(word)
        if at is None:
            args.as_integer(word)
            args.fail(f"Unknown dump_modify format ID keyword: {word.text}", word, hint=f"1 to {len(self.fields)}")
        return at
