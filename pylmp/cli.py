"""The door: `pylmp in.script` as `lmp -in in.script`, and `pylmp diff`, `pylmp check`.

Exit codes: 0 done, the script's own with quit, 1 the script or the run is wrong, 2 wrong usage, 3 check found errors, 4 diff found a difference,
5 LAMMPS has it and pylmp does not, 130 interrupted, 143 terminated.
"""

from __future__ import annotations

import argparse
import os
import signal
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from pathlib import Path

from pylmp import __version__
from pylmp.model.limits import JUMPS
from pylmp.session import SIGNALLED, WRONG, Session
from pylmp.tools.permits import add_switches

USAGE = 2
MOST_THREADS = 64
TOOLS = ("bench", "check", "diff", "doctor", "explain", "restart")  # of pylmp.tools
ENGINES = ("auto", "exact", "fast", "lammps")


def main(arguments: Sequence[str] | None = None) -> int:
    """Entry point; returns the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    if words and words[0] in TOOLS:
        return _tool(words[0], words[1:])
    if words[:1] == ["run"]:
        words = words[1:]
    try:
        options = _parser().parse_args(words)
    except SystemExit as leave:
        return int(leave.code or 0)
    if options.restart2info:
        return _tool("restart", ["info", options.restart2info[0]])
    if options.restart2data:
        flags = [f"--{word}" if word == "nocoeff" else word for word in options.restart2data[2:]]
        return _tool("restart", ["to-data", *options.restart2data[:2], *flags])
    _script_after_var(options)
    if options.script is None and options.input is None and sys.stdin.isatty():
        _parser().print_help()
        return USAGE
    if options.threads is not None and not 1 <= options.threads <= MOST_THREADS:
        print(f"pylmp: error: --threads takes a number from 1 to {MOST_THREADS}", file=sys.stderr)
        return USAGE
    if any(len(variable) < 2 for variable in options.var):
        print("pylmp: error: -var takes a name and at least one value", file=sys.stderr)
        return USAGE
    return Session(options).run()


def _tool(name: str, words: list[str]) -> int:
    """A tool's exit code; a reader that left or an interrupt is no error of its own."""
    tool: Callable[[list[str]], int] = import_module(f"pylmp.tools.{name}").main
    try:
        code = tool(words)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return WRONG
    except KeyboardInterrupt:
        return SIGNALLED + signal.SIGINT
    except OSError as error:
        print(f"ERROR: Cannot write {error.filename}: {error.strerror}", file=sys.stderr)
        return WRONG
    return code


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="pylmp", allow_abbrev=False,
        description="Run a LAMMPS input script. `pylmp diff SCRIPT` compares a run with real LAMMPS; `pylmp bench SCRIPT` measures both; "
        "`pylmp check SCRIPT...` finds what is wrong without a run; `pylmp explain SCRIPT[:LINE]` says what each command does; `pylmp restart info|to-data FILE` looks into a restart file.",
        epilog="Switches are those of lmp. Put the script first: -var takes all words up to the next switch.",
    )  # fmt: skip
    add = parser.add_argument
    add("script", nargs="?", help="input script; standard input if there is none")
    add("-in", "-i", dest="input", metavar="FILE", help="input script, as lmp takes it")
    add("-var", "-v", nargs="+", action="append", default=[], metavar="WORD", help="NAME VALUE...: an index variable")
    add("-log", "-l", metavar="FILE", help="log file, or none (default: log.lammps)")
    add("-screen", "-sc", metavar="FILE", help="screen output to a file, or none")
    add("-echo", "-e", default="log", choices=("none", "screen", "log", "both"), help="where commands are repeated")
    add("-skiprun", "-sr", action="store_true", help="set up every run, make no steps")
    add("-nocite", "-nc", action="store_true", help="accepted: nothing is cited anyway")
    add(
        "-suffix",
        "-sf",
        nargs="+",
        metavar="STYLE",
        help="accepted, without effect: styles have one implementation here",
    )
    add("-package", "-pk", nargs="+", metavar="WORD", help="accepted, without effect")
    add("-restart2data", "-r2data", nargs="+", metavar="FILE", help="RESTART DATA [nocoeff]: pylmp restart to-data")
    add("-restart2info", "-r2info", nargs="+", metavar="FILE", help="RESTART: pylmp restart info")
    add("--strict", action="store_true", help="accept exactly what LAMMPS 22 Jul 2025 accepts")
    add(
        "--engine", default="auto", choices=ENGINES,
        help="who carries out the runs: auto or fast, the fast engine where it can, else the exact one; exact, which has the bits of LAMMPS; "
        "lammps (default: auto)",
    )  # fmt: skip
    add(
        "--threads", type=int, metavar="N",
        help="threads of the fast engine; results do not depend on it (default: OMP_NUM_THREADS, else 1)",
    )  # fmt: skip
    add_switches(parser)
    add("--max-commands", type=int, metavar="N", help="stop a script that carries out more commands (default: no limit)")
    add("--max-jumps", type=int, metavar="N", help=f"jumps in a row that change nothing but variables (default: {JUMPS}; 0: any number)")
    add("--checkpoint-on-exit", dest="checkpoint", metavar="FILE", help="write a restart file when Ctrl-C or SIGTERM ends the run")
    add("--version", action="version", version=f"pylmp {__version__}")
    return parser


def _script_after_var(options: argparse.Namespace) -> None:
    """`-var x 300 in.script` swallows the script: an existing file at the end of the last -var is taken back."""
    if options.script is None and options.input is None and options.var:
        last = options.var[-1]
        if len(last) > 2 and Path(last[-1]).is_file():
            options.script = last.pop()
            print(f"pylmp: taking {options.script} as the script; put it first to be clear", file=sys.stderr)
