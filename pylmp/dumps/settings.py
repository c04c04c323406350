"""The keywords of dump_modify that every dump style has. Source: LAMMPS manual, dump_modify.html."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from pylmp.model.quantity import Quantity
from pylmp.text.printf import Format, pieces
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.dumps.base import Dump
    from pylmp.model.simulation import Simulation

_LONGEST_NAME = 255  # characters that file systems take


def read_format(args: Args, word: Word, part: str) -> Format:
    """One column's format. Raises ScriptError for what C would not print either."""
    try:
        return Format(part)
    except ValueError:
        args.fail(f"Invalid dump_modify format: {part}", word, hint='one value a format, for example "%12.6g"')


def _append(dump: Dump, args: Args) -> None:
    dump.file.append = args.yes()


def _every(dump: Dump, args: Args) -> None:
    word = args.word()
    dump.schedule.time = None
    if word.text.startswith("v_"):
        dump.schedule.every = Quantity(name=word.text[2:])
        return
    every = args.as_integer(word)
    if every <= 0:
        args.fail(f"Invalid dump_modify every argument: {word.text}", word, hint="a positive number of steps")
    dump.schedule.every = every


def _every_time(dump: Dump, args: Args) -> None:
    word = args.peek()
    time = Quantity.read(args)
    if not time.varies and time.value <= 0.0:
        args.fail(f"Invalid dump_modify every/time argument: {word}", word, hint="a positive time")
    dump.schedule.time = time


def _skip(dump: Dump, args: Args) -> None:
    word = args.word()
    if not word.text.startswith("v_"):
        args.fail("Illegal dump_modify command", word, hint="skip v_NAME")
    dump.schedule.skip = Quantity(name=word.text[2:])


def _sort(dump: Dump, args: Args) -> None:
    word = args.word()
    if word.text in ("off", "id"):
        dump.sort = "" if word.text == "off" else "id"
        return
    dump.sort = args.as_integer(word)
    if dump.sort == 0:
        args.fail("Invalid dump_modify sort argument: 0", word, hint="off, id, or a column from 1")


def _pad(dump: Dump, args: Args) -> None:
    word = args.word()
    if args.as_integer(word) < 0:
        args.fail(f"Invalid dump_modify pad argument: {word.text}", word, hint="a number of digits")
    dump.file.pad = args.as_integer(word)
    if dump.file.pad > _LONGEST_NAME:
        args.fail(f"Invalid dump_modify pad argument: {word.text}", word, hint=f"names of files have at most {_LONGEST_NAME} characters")


def _colname(dump: Dump, args: Args) -> None:
    word = args.word()
    if word.text == "default":
        dump.headers = {}
        return
    if not len(args):
        args.fail("Illegal dump_modify colname command: missing argument(s)", word)
    at, name = dump.column(word), args.word()
    if at is None:
        args.fail(f"Incorrect dump_modify arguments: colname {word} {name}", word, hint=f"1 to {len(dump.fields)}")
    dump.headers[at] = name.text


def _flag(name: str) -> Callable[[Dump, Args], None]:
    return lambda dump, args: setattr(dump, name, args.yes())


def _first(dump: Dump, args: Args) -> None:
    dump.schedule.first = args.yes()


def _nothing(dump: Dump, args: Args) -> None:
    args.yes()  # of one process, and of a file that each frame reaches at once, whatever is said here


def _general(dump: Dump, args: Args) -> None:
    word = args.peek()
    if args.yes():
        text = "Dump_modify triclinic/general cannot be used if simulation box is not general triclinic"
        args.fail(text, word, hint="triclinic/general no")


def _files(key: str) -> Callable[[Dump, Args], None]:
    """fileper and nfile: one process writes one file."""

    def read(dump: Dump, args: Args) -> None:
        if not dump.file.split:
            args.fail(f"Cannot use dump_modify {key} without % in dump file name", hint="a name with %")
        number = args.integer()
        if number <= 0:
            args.fail(f"Invalid dump_modify {key} argument: {number}", hint="a positive number")

    return read


def _maxfiles(dump: Dump, args: Args) -> None:
    if not dump.file.one_a_frame:
        args.fail("Cannot use dump_modify maxfiles without * in dump file name", hint="a name with *")
    word = args.word()
    number = args.as_integer(word)
    if number == 0:
        args.fail(f"Invalid dump_modify maxfiles argument: {word.text}", word, hint="how many files are kept, -1: all")
    dump.file.most = max(number, 0)


def _delay(dump: Dump, args: Args) -> None:
    dump.schedule.delay = max(args.integer(), 0)


def _format(dump: Dump, args: Args) -> None:
    what = args.word()
    if what.text == "none":
        dump.formats, dump.for_line = {}, []
        dump.for_whole = dump.for_real = None
        return
    if not len(args):
        args.fail("Illegal dump_modify format command: missing argument(s)", what)
    value = args.word()
    if what.text != "line":
        dump.format_kind(args, what)
    if what.text == "line":
        parts = pieces(value.text) if dump.verbatim else value.text.split()
        dump.for_line = [read_format(args, value, part) for part in parts]
    elif what.text == "int":
        if "d" not in value.text:
            args.fail("Dump_modify int format does not contain d character", value, hint='for example "%8d"')
        dump.for_whole = read_format(args, value, value.text)
    elif what.text == "float":
        dump.for_real = read_format(args, value, value.text)
    else:
        dump.formats[dump.format_column(args, what)] = read_format(args, value, value.text)


SETTINGS: dict[str, Callable[[Dump, Args], None]] = {
    "append": _append, "every": _every, "every/time": _every_time, "sort": _sort, "pad": _pad, "colname": _colname, "delay": _delay,
    "skip": _skip, "first": _first, "header": _flag("header"), "pbc": _flag("pbc"), "units": _flag("units"), "time": _flag("time"),
    "flush": _nothing, "buffer": _nothing, "balance": _nothing, "triclinic/general": _general, "fileper": _files("fileper"),
    "nfile": _files("nfile"), "maxfiles": _maxfiles, "format": _format,
}  # fmt: skip


def modify(dump: Dump, sim: Simulation, args: Args) -> None:
    """Carry out the keywords of dump_modify."""
    while len(args):
        key = args.word()
        if key.text == "write_header":
            _write_header(dump, sim, args, key)
        elif key.text in SETTINGS:
            if not len(args):
                args.fail(f"Illegal dump_modify {key.text} command: missing argument(s)", key)
            SETTINGS[key.text](dump, args)
        elif not dump.setting(sim, args, key):
            args.fail(f"Unknown dump_modify keyword: {key.text}", key, hint=" ".join(SETTINGS))


def _write_header(dump: Dump, sim: Simulation, args: Args, key: Word) -> None:
    """The manual's name for header."""
    if sim.strict or not len(args):
        args.fail("Unknown dump_modify keyword: write_header", key, hint="header yes or header no", code="D002")
    sim.console.warning("[D002] the manual's dump_modify write_header is called header in LAMMPS 22 Jul 2025")
    dump.header = args.yes()
