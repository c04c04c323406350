"""What was found, as text, JSON, SARIF 2.1.0 and annotations of GitHub."""

from __future__ import annotations

import json
from collections.abc import Callable

from pylmp import __version__
from pylmp.text.diagnostic import MANUAL, Diagnostic, render
from pylmp.text.span import Span
from pylmp.tools.check.codes import describe

Source = Callable[[Span], str]


def as_text(found: list[Diagnostic], source: Source) -> str:
    return "\n\n".join(render(one, source) for one in found)


def as_json(found: list[Diagnostic]) -> str:
    """One object; schema counts its versions."""
    rows = [
        {
            "file": one.span.file if one.span else "", "line": one.span.line if one.span else 0, "column": one.span.column if one.span else 0,
            "length": one.span.length if one.span else 0, "code": one.code, "severity": one.severity, "message": one.message, "hint": one.hint,
            "manual": MANUAL + one.manual if one.manual else "",
        }
        for one in found
    ]  # fmt: skip
    return json.dumps({"schema": 1, "found": rows}, indent=1)


def as_github(found: list[Diagnostic]) -> str:
    """Workflow commands: one line each, shown at the line of the pull request."""
    lines = []
    for one in found:
        word = {"error": "error", "warning": "warning", "note": "notice"}[one.severity]
        span = one.span or Span("", 1, 1)
        where = f"file={_property(span.file)},line={span.line},col={span.column},endColumn={span.column + span.length},title={_property('pylmp ' + one.code)}"
        lines.append(f"::{word} {where}::{_data(one.message + (f' (hint: {one.hint})' if one.hint else ''))}")
    return "\n".join(lines)


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")


def as_sarif(found: list[Diagnostic]) -> str:
    """SARIF 2.1.0: one run, the rules that occur, a result each."""
    codes = sorted({one.code for one in found})
    rules = [{"id": code, "shortDescription": {"text": describe(code)}} for code in codes]
    results = [
        {
            "ruleId": one.code, "ruleIndex": codes.index(one.code), "level": one.severity,
            "message": {"text": one.message + (f"\nhint: {one.hint}" if one.hint else "")},
            "locations": [_location(one.span)] if one.span else [],
        }
        for one in found
    ]  # fmt: skip
    run = {
        "tool": {"driver": {"name": "pylmp", "version": __version__, "rules": rules}},
        "columnKind": "unicodeCodePoints",
        "results": results,
    }
    schema = "https://json.schemastore.org/sarif-2.1.0.json"
    return json.dumps({"$schema": schema, "version": "2.1.0", "runs": [run]}, indent=1)


def _location(span: Span) -> dict[str, object]:
    region = {"startLine": span.line, "startColumn": span.column, "endColumn": span.column + max(1, span.length)}
    return {"physicalLocation": {"artifactLocation": {"uri": span.file}, "region": region}}
