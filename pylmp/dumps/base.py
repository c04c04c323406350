"""What a dump is: a file that receives a frame on certain steps of a run."""

from __future__ import annotations

from typing import Any, ClassVar, NoReturn

import numpy as np

from pylmp.dumps.file import DumpFile
from pylmp.dumps.frame import Field, order, text, user_formats
from pylmp.dumps.settings import ELSEWHERE, SETTINGS, read_format
from pylmp.model.atoms import Ints
from pylmp.model.paths import writable
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError, Unsupported
from pylmp.text.printf import Format
from pylmp.text.words import Args, Word


class Dump:
    """Base of the dump styles. A style fills fields and says which rows and how many there are.

    every, first, delay   when frames are written: multiples of every from delay on; first: also when a run begins
    sort    "" as stored, "id", or a column number from 1, negative for descending
    formats headers       the user's, by column from 0; for_whole, for_real, for_line: for all columns
    due     the step of the next frame
    pbc     periodic coordinates are wrapped for the frame
    """

    style: ClassVar[str] = ""
    ending: ClassVar[str] = "\n"

    def __init__(
        self, sim: Simulation, identity: str, group: str, bit: int, every: int, path: Word, args: Args
    ) -> None:  # fmt: skip
        self.id, self.group, self.bit, self.every = identity, group, bit, every
        writable(sim, path)
        self.file = DumpFile(args, path)
        self.fields: list[Field] = []
        self.first = self.pbc = self.units = self.time = False
        self.header = True
        self.delay = 0
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

    @property
    def measures(self) -> bool:
        """It evaluates computes or variables."""
        return False

    @property
    def label(self) -> str:
        """What the header calls the rows."""
        return "ATOMS"

    # ---- when -----------------------------------------------------------------------------------------------

    @property
    def written_once(self) -> bool:
        return self._last >= 0

    def init(self, sim: Simulation) -> None:
        """Check, and open the file: once."""
        if isinstance(self.sort, int) and abs(self.sort) > len(self.fields):
            raise ScriptError(f"Dump sort column index {abs(self.sort)} is invalid", hint=f"1 to {len(self.fields)}")
        if self.for_line and len(self.for_line) < len(self.fields):
            line = " ".join(f.text for f in self.for_line)
            raise ScriptError(f"Dump_modify format line is too short: {line}", hint=f"{len(self.fields)} columns")
        self.check(sim)
        self.file.open()

    def setup(self, sim: Simulation) -> None:
        """A run begins: write the current step if it is due and was not written."""
        step = sim.step
        due = step % self.every == 0 and self._last != step
        if (due or (self.first and self._last < 0)) and step >= self.delay:
            self.write_due(sim)
            return
        self.due = self.next_step(step)
        if self.measures:
            sim.asking.everyone(self.due)

    def next_step(self, step: int) -> int:
        """The first step after step that is due."""
        step = max(step + 1, self.delay)
        return -(-step // self.every) * self.every

    # ---- a frame --------------------------------------------------------------------------------------------

    def write_due(self, sim: Simulation) -> None:
        """Write the frame of the current step in a block of its own, unless it was written; schedule the next one."""
        if self._last == sim.step:
            return
        if self.measures:
            sim.asking.block()
        self.write(sim)
        self.due = self.next_step(sim.step)
        if self.measures:
            sim.asking.again(self.due)

    def write(self, sim: Simulation) -> None:
        """Write the frame of the current step."""
        atoms = sim.atoms
        moving = atoms.x[: atoms.n], atoms.v[: atoms.n], atoms.image[: atoms.n]
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
        self._last = sim.step

    def close(self) -> None:
        self.file.close()

    def _frame(self, sim: Simulation) -> str:
        known: dict[Any, Any] = {}
        rows = self.rows(sim, known)
        columns = [np.asarray(field.values(sim, rows, known)) for field in self.fields]
        if self.sort == "id":
            chosen = order(sim.atoms.tag[rows], False)
        elif isinstance(self.sort, int):
            chosen = order(columns[abs(self.sort) - 1], self.sort < 0)
        else:
            chosen = None
        if chosen is not None:
            columns = [column[chosen] for column in columns]
        body = text(columns, user_formats(self), self.ending)
        return (self._head(sim, len(rows)) if self.header else "") + body

    def _head(self, sim: Simulation, count: int) -> str:
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

    # ---- dump_modify ----------------------------------------------------------------------------------------

    def modify(self, sim: Simulation, args: Args) -> None:
        """The keywords of dump_modify."""
        while len(args):
            key = args.word()
            if key.text == "write_header":
                self._write_header(sim, args, key)
            elif key.text in ELSEWHERE:
                raise Unsupported(f"LAMMPS has dump_modify {key.text}, pylmp's native engines do not", key.span)
            elif key.text in SETTINGS:
                if not len(args):
                    args.fail(f"Illegal dump_modify {key.text} command: missing argument(s)", key)
                SETTINGS[key.text](self, args)
            elif not self.setting(sim, args, key):
                self._unknown(args, key)

    def _unknown(self, args: Args, key: Word) -> NoReturn:
        args.fail(f"Unknown dump_modify keyword: {key.text}", key, hint=" ".join(SETTINGS))

    def _write_header(self, sim: Simulation, args: Args, key: Word) -> None:
        """The manual's name for header."""
        if sim.strict or not len(args):
            args.fail("Unknown dump_modify keyword: write_header", key, hint="header yes or header no", code="D002")
        sim.console.warning("[D002] the manual's dump_modify write_header is called header in LAMMPS 22 Jul 2025")
        self.header = args.yes()

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

    def format_kind(self, args: Args, what: Word) -> None:
        """Refuse ``format WORD`` where a style has none."""

    def format_words(self, args: Args) -> None:
        """The words after ``format``."""
        what = args.word()
        if what.text == "none":
            self.formats, self.for_line = {}, []
            self.for_whole = self.for_real = None
            return
        if not len(args):
            args.fail("Illegal dump_modify format command: missing argument(s)", what)
        value = args.word()
        if what.text != "line":
            self.format_kind(args, what)
        if what.text == "line":
            self.for_line = [read_format(args, value, part) for part in value.text.split()]
        elif what.text == "int":
            if "d" not in value.text:
                args.fail("Dump_modify int format does not contain d character", value, hint='for example "%8d"')
            self.for_whole = read_format(args, value, value.text)
        elif what.text == "float":
            self.for_real = read_format(args, value, value.text)
        else:
            self.formats[self.format_column(args, what)] = read_format(args, value, value.text)
