"""What is wrong, where, and what to type instead: one value, one exception, one renderer.

Every complaint of the project is a `Diagnostic`. Code that finds something wrong raises
`ScriptError`; the door (cli) renders what reaches it, so no traceback reaches a user.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Self

from pylmp.text.span import Span

MANUAL = "https://docs.lammps.org/"
_WIDE = 240  # characters of a line shown


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One complaint.

    message   LAMMPS's own sentence where it has one, without the leading "ERROR: "
    span      where it stands; None until the interpreter knows
    hint      what to type instead
    code      the rule: "E..." errors, "D..." departures from LAMMPS, "B..." restrictions of a bond style
    manual    page under docs.lammps.org, e.g. "bond_quartic.html"
    severity  "error", "warning" or "note"
    also      further places with the same trouble, and what stands there
    formula   the formula it is about, the offset and length of what is wrong in it
    """

    message: str
    span: Span | None = None
    hint: str = ""
    code: str = ""
    manual: str = ""
    severity: str = "error"
    formula: tuple[str, int, int] | None = None
    also: tuple[tuple[Span, str], ...] = ()


class ScriptError(Exception):
    """The script (or a file it reads) is wrong. Carries a `Diagnostic`; ends the run with exit code 1."""

    def __init__(
        self, message: str, span: Span | None = None, *, hint: str = "", code: str = "", manual: str = ""
    ) -> None:
        super().__init__(message)
        self.diagnostic = Diagnostic(message, span, hint, code, manual)

    def at(self, span: Span | None) -> Self:
        """This error, placed at span unless it has a place already."""
        if self.diagnostic.span is None:
            self.diagnostic = replace(self.diagnostic, span=span)
        return self

    def along(self, others: Iterable[tuple[Span, str]]) -> Self:
        """This error, with further places that have the same trouble."""
        self.diagnostic = replace(self.diagnostic, also=tuple(others))
        return self

    def inside(self, formula: str, at: int, length: int) -> Self:
        """This error, at a place in a formula unless it has one already."""
        if self.diagnostic.formula is None:
            self.diagnostic = replace(self.diagnostic, formula=(formula, at, length))
        return self


class Unsupported(ScriptError):
    """LAMMPS knows this, pylmp's native engines do not. Exit code 5."""


def render(diagnostic: Diagnostic, source: Callable[[Span], str] | None = None) -> str:
    """The text a person reads: sentence, place, the line with a caret, hint, link.

    source  gives the physical line a span stands on; without it the line and caret are left out.
    """
    word = {"error": "ERROR", "warning": "WARNING", "note": "NOTE"}[diagnostic.severity]
    lines = [f"{word}: {diagnostic.message}"]
    span = diagnostic.span
    if span is not None:
        lines.append(f"  --> {span}" + (f"  [{diagnostic.code}]" if diagnostic.code else ""))
        text = source(span) if source else ""
        if text:
            lines += _shown(text.rstrip("\n"), span.column - 1, span.length)
    if diagnostic.formula is not None:
        formula, at, length = diagnostic.formula
        lines += [f"  --> column {at + 1} of the formula", *_shown(formula, at, length)]
    lines += [f"  --> {place}  {what}: the same" for place, what in diagnostic.also]
    if diagnostic.hint:
        lines.append(f"  hint: {diagnostic.hint}")
    if diagnostic.manual:
        lines.append(f"  manual: {MANUAL}{diagnostic.manual}")
    return "\n".join(lines)


def _shown(text: str, at: int, length: int) -> list[str]:
    """A line, or the part of a long one around a place, and carets below the place."""
    if len(text) > _WIDE:
        first = max(0, at - _WIDE // 4)
        text, at = text[first : first + _WIDE], at - first
    before = "".join("\t" if c == "\t" else " " for c in text[:at])
    return [f"   | {text}", f"   | {before}{'^' * max(1, min(length, _WIDE))}"]
