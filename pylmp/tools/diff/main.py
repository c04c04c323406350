"""The command ``pylmp diff``: one script on two programs, or two scripts; every number compared, and a verdict (docs/diff.md).

Exit codes: 0 identical or round-off, 4 drift or different, 1 a program failed or is missing, 2 wrong usage.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from pylmp.io.whole_file import write_whole
from pylmp.text.diagnostic import ScriptError
from pylmp.tools.diff import contest
from pylmp.tools.diff.report import SCHEMA, Report, as_dict
from pylmp.tools.diff.sides import Failed
from pylmp.tools.diff.text import as_text
from pylmp.tools.permits import add_switches

FAILED = 1


def main(arguments: list[str]) -> int:
    """Entry point; returns the exit code."""
    try:
        options = _parser().parse_args(arguments)
        if options.resync is not None and options.resync < 1:
            _parser().error("--resync takes a number of steps from 1 on")
    except SystemExit as leave:
        return int(leave.code or 0)
    for path in (options.script, options.other, options.ref):
        if path is not None and not path.is_file():
            what = "reference" if path is options.ref else "input script"
            print(f"ERROR: Cannot open {what} {path}: No such file or directory", file=sys.stderr)
            return FAILED
    try:
        if options.keep:
            return _deliver(options, contest.hold(options, options.keep))
        with tempfile.TemporaryDirectory(prefix="pylmp-diff-") as folder:
            return _deliver(options, contest.hold(options, Path(folder)))
    except Failed as error:
        return _failed(options, error)
    except ScriptError as error:
        print(f"ERROR: {error.diagnostic.message}\n  hint: {error.diagnostic.hint}", file=sys.stderr)
    except subprocess.TimeoutExpired as error:
        print(f"ERROR: no end after {error.timeout:g} s; --timeout gives it longer", file=sys.stderr)
    return FAILED


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="pylmp diff", allow_abbrev=False,
        description="Run a script on pylmp and on LAMMPS and compare every number; or two scripts on pylmp; or a script with a stored log or dump.",
        epilog="Exit codes: 0 identical or round-off, 4 drift or different, 1 a program failed. docs/diff.md says what each number means.",
    )  # fmt: skip
    add = parser.add_argument
    add("script", type=Path, help="put it first")
    add("other", type=Path, nargs="?", help="a second script, which is then the reference: both run on pylmp")
    add("-var", "-v", nargs="+", action="append", default=[], metavar="NAME", help="NAME VALUE...")
    add_switches(parser)  # what pylmp permits the script; LAMMPS permits everything
    add("--engine", default="exact", choices=("exact", "fast", "auto"), help="pylmp's engine (default: exact, whose verdict is identical, or there is a bug)")
    add("--noise", action="store_true", help="also LAMMPS against itself: on two processes, and without sorting of atoms")
    add("--ledger", action="store_true", help="list which bond broke when, also where both agree")
    add("--resync", type=int, metavar="N", help="also from the same state every N steps: the error of N steps along the run")
    add("--json", nargs="?", const=Path("-"), type=Path, metavar="FILE", help="one JSON object; instead of the text if no FILE is given")
    add("--html", type=Path, metavar="FILE", help="one page for a browser, with pictures, without scripts and without anything from the network")
    add("--keep", type=Path, metavar="FOLDER", help="keep all runs' files there")
    add("--timeout", type=float, default=None, metavar="SECONDS", help="for each run")
    parser.set_defaults(ref=None)
    return parser


def _deliver(options: argparse.Namespace, report: Report) -> int:
    said = json.dumps(as_dict(report), indent=1)
    alone = options.json == Path("-")
    print(said if alone else as_text(report))
    if options.json and not alone:
        write_whole(options.json, said + "\n")
    if options.html:
        from pylmp.tools.diff.page import whole

        write_whole(options.html, whole(report))
    return report.verdict.code


def _failed(options: argparse.Namespace, error: Failed) -> int:
    if options.json:
        said = json.dumps({"schema": SCHEMA, "verdict": "failed", "program": error.side, "said": error.said})
        if options.json == Path("-"):
            print(said)
            return FAILED
        write_whole(options.json, said + "\n")
    print(error.diagnostic.message, file=sys.stderr)
    return FAILED
