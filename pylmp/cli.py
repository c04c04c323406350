"""The door: `pylmp in.script` as `lmp -in in.script`, and `pylmp diff`, `pylmp bench`.

Exit codes: 0 done, the script's own with quit, 1 the script or the run is wrong, 2 wrong usage, 4 diff found a difference,
5 LAMMPS has it and pylmp does not, 130 interrupted, 143 terminated.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import signal
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from pylmp import __version__
from pylmp.model.console import Console
from pylmp.model.interrupts import Interrupted
from pylmp.model.limits import JUMPS, bounded
from pylmp.text.diagnostic import ScriptError, Unsupported, render
from pylmp.text.lines import decode
from pylmp.tools.permits import add_switches, granted

if TYPE_CHECKING:
    from pylmp.interpreter import Interpreter

OK, WRONG, USAGE, UNSUPPORTED, SIGNALLED = 0, 1, 2, 5, 128  # SIGNALLED plus the number of the signal
BANNER = "LAMMPS (22 Jul 2025 - Update 4)"  # what log readers look for: the release whose numbers these are
ENGINES = ("auto", "exact", "fast", "lammps")


def main(arguments: Sequence[str] | None = None) -> int:
    """Entry point; returns the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    if words[:1] == ["diff"]:
        from pylmp.tools.diff import main as diff

        return _guarded(diff, words[1:])
    if words[:1] == ["bench"]:
        from pylmp.tools.bench import main as bench

        return _guarded(bench, words[1:])
    if words[:1] == ["restart"]:
        return _restart(words[1:])
    if words[:1] == ["run"]:
        words = words[1:]
    try:
        options = _parser().parse_args(words)
    except SystemExit as leave:
        return int(leave.code or 0)
    if options.restart2info:
        return _restart(["info", options.restart2info[0]])
    if options.restart2data:
        flags = [f"--{word}" if word == "nocoeff" else word for word in options.restart2data[2:]]
        return _restart(["to-data", *options.restart2data[:2], *flags])
    _script_after_var(options)
    if options.script is None and options.input is None and sys.stdin.isatty():
        _parser().print_help()
        return USAGE
    if any(len(variable) < 2 for variable in options.var):
        print("pylmp: error: -var takes a name and at least one value", file=sys.stderr)
        return USAGE
    return Session(options).run()


def _restart(words: list[str]) -> int:
    from pylmp.tools.restart import main as restart

    return _guarded(restart, words)


def _guarded(tool: Callable[[list[str]], int], words: list[str]) -> int:
    """A tool's exit code; a reader that left or an interrupt is no error of its own."""
    try:
        code = tool(words)
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return WRONG
    except KeyboardInterrupt:
        return SIGNALLED + signal.SIGINT
    return code


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="pylmp", allow_abbrev=False,
        description="Run a LAMMPS input script. `pylmp diff SCRIPT` compares a run with real LAMMPS; `pylmp bench SCRIPT` measures both; "
        "`pylmp restart info|to-data FILE` looks into a restart file.",
        epilog="Switches are those of lmp. Put the script first: -var takes all words up to the next switch.",
    )  # fmt: skip
    add = parser.add_argument
    add("script", nargs="?", help="input script; standard input if there is none")
    add("-in", "-i", dest="input", metavar="FILE", help="input script, as lmp takes it")
    add("-var", "-v", nargs="+", action="append", default=[], metavar="WORD", help="NAME VALUE...: an index variable")
    add("-log", "-l", default="log.lammps", metavar="FILE", help="log file, or none (default: log.lammps)")
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


