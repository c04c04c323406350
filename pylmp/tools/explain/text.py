"""Explanations as text for a terminal."""

from __future__ import annotations

import os
import sys
import textwrap
from collections.abc import Iterable

from pylmp.text.diagnostic import MANUAL
from pylmp.tools.explain.pages import Page, about
from pylmp.tools.explain.scene import RunTold
from pylmp.tools.explain.units import named
from pylmp.tools.explain.watch import Story, Told

_WIDTH = 110
_BOLD, _FAINT, _RED, _PLAIN = "\x1b[1m", "\x1b[2m", "\x1b[31m", "\x1b[0m"


def colored() -> bool:
    """Is the output a terminal whose user wants colors?"""
    return "FORCE_COLOR" in os.environ or (sys.stdout.isatty() and "NO_COLOR" not in os.environ)


class Writer:
    """Text with or without colors."""

    def __init__(self, colors: bool) -> None:
        self.colors = colors

    def paint(self, text: str, color: str) -> str:
        return f"{color}{text}{_PLAIN}" if self.colors else text

    def story(self, story: Story, line: int | None) -> str:
        """All commands, or those of one line."""
        wanted = [one for one in story.commands if line is None or (one.span.line == line and one.span.file == story.script)]
        blocks = [self.command(one) for one in wanted]
        if story.end and line is None:
            blocks.append(f"{story.end}.")
        return "\n\n".join(blocks)

    def command(self, one: Told) -> str:
        head = f"{one.span.file}:{one.span.line}  {self.paint(' '.join(one.words), _BOLD)}"
        rows = [head + (self.paint(f"  ({one.visits} times)", _FAINT) if one.visits > 1 else "")]
        page = about(one.words)
        if page is not None:
            rows += _wrapped(page.meaning.split(". ")[0].rstrip(".") + ".") if page.meaning else []
            rows += [f"      {line}" for line in page.formula]
        named_ones = [given for given in one.arguments if given.name and not given.default]
        for given in named_ones:
            unit = named(given.unit, one.units)
            rows.append(f"    {given.name.lower():<12} {given.value}{' ' + unit if unit else ''}")
        left = [f"{given.name} {given.value}" for given in one.arguments if given.default]
        rows += _wrapped(f"{kept(one.words[0])}: " + ", ".join(left), "    ") if left else []
        rows += [f"  -> {change}" for change in one.changes]
        rows += [self.paint(f"  |  {line}", _FAINT) for line in one.says]
        if one.run is not None:
            rows += self._run(one.run)
        if one.problem is not None:
            rows.append(self.paint(f"  !  {one.problem.message}", _RED) + (f" ({one.problem.hint})" if one.problem.hint else ""))
        if page is not None:
            rows.append(self.paint(f"  {page.link}", _FAINT))
        return "\n".join(rows)

    def _run(self, run: RunTold) -> list[str]:
        if run.same_as:
            return [f"  The same scene as at line {run.same_as}. Time {run.time}, for {run.steps} steps"]
        rows = [f"  Engine {run.engine}" + (f": engine fast lacks {', '.join(run.fallbacks)}" if run.fallbacks else "")]
        rows += ["  Each step:", *(f"    + {text}" for text in run.computed), "  Left out:", *(f"    - {text}" for text in run.left_out)]
        return [*rows, f"  Memory {run.memory}", f"  Time {run.time}, for {run.steps} steps"]

    def page(self, page: Page, units: str) -> str:
        rows = [self.paint(page.name, _BOLD), f"  {page.syntax}", ""]
        rows += _wrapped(page.meaning) + ([""] if page.meaning else []) + [f"      {line}" for line in page.formula] + ([""] if page.formula else [])
        if page.coeffs:
            rows.append("  Coefficients:")
            for name, unit in page.coeffs:
                text = named(unit, units)
                rows.append(f"    {name:<10} {unit}" + (f", in units {units}: {text}" if text and text != unit else ""))
        if page.keywords:
            rows.append("  Keywords and what they are if not given:")
            rows += [f"    {name:<14} {value}" for name, value in page.keywords.items()]
        if page.remembers:
            rows.append(f"  A bond remembers {' and '.join(page.remembers)}.")
        if page.rules:
            rows.append("  It refuses:")
            rows += [line for code, says, hint in page.rules for line in _wrapped(f"{code}  {says} ({hint})" if says else f"{code}  {hint}", "    ")]
        return "\n".join([*rows, "", f"  {MANUAL}{page.manual}"])


def kept(command: str) -> str:
    """What it means that a keyword is not given."""
    return "not given, stays as it was; at first" if command.endswith("_modify") or command == "timer" else "not given"


def _wrapped(text: str, indent: str = "  ") -> list[str]:
    lines: Iterable[str] = textwrap.wrap(text, _WIDTH, initial_indent=indent, subsequent_indent=indent + "  ")
    return list(lines)
