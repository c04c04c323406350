"""The command ``pylmp check``: exit 0, 3 if an error was found, 2 for wrong usage or a file that cannot be read."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

OKAY, USAGE, FOUND = 0, 2, 3


def main(arguments: list[str]) -> int:
    """Entry point; returns the exit code."""
    try:
        options = _parser().parse_args(arguments)
    except SystemExit as leave:
        return int(leave.code or 0)
    from pylmp.text.diagnostic import Diagnostic, ScriptError, render
    from pylmp.text.span import Span
    from pylmp.tools.check import formats
    from pylmp.tools.check.look import look

    found: list[Diagnostic] = []
    sources = []
    unread = False
    for path in options.files:
        try:
            one, these = look(path, options.var)
        except ScriptError as error:
            print(render(error.diagnostic), file=sys.stderr)
            unread = True
            continue
        sources.append(one)
        found += [this for this in these if this not in found and _wanted(this.code, options)]

    def source(span: Span) -> str:
        return next((text for one in sources if (text := one.source(span))), "")

    errors, warnings = (sum(one.severity == word for one in found) for word in ("error", "warning"))
    notes = len(found) - errors - warnings
    if options.format in ("text", "github") and not options.notes:
        found = [one for one in found if one.severity != "note"]
    if options.format == "text":
        if found:
            print(formats.as_text(found, source))
        print(_summary(errors, warnings, 0 if options.notes else notes), file=sys.stderr)
    else:
        text = {"json": formats.as_json, "sarif": formats.as_sarif, "github": formats.as_github}[options.format](found)
        print(text, end="\n" if text else "")
    return USAGE if unread else FOUND if errors else OKAY


def _summary(errors: int, warnings: int, hidden: int) -> str:
    counts = ", ".join(
        f"{count or 'no'} {word}{'' if count == 1 else 's'}"
        for count, word in ((errors, "error"), (warnings, "warning"))
    )
    return counts + (f" ({hidden} note{'' if hidden == 1 else 's'}: --notes)" if hidden else "")


def _wanted(code: str, options: argparse.Namespace) -> bool:
    """Codes may be given by how they begin."""
    if any(code.startswith(begin) for begin in options.ignore):
        return False
    return not options.select or any(code.startswith(begin) for begin in options.select)


def _codes(text: str) -> list[str]:
    return [code for code in text.split(",") if code]


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="pylmp check", allow_abbrev=False,
        description="Every error and warning of scripts, without moving an atom or writing a file.",
        epilog="Exit code: 0; 3 if there are errors; 2 for wrong usage. `# pylmp: ignore[CODE]` on a line silences a finding there.",
    )  # fmt: skip
    add = parser.add_argument
    add("--notes", action="store_true", help="show notes too: warnings of LAMMPS itself, what is not checked and why")
    add("files", nargs="+", type=Path, metavar="FILE", help="scripts; put them first")
    add("-var", "-v", nargs="+", action="append", default=[], metavar="WORD", help="NAME VALUE...: an index variable")
    add("--format", choices=("text", "json", "sarif", "github"), default="text", help="default: text")
    add(
        "--select",
        type=_codes,
        default=[],
        metavar="CODE,...",
        help="only these; a code may be given by its beginning, as P1",
    )
    add("--ignore", type=_codes, default=[], metavar="CODE,...", help="not these")
    return parser
