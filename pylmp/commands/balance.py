"""balance THRESHOLD x|y|z uniform|..., shift DIMENSIONS N STOP, rcb [weight ...] [out FILE] [sort yes|no] [old]

Source: LAMMPS manual, balance.html.
"""

from __future__ import annotations

import re

from pylmp.io.ready import initialise, wrap_atoms
from pylmp.model.paths import writable
from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import Unsupported
from pylmp.text.words import Args, Word

_STYLES = ("x", "y", "z", "shift", "rcb")
_LAYOUTS = {"xyz": "uniform", "shift": "nonuniform", "rcb": "tiled"}  # of the boxes of processes, afterwards


@command("balance", needs_box=True)
def balance(sim: Simulation, args: Args) -> None:
    """One process has all the work and keeps it. Atoms are wrapped into the box, as in LAMMPS, which says what it tried."""
    sim.console.both("Balancing ...\n")
    if len(args) < 2:
        args.missing()
    threshold, first = args.number(), args.words[1]
    style = _style(args)
    if style == "rcb" and sim.communication == "brick":
        args.fail("Balance rcb cannot be used with comm_style brick", first, hint="comm_style tiled")
    weighted, out = _keywords(sim, args)
    again = threshold <= 1.0  # the imbalance of one process is 1
    if again and (weighted or out):
        what = "weights" if weighted else "files"
        raise Unsupported(f"LAMMPS balances one process with {what} and a threshold of 1, pylmp's native engines do not", first.span)
    if out is not None:
        writable(sim, out).write_text("")
    initialise(sim)
    wrap_atoms(sim)
    if again:
        load = sim.atoms.n
        if load != sim.natoms:
            args.fail(f"Lost atoms via balance: original {sim.natoms}  current {load}", args.owner)
        sim.console.both(
            f" rebalancing time: 0.000 seconds\n  iteration count = {int(style == 'shift')}\n"
            f"  initial/final maximal load/proc = {load} {load}\n  initial/final imbalance factor  = 1 1\n"
        )
        x = sim.atoms.x[: sim.atoms.n]
        for _ in range((style == "shift") + sim.box.triclinic * (1 + (style == "rcb"))):
            x[:] = sim.box.positions(sim.box.fractions(x))  # LAMMPS measures in fractions of the box
        if style != "rcb":
            sim.console.both("  x cuts: 0 1\n  y cuts: 0 1\n  z cuts: 0 1\n")
        sim.layout = _LAYOUTS[style]
    sim.console.note("balance changes nothing: pylmp runs in one process")


def _style(args: Args) -> str:
    """The style, its words taken; x, y and z may follow one another."""
    style = ""
    while (word := args.peek()) is not None and word.text in _STYLES:
        if style and not (style == "xyz" and word.text in ("x", "y", "z")):
            args.fail("Must not combine multiple balancing styles", word)
        args.word()
        style = "xyz" if word.text in ("x", "y", "z") else word.text
        if style == "xyz":
            args.need(1, word.text)
            args.take("uniform")  # else the cuts between processes, of which there are none
        elif style == "shift":
            _shift(args)
    if not style:
        _unknown(args, args.word())
    return style


def _shift(args: Args) -> None:
    args.need(3, "shift")
    string = args.word()
    if len(string.text) > 3:
        args.fail("Illegal balance shift command", string)
    count, stop = args.integer(), args.number()
    if count <= 0:
        args.fail(f"Illegal balance shift value {count}", args.words[args.at - 2])
    if stop < 1.0:
        args.fail(f"Illegal balance stop threshold value {stop:.15g}")
    if not re.fullmatch("[xyz]+", string.text) or len(set(string.text)) < len(string.text):
        args.fail(f"Balance shift string {string.text} is invalid", string, hint="x, y, z in any order")


def _keywords(sim: Simulation, args: Args) -> tuple[bool, Word | None]:
    """Whether there are weights, and the file of out."""
    weighted, out = False, None
    while len(args):
        key = args.word()
        if key.text == "weight":
            _weight(sim, args, key)
            weighted = True
        elif key.text == "out":
            _follows(args, "out")
            out = args.word()
        elif key.text == "sort":
            _follows(args, "sort")
            args.yes()
        elif key.text != "old":
            _unknown(args, key)
    return weighted, out


def _weight(sim: Simulation, args: Args, key: Word) -> None:
    if not len(args):
        args.fail("Illegal (fix) balance weight command: missing argument(s)", key)
    method = args.word()
    if method.text == "group":
        args.need(1, "weight")
        count = args.integer()
        if count < 1:
            args.fail("Illegal balance weight command", hint="how many groups, and each with its factor")
        for _ in range(count):
            args.need(2, "weight group")
            name = args.word()
            if sim.groups.bit(name.text) == 0:
                args.fail(f"Unknown group in balance weight command: {name.text}", name)
            args.number()
    elif method.text == "var":
        args.need(1, "weight")
        name = args.word()
        variable = sim.script.variables.known.get(name.text)
        if variable is None:
            args.fail("Variable name for balance weight does not exist", name)
        if variable.style not in ("atom", "atomfile"):
            args.fail("Variable for balance weight has invalid style", name, hint="an atom-style variable")
    elif method.text == "time":
        args.need(1, "weight")
        args.number()
    elif method.text in ("neigh", "store"):
        raise Unsupported(f"LAMMPS has balance weight {method.text}, pylmp's native engines do not", method.span)
    else:
        args.fail(f"Unknown (fix) balance weight method: {method.text}", method, hint="group var time neigh store")


def _follows(args: Args, key: str) -> None:
    if not len(args):
        args.fail(f"Illegal (fix) balance {key} command: missing argument(s)")


def _unknown(args: Args, word: Word) -> None:
    args.fail(f"Unknown (fix) balance keyword {word.text}", word, hint=" ".join((*_STYLES, "weight", "out", "sort", "old")))
