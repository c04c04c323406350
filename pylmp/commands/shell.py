"""shell cd DIR | mkdir DIR... | mv OLD NEW | rm [-f] FILE... | rmdir DIR... | putenv NAME=VALUE... | any command of the system's shell"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable
from pathlib import Path

from pylmp.model.registry import command
from pylmp.model.simulation import Simulation
from pylmp.text.diagnostic import ScriptError
from pylmp.text.words import Args, Word

_SHELL = "/bin/sh"


@command("shell")
def shell(sim: Simulation, args: Args) -> None:
    """Carry out a command of the system. What goes wrong is a warning. Only with --allow shell."""
    if not len(args):
        args.missing()
    if "shell" not in sim.script.allow:
        raise ScriptError(
            f"Cannot run shell {args.words[0].text}: scripts may not use the shell", args.words[0].span, code="S103",
            hint="--allow shell lets scripts use it",
        )  # fmt: skip
    word = args.word()
    if word.text in ("cd", "mv"):
        count = 1 if word.text == "cd" else 2
        if len(args) != count:
            args.fail(f"Illegal shell command: expected {count + 1} argument but found {1 + len(args)}", word)
        first, last = args.word(), args.words[-1]
        if word.text == "cd":
            _try(sim, f"cd {first.text}", lambda: os.chdir(first.text))
        else:
            _try(sim, f"mv {first.text} {last.text}", lambda: _move(first.text, last.text))
    elif word.text in _EACH:
        if not len(args):
            args.fail(f"Illegal shell {word.text} command: missing argument(s)", word)
        quiet = word.text == "rm" and args.take("-f")
        for name in args.rest():
            _one(sim, word.text, name, quiet)
    else:
        _run(sim, args)


def _one(sim: Simulation, what: str, name: Word, quiet: bool) -> None:
    _try(sim, f"{what} {name.text}", lambda: _EACH[what](name.text), quiet)


def _try(sim: Simulation, what: str, act: Callable[[], object], quiet: bool = False) -> None:
    try:
        act()
    except (OSError, ValueError) as error:
        why = error.strerror if isinstance(error, OSError) else "Invalid argument"
        if not quiet:
            sim.console.warning(f"Shell command '{what}' failed with error '{why}'")


def _move(old: str, new: str) -> None:
    """Into a directory, or over a file."""
    target = Path(new)
    os.replace(old, target / Path(old).name if target.is_dir() else target)


def _make(name: str) -> None:
    Path(name).mkdir(parents=True, exist_ok=True)


def _put(text: str) -> None:
    name, _, value = text.partition("=")
    os.environ[name] = value


_EACH: dict[str, Callable[[str], object]] = {"mkdir": _make, "rm": os.unlink, "rmdir": os.rmdir, "putenv": _put}


def _run(sim: Simulation, args: Args) -> None:
    text = " ".join(word.text for word in args.words)
    sim.console.flush()
    try:
        status = subprocess.run([_SHELL, "-c", text], check=False).returncode
    except (OSError, ValueError):
        status = 1
    if status:
        sim.console.warning(f"Shell command {text} returned with non-zero status")
