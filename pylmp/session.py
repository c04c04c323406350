"""One run of a script from the command line: streams, interpreter, signals, exit code."""

from __future__ import annotations

import argparse
import contextlib
import os
import signal
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from pylmp import __version__
from pylmp.model.console import Console
from pylmp.model.interrupts import Interrupted
from pylmp.model.limits import JUMPS, bounded
from pylmp.text.diagnostic import ScriptError, Unsupported, render
from pylmp.text.lines import decode
from pylmp.tools.permits import granted

if TYPE_CHECKING:
    from pylmp.interpreter import Interpreter

OK, WRONG, UNSUPPORTED, SIGNALLED = 0, 1, 5, 128  # SIGNALLED plus the number of the signal
LOG = "log.lammps"
BANNER = "LAMMPS (22 Jul 2025 - Update 4)"  # what log readers look for: the release whose numbers these are


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
        from pylmp.kernels.heap import part_with_large
        from pylmp.kernels.team import Team, threads
        from pylmp.model.simulation import Simulation

        try:
            console = Console(self._open(options.screen, "screen", sys.stdout), self._open(options.log or _log(), "log", None))
        except OSError as error:
            print(f"ERROR: {error}", file=sys.stderr)
            return WRONG
        sim = Simulation(console, Exact(Announcer()) if options.engine == "exact" else Fast(Announcer()))
        sim.team = Team(threads(options.threads))
        sim.strict = options.strict
        part_with_large()
        sim.interrupts.loud = sys.stderr.isatty()
        jumps = (0 if options.trust else JUMPS) if options.max_jumps is None else options.max_jumps
        interpreter = Interpreter(sim, granted(options), options.max_commands, jumps or None)
        interpreter.echo = options.echo
        finished = False
        try:
            self._begin(interpreter)
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
            _tell(console, f"Total wall time: {seconds // 3600}:{seconds // 60 % 60:02d}:{seconds % 60:02d}\n")
        return self._close(console) or code

    def _begin(self, interpreter: Interpreter) -> None:
        """What the switches ask for, and the first lines of the log."""
        options, sim = self.options, interpreter.sim
        sim.console.both(f"{BANNER}\n  pylmp {__version__}, engine {options.engine}\n")
        if options.skiprun:
            sim.timer.set_limit(0.0)
            sim.console.both(f"New timer settings: {sim.timer}\n")
        if options.suffix or options.package:
            sim.console.both("  -suffix and -package change nothing: each style has one implementation here\n")
        for name, *values in options.var:
            interpreter.variables.set_index(name, values)

    def _explain(self, error: BaseException, interpreter: Interpreter) -> int:
        """Say what ended the script; the exit code."""
        from pylmp.kernels.load import Forbidden
        from pylmp.text.leave import Quit

        console = interpreter.sim.console
        if console.screen_file is None and not isinstance(error, Quit):
            console = Console(sys.stderr, console.log_file)
        if isinstance(error, Quit):
            interpreter.sim.finish()
            return error.code
        if isinstance(error, ScriptError):
            _tell(console, render(error.diagnostic, interpreter.source) + "\n")
            return UNSUPPORTED if isinstance(error, Unsupported) else WRONG
        if isinstance(error, KeyboardInterrupt):
            _tell(console, f"Interrupted at step {interpreter.sim.step}; what was computed is in the files\n")
            if isinstance(error, Interrupted) and error.whole:
                self._checkpoint(interpreter, console)
                interpreter.sim.finish()
            return SIGNALLED + getattr(error, "number", signal.SIGINT)
        if isinstance(error, BrokenPipeError):
            sys.stdout = open(os.devnull, "w")  # noqa: SIM115
            return WRONG
        if isinstance(error, Forbidden):
            _tell(console, f"ERROR: {error}\n  hint: run it where that is allowed (SELinux, systemd and containers can forbid it); pylmp doctor looks\n")
            return WRONG
        if os.environ.get("PYLMP_DEBUG") or isinstance(error, SystemExit):
            raise error
        _tell(console,
            f"ERROR: pylmp itself failed ({type(error).__name__}: {error})\n"
            "  hint: please report this with the script; PYLMP_DEBUG=1 shows where\n"
        )
        return WRONG

    def _checkpoint(self, interpreter: Interpreter, console: Console) -> None:
        """The restart file that --checkpoint-on-exit asks for; where it goes is the user's affair, not the script's."""
        if self.options.checkpoint is None:
            return
        if not interpreter.sim.has_box:
            _tell(console, "No checkpoint: there is no simulation box yet\n")
            return
        from pylmp.model.registry import COMMANDS
        from pylmp.text.words import Args, Word

        write_restart = COMMANDS.find("write_restart")
        assert write_restart is not None
        interpreter.allow |= {"write"}
        try:
            write_restart.run(interpreter.sim, Args("write_restart", [Word(self.options.checkpoint)]))
            _tell(console, f"Checkpoint: {self.options.checkpoint}\n")
        except ScriptError as error:
            _tell(console, render(error.diagnostic) + "\n")

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
    def _close(console: Console) -> int:
        """0, or WRONG if the last lines could not be written."""
        try:
            console.flush()
        except BrokenPipeError:
            pass
        except OSError as error:
            sys.stdout = open(os.devnull, "w")  # noqa: SIM115
            print(f"ERROR: Error writing to the screen: {error.strerror}", file=sys.stderr)
            return WRONG
        finally:
            if console.log_file is not None:
                with contextlib.suppress(OSError):
                    console.log_file.close()
        return OK

    def _on_lammps(self, path: str | None) -> int:
        """The script, unchanged, on real LAMMPS."""
        from pylmp.engines import lammps

        options = self.options
        switches = [w for names in options.var for w in ("-var", *names)]
        switches += ["-log", options.log or LOG, "-echo", options.echo]
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


def _log() -> str:
    """The log file that nobody asked for. Raises OSError if it is a link that leads out of the working directory."""
    if os.path.islink(LOG) and not Path(LOG).resolve().is_relative_to(Path.cwd().resolve()):
        raise OSError(f"Cannot open log file {LOG}: it is a link to {Path(LOG).resolve()}; -log FILE says where the log goes")
    return LOG


def _tell(console: Console, text: str) -> None:
    """Say it where that is possible: a stream that cannot be written is left out."""
    for say in (console.screen, console.log):
        with contextlib.suppress(ScriptError, OSError):
            say(text)
