"""The command ``pylmp diff in.script``: run on pylmp and on LAMMPS, compare, report. Exit 0 identical, 4 not."""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from pylmp.engines import lammps
from pylmp.text.diagnostic import ScriptError
from pylmp.tools.diff.compare import Comparison, runs
from pylmp.tools.diff.dialect import Dialect, translate
from pylmp.tools.diff.instrument import instrument
from pylmp.tools.permits import add_switches, granted

SCHEMA = 1
IDENTICAL, DIFFERENT, FAILED = 0, 4, 1


def main(arguments: list[str]) -> int:
    """Entry point; returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="pylmp diff", allow_abbrev=False,
        description="Run a script on pylmp and on LAMMPS and compare every number.",
    )  # fmt: skip
    parser.add_argument("script", type=Path)
    parser.add_argument("-var", "-v", nargs="+", action="append", default=[], metavar="NAME", help="NAME VALUE...")
    add_switches(parser)  # what pylmp permits the script; LAMMPS permits everything
    parser.add_argument("--engine", default="exact", help="pylmp's engine (default: exact)")
    parser.add_argument("--json", action="store_true", help="one JSON object instead of text")
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="keep both runs' files there")
    parser.add_argument("--timeout", type=float, default=None, metavar="SECONDS", help="for each of the two runs")
    options = parser.parse_args(arguments)
    if not options.script.is_file():
        print(f"ERROR: Cannot open input script {options.script}: No such file or directory", file=sys.stderr)
        return FAILED
    switches = [w for names in options.var for w in ("-var", *names)]
    try:
        if options.keep:
            return _diff(options, switches, options.keep)
        with tempfile.TemporaryDirectory(prefix="pylmp-diff-") as folder:
            return _diff(options, switches, Path(folder))
    except ScriptError as error:
        print(f"ERROR: {error.diagnostic.message}\n  hint: {error.diagnostic.hint}", file=sys.stderr)
        return FAILED
    except subprocess.TimeoutExpired as error:
        print(f"ERROR: no end after {error.timeout:g} s; --timeout gives it longer", file=sys.stderr)
        return FAILED


def _diff(options: argparse.Namespace, switches: list[str], folder: Path) -> int:
    script: Path = options.script
    lines = script.read_text().splitlines()
    dialect = translate(lines)
    native, reference = folder / "pylmp", folder / "lammps"
    inputs = {p.name for p in script.parent.iterdir() if p.is_file()}
    for place, text in ((native, lines), (reference, dialect.rewritten)):
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        for name in inputs:
            shutil.copy2(script.parent / name, place / name)
        (place / "in.diff").write_text("\n".join(instrument(text)) + "\n")
    permits = ["--allow", ",".join(granted(options))]
    mine = _native(native, [*switches, *permits, "--engine", options.engine], options.timeout)
    theirs = lammps.run("in.diff", reference, ["-nocite", *switches], timeout=options.timeout)
    for name, done in (("pylmp", mine), ("LAMMPS", theirs)):
        if done.returncode:
            return _failed(name, done, options.json)
    comparison = runs(native, reference, inputs)
    print(_as_json(script, dialect, comparison) if options.json else _as_text(script, dialect, comparison))
    return IDENTICAL if comparison.identical else DIFFERENT


def _native(folder: Path, switches: list[str], timeout: float | None) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "pylmp", "in.diff", "-nocite", *switches]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=timeout, check=False)


def _failed(name: str, done: subprocess.CompletedProcess[str], as_json: bool) -> int:
    text = (done.stdout + done.stderr).strip()
    at = text.find("ERROR")
    said = text[at if at >= 0 else -500 :][:1000]
    if as_json:
        print(json.dumps({"schema": SCHEMA, "verdict": "failed", "program": name, "said": said}))
    else:
        print(f"{name} stopped with exit code {done.returncode}:\n{said}", file=sys.stderr)
    return FAILED


def _as_json(script: Path, dialect: Dialect, comparison: Comparison) -> str:
    verdict = "identical" if comparison.identical else "different"
    report = {"schema": SCHEMA, "script": script.name, "verdict": verdict, "dialect": dialect.notes}
    return json.dumps(report | comparison.as_dict(), indent=1)


def _as_text(script: Path, dialect: Dialect, comparison: Comparison) -> str:
    lines = [f"{script.name}: {'identical' if comparison.identical else 'different'}"]
    for note in dialect.notes:
        lines.append(f"  for LAMMPS, {note}")
    if not dialect.exact:
        lines.append("  the rewritten bond law is the same function with other roundings: the last bits may differ")
    for part in comparison.parts:
        state = "identical" if part.first is None else f"{part.differing} differ"
        lines.append(f"  {part.name}: {part.cells} compared, {state}")
        if part.first is not None:
            apart = f" ({part.first.ulps} ulps)" if part.first.ulps is not None else ""
            lines.append(f"    first: {part.first.place}: pylmp {part.first.pylmp}, LAMMPS {part.first.lammps}{apart}")
    return "\n".join(lines)
