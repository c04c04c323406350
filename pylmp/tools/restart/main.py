"""The commands ``pylmp restart info FILE`` and ``pylmp restart to-data FILE [DATA]``.

Exit codes: 0 done, 1 the file is no good, 2 wrong usage, 5 LAMMPS has what it holds and pylmp does not.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from pylmp.io.data_write import Contents, data_text
from pylmp.io.restart.content import Content
from pylmp.io.restart.files import latest, read_restart
from pylmp.io.restart.restore import restore
from pylmp.io.whole_file import write_whole
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError, Unsupported, render
from pylmp.tools.restart.report import lines, summary

OK, WRONG, USAGE, UNSUPPORTED = 0, 1, 2, 5


def main(arguments: list[str]) -> int:
    """Entry point; returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="pylmp restart", allow_abbrev=False, description="Look into a restart file of LAMMPS or pylmp, or make a data file of it."
    )  # fmt: skip
    verbs = parser.add_subparsers(dest="verb", required=True, metavar="info|to-data")
    info = verbs.add_parser("info", help="say what is in a restart file")
    info.add_argument("file", help="* finds the largest step, %% stands for a set of files")
    info.add_argument("--json", action="store_true", help="one JSON object instead of text")
    data = verbs.add_parser("to-data", help="write its atoms, bonds and coefficients as a data file")
    data.add_argument("file", help="* finds the largest step, %% stands for a set of files")
    data.add_argument("data", nargs="?", help="the data file; standard output if left out")
    data.add_argument("--nocoeff", action="store_true", help="leave the coefficients out")
    try:
        options = parser.parse_args(arguments)
    except SystemExit as leave:
        return int(leave.code or 0)
    try:
        name = latest(options.file) if "*" in options.file else options.file
        content = read_restart(name)
        if options.verb == "info":
            print(json.dumps(summary(name, content), indent=1) if options.json else "\n".join(lines(name, content)))
        else:
            _to_data(content, options)
    except ScriptError as error:
        print(render(error.diagnostic), file=sys.stderr)
        return UNSUPPORTED if isinstance(error, Unsupported) else WRONG
    return OK


def _to_data(content: Content, options: argparse.Namespace) -> None:
    sim = Simulation(Console())
    restore(sim, content)
    text = data_text(sim, Contents(coeffs=not options.nocoeff and _complete(sim)))
    if options.data is None:
        sys.stdout.write(text)
        return
    try:
        write_whole(Path(options.data), text)
    except OSError as error:
        raise ScriptError(f"Cannot open data file {options.data}: {error.strerror}") from None


def _complete(sim: Simulation) -> bool:
    """Every atom type has pair coefficients of its own: else the file can hold none."""
    pair = sim.pair
    return pair is None or all((kind, kind) in pair.acting for kind in range(1, sim.atom_types + 1))
