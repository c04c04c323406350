"""thermo_modify KEYWORD VALUE...: settings of the thermo table. Source: LAMMPS manual, thermo_modify.html."""

from __future__ import annotations

import re
from collections.abc import Callable

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.model.temperature import Temperature
from pylmp.text.printf import Format
from pylmp.text.words import Args, Word
from pylmp.thermo.layout import LAYOUTS
from pylmp.thermo.table import Thermo, settable

_LOST = ("ignore", "warn", "error")
_WARN = {"ignore": -1, "always": 0, "default": 100}


@command("thermo_modify")
def thermo_modify(sim: Simulation, args: Args) -> None:
    args.need(1)
    while len(args):
        key = args.word()
        setting = _SETTINGS.get(key.text)
        if setting is None:
            args.fail(f"Unknown thermo_modify keyword: {key.text}", key, hint=" ".join(_SETTINGS))
        if not len(args):
            name = key.text.replace("triclinic", "tricinic")  # LAMMPS's own spelling
            args.fail(f"Illegal thermo_modify {name} command: missing argument(s)", key)
        setting(sim, sim.output.thermo, args)
        sim.output.thermo.modified = True


def _temp(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.word()
    if not thermo.uses("t"):
        args.fail("Thermo style does not use temp", word, hint="a column that needs the temperature")
    if word.text not in sim.computes:
        args.fail(f"Could not find thermo_modify temperature compute {word.text}", word)
    compute = sim.computes[word.text]
    if not isinstance(compute, Temperature):
        args.fail(f"Thermo_modify compute {word.text} does not compute temperature", word)
    thermo.redirect(thermo.temp, word.text, ("scalar",))
    thermo.temp = word.text
    if compute.bit != 1:
        sim.console.warning("Temperature for thermo pressure is not for group all")
    pressure = sim.computes.get(thermo.press)
    if getattr(pressure, "temperature", None) is not None:
        pressure.temperature = word.text  # type: ignore[union-attr]


def _press(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.word()
    if not thermo.uses("ps"):
        args.fail("Thermo style does not use press", word, hint="a column that needs the pressure")
    if word.text not in sim.computes:
        args.fail(f"Could not find thermo_modify pressure compute {word.text}", word)
    if not settable(sim, word.text, "vector") or sim.computes[word.text].style != "pressure":
        args.fail(f"Thermo_modify compute {word.text} does not compute pressure", word)
    kinds = ("scalar",) * thermo.uses("p") + ("vector",) * thermo.uses("s")
    thermo.redirect(thermo.press, word.text, kinds)
    thermo.press = word.text


def _lost(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.word()
    if word.text not in _LOST:
        args.fail(f"Unknown thermo_modify lost argument: {word.text}", word, hint=" ".join(_LOST))
    thermo.lost = word.text


def _lost_bond(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.word()
    if word.text not in _LOST:
        args.fail(f"Unknown thermo_modify lost/bond argument: {word.text}", word, hint=" ".join(_LOST))
    sim.lost_bonds = word.text


def _warn(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.word()
    if word.text == "reset":
        sim.console.warnings = 0
        thermo.silent = False
    else:
        sim.console.limit = _WARN[word.text] if word.text in _WARN else args.as_integer(word)


def _norm(sim: Simulation, thermo: Thermo, args: Args) -> None:
    thermo.norm = args.yes()


def _flush(sim: Simulation, thermo: Thermo, args: Args) -> None:
    thermo.flush = args.yes()


def _line(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.word()
    if word.text not in LAYOUTS:
        args.fail(f"Unknown thermo_modify line argument: {word.text}", word, hint=" ".join(LAYOUTS))
    thermo.layout = LAYOUTS[word.text]


def _column(thermo: Thermo, word: Word) -> int | None:
    """Column from 0 that a number (from 1, or from -1 at the end) or a name stands for."""
    count = len(thermo.columns)
    if re.fullmatch(r"-?\d+", word.text):
        number = int(word.text)
        at = number + count if number < 0 else number - 1
        return at if 0 <= at < count else None
    names = [entry.name for entry in thermo.columns]
    return names.index(word.text) if word.text in names else None


def _colname(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.word()
    if word.text == "default":
        thermo.headers = {}
        return
    if not len(args):
        args.fail("Illegal thermo_modify colname command: missing argument(s)", word)
    at = _column(thermo, word)
    name = args.word()
    if at is None:
        args.fail(f"Invalid thermo_modify colname argument: {word.text}", word, hint=f"1 to {len(thermo.columns)}")
    thermo.headers[at] = name.text


def _format(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.word()
    if word.text == "none":
        thermo.formats, thermo.for_line = {}, []
        thermo.for_whole = thermo.for_real = None
        return
    if not len(args):
        args.fail("Illegal thermo_modify format command: missing argument(s)", word)
    if word.text == "line":
        line = args.word()
        thermo.for_line = [_read(args, line, text) for text in line.text.split()]
        return
    value = args.word()
    if word.text == "int":
        if "d" not in value.text or "%" not in value.text:
            args.fail(
                "Thermo_modify int format does not contain a d conversion character", value, hint='for example "%8d"'
            )
        thermo.for_whole = _read(args, value, value.text)
    elif word.text == "float":
        thermo.for_real = _read(args, value, value.text)
    elif "*" in word.text and word.text.replace("*", "").isdigit() or word.text == "*":
        for k in args.as_range(word, 1, len(thermo.columns)):
            thermo.formats[k - 1] = _read(args, value, value.text)
    else:
        at = _column(thermo, word)
        if at is None:
            hint = f"1 to {len(thermo.columns)}, int, float, line, none or a column's name"
            args.fail(f"Invalid thermo_modify format argument: {word.text}", word, hint=hint)
        thermo.formats[at] = _read(args, value, value.text)


def _read(args: Args, word: Word, text: str) -> Format:
    try:
        result = Format(text)
    except ValueError:
        result = None
    if result is None or result.words:
        args.fail(
            f"Invalid thermo_modify format argument: {text}", word, hint='one number a format, for example "%12.6g"'
        )
    return result


def _general(sim: Simulation, thermo: Thermo, args: Args) -> None:
    word = args.peek()
    if args.yes():
        text = "Thermo_modify triclinic/general cannot be used if simulation box is not general triclinic"
        args.fail(text, word, hint="triclinic/general no")


_SETTINGS: dict[str, Callable[[Simulation, Thermo, Args], None]] = {
    "norm": _norm, "flush": _flush, "format": _format, "lost": _lost, "lost/bond": _lost_bond, "line": _line,
    "warn": _warn, "colname": _colname, "temp": _temp, "press": _press, "triclinic/general": _general,
}  # fmt: skip
