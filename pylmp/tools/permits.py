"""The switches --allow and --trust: what a script may do besides computing and writing below the working directory."""

from __future__ import annotations

import argparse

from pylmp.model.paths import PERMISSIONS


def add_switches(parser: argparse.ArgumentParser) -> None:
    """--allow WHAT,WHAT (may be repeated) and --trust."""
    what = "let the script use the shell, read and write outside its folders, read the environment (docs/safety.md)"
    parser.add_argument("--allow", action="append", type=_names, default=[], metavar="WHAT,...", help=f"{','.join(PERMISSIONS)}: {what}")
    parser.add_argument("--trust", action="store_true", help="allow all of these, and loops of any length")


def granted(options: argparse.Namespace) -> list[str]:
    """The permissions that the switches give, without repetition."""
    return list(PERMISSIONS) if options.trust else sorted({name for names in options.allow for name in names})


def _names(text: str) -> list[str]:
    names = [name for name in text.split(",") if name]
    for name in names:
        if name not in PERMISSIONS:
            raise argparse.ArgumentTypeError(f"{name!r} is not one of {', '.join(PERMISSIONS)}")
    return names
