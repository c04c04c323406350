"""The commands ``pylmp bench in.script``, with ``--dt`` or ``--skin`` a sweep, ``pylmp bench --all`` and ``pylmp bench --scaling``.

Exit codes: 0 measured, 1 a run failed or LAMMPS is missing, 2 wrong usage, 5 pylmp lacks what the script needs.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pylmp
from pylmp.text.diagnostic import ScriptError, render
from pylmp.tools.bench import page, scaling, table, tradeoff
from pylmp.tools.bench.contenders import NAMES, Contender, contender
from pylmp.tools.bench.measure import Result, measure
from pylmp.tools.bench.report import Machine, as_dict, sentence
from pylmp.tools.bench.sweep import sweep

WRONG, USAGE = 1, 2
ONE, EVERY = "fast,lammps", "fast,fast2,lammps,mpi2"  # who runs a script, and who runs all of them
DECKS = Path(pylmp.__file__).parents[1] / "inputs" / "bench"


def main(arguments: list[str]) -> int:
    """Entry point; returns the exit code."""
    parser = _parser()
    try:
        options = parser.parse_args(arguments)
        if options.all + options.scaling + (options.script is not None) != 1:
            parser.error("give one of: a script, --all, --scaling")
        names = _names(options.engines or (EVERY if options.all else ONE), parser)
        if any(len(words) < 2 for words in options.var):
            parser.error("--var takes a name and at least one value")
        if options.repeat is not None and options.repeat < 1:
            parser.error("--repeat takes a number from 1 on")
        sweeping = bool(options.dt or options.skin)
        if sweeping and (options.script is None or options.write):
            parser.error("--dt and --skin take a script, and --save in place of --write")
        if not sweeping and (options.save or options.within is not None):
            parser.error("--save and --within go with --dt or --skin")
        if options.save and options.save.suffix not in (".html", ".svg", ".png"):
            parser.error("--save FILE: .html, .svg or .png")
    except SystemExit as leave:
        return int(leave.code or 0)
    try:
        if options.write or options.save:
            page.needs_matplotlib()
        if options.cold:
            with tempfile.TemporaryDirectory(prefix="pylmp-store-") as store:
                return _bench(options, [contender(name, store) for name in names])
        return _bench(options, [contender(name) for name in names])
    except ScriptError as error:
        print(render(error.diagnostic), file=sys.stderr)
        return WRONG


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="pylmp bench", allow_abbrev=False,
        description="Run a script on several engines in turn and say what each step costs: the last run command of the script, "
        "medians over the rounds. Ratios are to LAMMPS on one process.",
        epilog="Engines: exact, fast and fast2 (two threads) are pylmp's; lammps is its serial program, opt, omp1, omp2 and mpi2 are it with -sf opt, "
        "-sf omp -pk omp 1 or 2, and mpiexec -n 2.",
    )  # fmt: skip
    add = parser.add_argument
    add("script", nargs="?", type=Path, help="input script; put it first")
    add("--all", action="store_true", help="every script of inputs/bench")
    add("--scaling", action="store_true", help="a liquid of 4 000 to 256 000 atoms: cost of a step, memory")
    add("--largest", action="store_true", help="with --scaling: 1 000 000 atoms too")
    add("--decks", type=Path, default=DECKS, metavar="FOLDER", help="where --all and --scaling find their scripts (default: inputs/bench)")
    add("--engines", metavar="A,B,...", help=f"of {', '.join(NAMES)} (default: {ONE}; {EVERY} with --all)")
    add("--repeat", type=int, metavar="N", help="rounds (default: 5; 3 with --scaling)")
    add("--var", "-var", "-v", nargs="+", action="append", default=[], metavar="WORD", help="NAME VALUE...: an index variable")
    add("--cold", action="store_true", help="start with an empty store of kernels: the first run compiles all of them")
    add("--timeout", type=float, metavar="SECONDS", help="for each run")
    add("--dt", type=_positive, metavar="A,B,...", help="sweep: make the last run with A, B, ... times its timestep, energy error against time")
    add("--skin", type=_positive, metavar="A,B,...", help="sweep: make the last run with neighbor skins A, B, ...")
    add("--within", type=float, metavar="E", help="sweep: standard deviation of energy per atom to compare at (default: that of the script's timestep)")
    add("--save", type=Path, metavar="FILE", help="sweep: a page (.html) or a picture (.svg, .png)")
    add("--json", action="store_true", help="one JSON object instead of text")
    add("--write", type=Path, metavar="FILE", help="put the table and a plot into this page of Markdown")
    return parser


def _names(given: str, parser: argparse.ArgumentParser) -> list[str]:
    names = list(dict.fromkeys(name.strip() for name in given.split(",") if name.strip()))
    unknown = [name for name in names if name not in NAMES]
    if unknown or not names:
        parser.error(f"--engines: {', '.join(unknown) or 'none given'}; there are {', '.join(NAMES)}")
    return names


def _bench(options: argparse.Namespace, contenders: list[Contender]) -> int:
    switches = [word for words in options.var for word in ("-var", *words)]
    machine, tell = Machine(), _progress()
    if options.dt or options.skin:
        return _sweep(options, contenders, switches)
    if options.scaling:
        _there(options.decks / scaling.LIQUID)
        results = scaling.scale(
            options.decks, contenders, options.repeat or 3, switches, options.timeout, options.largest, tell
        )  # fmt: skip
        state = machine.as_dict()
        said, whole = scaling.text(results), scaling.report(results, state)
        written = scaling.text(results, bars=True)
    else:
        results = [
            measure(_there(script), contenders, options.repeat or 5, switches, options.timeout, tell) for script in _scripts(options)
        ]
        state = machine.as_dict()
        said, whole = table.text(results), as_dict(results, state)
        written = table.markdown(results)
    tell("")
    print(json.dumps(whole, indent=1) if options.json else f"{said}\n\n{sentence(state)}")
    if options.write:
        _write(options, results, f"Measured {sentence(state)}.\n\n{written}")
    return next((result.code for result in results if result.code), 0)


def _sweep(options: argparse.Namespace, contenders: list[Contender], switches: list[str]) -> int:
    machine, tell = Machine(), _progress()
    found = sweep(
        _there(options.script), contenders, options.dt or [1.0], options.skin or [None], switches, options.timeout, options.repeat or 1, tell,
    )  # fmt: skip
    state, error = machine.as_dict(), tradeoff.target(found, options.within)
    said = f"{tradeoff.text(found, error)}\n\n{sentence(state)}"
    tell("")
    print(json.dumps(tradeoff.as_dict(found, error, state), indent=1) if options.json else said)
    if options.save and found.curves():
        tradeoff.save(options.save, found, error, said)
    return 0 if any(point.good for point in found.points) else WRONG


def _positive(words: str) -> list[float]:
    values = [float(word) for word in words.split(",")]
    if not values or not all(0.0 < value < float("inf") for value in values):
        raise ValueError(words)
    return values


def _scripts(options: argparse.Namespace) -> list[Path]:
    if not options.all:
        return [options.script]
    found = sorted(options.decks.glob("in.*"), key=lambda path: path.name.replace("_", " "))
    if not found:
        raise ScriptError(f"There are no scripts in {options.decks}", hint="they come with the sources of pylmp; --decks FOLDER names others")
    return found


def _there(script: Path) -> Path:
    if not script.is_file():
        raise ScriptError(f"Cannot open input script {script}: No such file or directory")
    return script


def _write(options: argparse.Namespace, results: list[Result], said: str) -> None:
    command = "scaling" if options.scaling else "bench"
    plot = page.write(options.write, command, said, results)
    print(f"Written: {options.write}, {plot}", file=sys.stderr)


def _progress() -> Callable[[str], None]:
    """Says who runs now, on one line of a terminal; elsewhere nothing."""
    if not sys.stderr.isatty():
        return lambda text: None

    def tell(text: str) -> None:
        print(f"\r\x1b[K{text}", end="", file=sys.stderr, flush=True)

    return tell
