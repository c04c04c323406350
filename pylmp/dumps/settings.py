"""The keywords of dump_modify that every dump style has. Source: LAMMPS manual, dump_modify.html."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from pylmp.text.diagnostic import Unsupported
from pylmp.text.printf import Format
from pylmp.text.words import Args, Word

if TYPE_CHECKING:
    from pylmp.dumps.base import Dump


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
    if word.text.startswith("v_"):
        raise Unsupported(
            "LAMMPS has variable dump intervals, pylmp's native engines do not", word.span, hint="every N"
        )
    every = args.as_integer(word)
    if every <= 0:
        args.fail(f"Invalid dump_modify every argument: {word.text}", word, hint="a positive number of steps")
    dump.every = every


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


def _flush(dump: Dump, args: Args) -> None:
    args.yes()  # every frame reaches the file at once, whatever is said here


def _delay(dump: Dump, args: Args) -> None:
    dump.delay = max(args.integer(), 0)


SETTINGS: dict[str, Callable[[Dump, Args], None]] = {
    "append": _append, "every": _every, "sort": _sort, "pad": _pad, "colname": _colname, "delay": _delay,
    "first": _flag("first"), "header": _flag("header"), "pbc": _flag("pbc"), "units": _flag("units"), "time": _flag("time"),
    "flush": _flush, "format": lambda dump, args: dump.format_words(args),
}  # fmt: skip
# keywords of every dump style in LAMMPS
ELSEWHERE = ("at", "balance", "buffer", "every/time", "fileper", "maxfiles", "nfile", "triclinic/general")
