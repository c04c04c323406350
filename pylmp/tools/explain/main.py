"""The command ``pylmp explain``: exit 0, 1 if there is nothing to explain, 2 for wrong usage."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from pylmp.io.whole_file import write_whole
from pylmp.text.diagnostic import ScriptError, render

OKAY, WRONG = 0, 1


def main(arguments: list[str]) -> int:
    """Entry point; returns the exit code."""
    options = _parser().parse_args(arguments)
    try:
        text = _script(options) if _is_script(options.what) else _style(options)
    except ScriptError as error:
        print(render(error.diagnostic), file=sys.stderr)
        return WRONG
    print(text)
    return OKAY


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="pylmp explain", allow_abbrev=False,
        description="What each command of a script does here (SCRIPT or SCRIPT:LINE); or what a command or a style is (bond_style quartic, fix nve, run).",
        epilog="No step is made, no atom moves, and nothing is written but what --html and --plot ask for.",
    )  # fmt: skip
    parser.add_argument("what", nargs="+", metavar="SCRIPT[:LINE] | COMMAND [STYLE]", help="put it first")
    parser.add_argument("-var", "-v", nargs="+", action="append", default=[], metavar="WORD", help="NAME VALUE...: an index variable")
    parser.add_argument("--html", type=Path, metavar="FILE", help="one page for a browser, without anything from the network")
    parser.add_argument("--plot", type=Path, metavar="FILE", help="energy and force of a bond or pair style (needs matplotlib)")
    parser.add_argument("--coeffs", nargs="+", type=float, metavar="NUMBER", help="coefficients for --plot")
    parser.add_argument("--units", default="lj", help="whose names a style's page uses (default: lj)")
    return parser


def _place(what: str) -> tuple[Path, int | None]:
    """SCRIPT or SCRIPT:LINE."""
    name, colon, number = what.rpartition(":")
    if colon and number.isdigit() and not Path(what).is_file():
        return Path(name), int(number)
    return Path(what), None


def _is_script(what: list[str]) -> bool:
    return len(what) == 1 and (_place(what[0])[0].is_file() or "/" in what[0] or ":" in what[0] or what[0].startswith("in."))


def _script(options: argparse.Namespace) -> str:
    from pylmp.tools.explain import html
    from pylmp.tools.explain.text import Writer, colored
    from pylmp.tools.explain.watch import watch

    path, line = _place(options.what[0])
    story = watch(path, options.var)
    if options.html:
        write_whole(options.html, html.whole(story))
        return f"Written: {options.html}"
    text = Writer(colored()).story(story, line)
    if not text:
        raise ScriptError(f"No command begins on line {line} of {path}", hint="or the script does not get there")
    return text


def _style(options: argparse.Namespace) -> str:
    from pylmp.tools.explain.pages import KINDS, command_page, style_page
    from pylmp.tools.explain.text import Writer, colored
    from pylmp.tools.explain.units import named

    named("time", options.units) if options.units else ""
    kind, *rest = options.what
    styled = bool(rest) and (kind in KINDS or kind in ("atom_style", "thermo_style"))
    page = style_page(kind, rest[0]) if styled else command_page(kind)
    text = Writer(colored()).page(page, options.units)
    if options.plot:
        from pylmp.tools.explain.plot import draw

        draw(kind, rest[0] if rest else "", options.coeffs, options.plot)
        text += f"\n  Drawn: {options.plot}"
    return text