class Session:
    """One run of a script from the command line: streams, interpreter, exit code."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.started = time.monotonic()

    def run(self) -> int:
        options = self.options
        path = options.script or options.input
        if options.engine == "lammps":
            return self._on_lammps(path)
        import numpy as np

        from pylmp.engines.announce import Announcer
        from pylmp.engines.exact import Exact
        from pylmp.engines.fast import Fast
        from pylmp.interpreter import Interpreter
        from pylmp.model.simulation import Simulation

        try:
            console = Console(self._open(options.screen, "screen", sys.stdout), self._open(options.log, "log", None))
        except OSError as error:
            print(f"ERROR: {error}", file=sys.stderr)
            return WRONG
        sim = Simulation(console, Exact(Announcer()) if options.engine == "exact" else Fast(Announcer()))
        sim.strict = options.strict
        sim.interrupts.loud = sys.stderr.isatty()
        jumps = (0 if options.trust else JUMPS) if options.max_jumps is None else options.max_jumps
        interpreter = Interpreter(sim, granted(options), options.max_commands, jumps or None)
        interpreter.echo = options.echo
        console.both(f"{BANNER}\n  pylmp {__version__}, engine {options.engine}\n")
        if options.skiprun:
            sim.timer.set_limit(0.0)
            console.both(f"New timer settings: {sim.timer}\n")
        if options.suffix or options.package:
            console.both("  -suffix and -package change nothing: each style has one implementation here\n")
        finished = False
        try:
            for name, *values in options.var:
                interpreter.variables.set_index(name, values)
            text = "" if path else decode(sys.stdin.buffer.read(), "<stdin>")
            with sim.interrupts.listen(), bounded(), np.errstate(all="ignore"):  # numbers overflow in silence, as in C
                try:
                    if path:
                        interpreter.run_main(Path(path))
                    else:
                        interpreter.run(text, "<stdin>")
                    code, finished = OK, True
                    sim.finish()
                except BaseException as error:
                    code = self._explain(error, interpreter)
        except BaseException as error:
            code = self._explain(error, interpreter)
        finally:
            for dump in sim.output.dumps.values():
                dump.close()
        if finished:
            seconds = int(time.monotonic() - self.started)
            console.both(f"Total wall time: {seconds // 3600}:{seconds // 60 % 60:02d}:{seconds % 60:02d}\n")
        self._close(console)
        return code

    def _explain(self, error: BaseException, interpreter: Interpreter) -> int:
        """Say what ended the script; the exit code."""
        from pylmp.text.leave import Quit

        console = interpreter.sim.console
        if console.screen_file is None and not isinstance(error, Quit):
            console = Console(sys.stderr, console.log_file)
        if isinstance(error, Quit):
            interpreter.sim.finish()
            return error.code
        if isinstance(error, ScriptError):
            console.both(render(error.diagnostic, interpreter.source) + "\n")
            return UNSUPPORTED if isinstance(error, Unsupported) else WRONG
        if isinstance(error, KeyboardInterrupt):
            console.both(f"Interrupted at step {interpreter.sim.step}; what was computed is in the files\n")
            if isinstance(error, Interrupted) and error.whole:
                self._checkpoint(interpreter, console)
                interpreter.sim.finish()
            return SIGNALLED + getattr(error, "number", signal.SIGINT)
        if isinstance(error, BrokenPipeError):
            sys.stdout = open(os.devnull, "w")  # noqa: SIM115
            return WRONG
        if os.environ.get("PYLMP_DEBUG") or isinstance(error, SystemExit):
            raise error
        console.both(
            f"ERROR: pylmp itself failed ({type(error).__name__}: {error})\n"
            "  hint: please report this with the script; PYLMP_DEBUG=1 shows where\n"
        )
        return WRONG

    def _checkpoint(self, interpreter: Interpreter, console: Console) -> None:
        """The restart file that --checkpoint-on-exit asks for; where it goes is the user's affair, not the script's."""
        if self.options.checkpoint is None:
            return
        if not interpreter.sim.has_box:
            console.both("No checkpoint: there is no simulation box yet\n")
            return
        from pylmp.model.registry import COMMANDS
        from pylmp.text.words import Args, Word

        write_restart = COMMANDS.find("write_restart")
        assert write_restart is not None
        interpreter.allow |= {"write"}
        try:
            write_restart.run(interpreter.sim, Args("write_restart", [Word(self.options.checkpoint)]))
            console.both(f"Checkpoint: {self.options.checkpoint}\n")
        except ScriptError as error:
            console.both(render(error.diagnostic) + "\n")

    @staticmethod
    def _open(name: str | None, what: str, default: TextIO | None) -> TextIO | None:
        """The stream for a switch's FILE. Raises OSError with LAMMPS's sentence."""
        if name is None:
            return default
        if name == "none":
            return None
        try:
            return open(name, "w", buffering=1, errors="surrogateescape")  # line by line: whole lines whatever happens
        except OSError as error:
            raise OSError(f"Cannot open {what} file {name}: {error.strerror}") from None

    @staticmethod
    def _close(console: Console) -> None:
        with contextlib.suppress(BrokenPipeError):
            console.flush()
        if console.log_file is not None:
            console.log_file.close()

    def _on_lammps(self, path: str | None) -> int:
        """The script, unchanged, on real LAMMPS."""
        from pylmp.engines import lammps

        options = self.options
        switches = [w for names in options.var for w in ("-var", *names)]
        switches += ["-log", options.log, "-echo", options.echo]
        switches += ["-screen", options.screen] if options.screen else []
        switches += ["-nocite"] if options.nocite else []
        switches += ["-skiprun"] if options.skiprun else []
        try:
            if path is None:
                raise ScriptError("--engine lammps needs a script file")
            return lammps.run(path, Path.cwd(), switches, capture=False).returncode
        except ScriptError as error:
            print(render(error.diagnostic), file=sys.stderr)
            return WRONG
