"""A report as one page for a browser: well-formed, no scripts, nothing from the network, light or dark as the reader has it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

from pylmp.tools.diff import text
from pylmp.tools.diff.measure import Run
from pylmp.tools.diff.report import Report
from pylmp.tools.diff.svg import Series, chart
from pylmp.tools.diff.verdict import IDENTICAL, ROUND_OFF, Compared

_STYLE = """
:root { color-scheme: light dark; --ink: #1d1d1f; --paper: #ffffff; --faint: #d5d5da; --quiet: #666670; --good: #06642c; --bad: #b00020;
  --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #a05a8c }
@media (prefers-color-scheme: dark) { :root { --ink: #ececf0; --paper: #161618; --faint: #3a3a40; --quiet: #a0a0aa; --good: #7bd88f; --bad: #ff7b8a;
  --c0: #56b4e9; --c1: #f0a04b; --c2: #34c99a; --c3: #d69cc0 } }
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 60rem; padding: 0 1rem; color: var(--ink); background: var(--paper) }
code { font-family: ui-monospace, Menlo, Consolas, monospace; font-size: 13px; overflow-wrap: anywhere }
.good { color: var(--good) } .bad { color: var(--bad) } .note { color: var(--quiet) }
table { border-collapse: collapse; margin: .5rem 0 1rem } th, td { padding: .15rem .9rem .15rem 0; text-align: right; border-bottom: 1px solid var(--faint) }
th:first-child, td:first-child { text-align: left } td, th { font-variant-numeric: tabular-nums; vertical-align: top }
svg { display: block; width: 100%; height: auto } svg text { fill: var(--ink); font-size: 12px }
svg .grid { stroke: var(--faint) } svg polyline, svg line { fill: none; stroke-width: 1.8 } svg .grid { stroke-width: 1 }
.c0 { stroke: var(--c0) } .c1 { stroke: var(--c1) } .c2 { stroke: var(--c2) } .c3 { stroke: var(--c3) }
.dot { stroke: none } .dot.c0 { fill: var(--c0) } .dot.c1 { fill: var(--c1) } .dot.c2 { fill: var(--c2) } .dot.c3 { fill: var(--c3) }
.legend span { margin-right: 1.6rem; white-space: nowrap } .key { display: inline-block; width: 36px; height: 8px; vertical-align: middle }
"""


def whole(report: Report) -> str:
    """The whole page."""
    name = escape(report.script)
    good = report.verdict.word in (IDENTICAL, ROUND_OFF)
    parts = [
        f'<h1><code>{name}</code>: <span class="{"good" if good else "bad"}">{report.verdict.word}</span></h1>',
        f"<p>{escape(report.mine)} against {escape(report.theirs)}.</p>",
        _list(report.verdict.reasons),
        _list([f"for LAMMPS, {note}" for note in report.dialect]),
        _growth(report),
        _windows(report),
        *(_run(run, report) for run in report.commands),
        _noise(report),
        _cells(report),
    ]
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"/><meta name="viewport" content="width=device-width"/>'
        f"<title>pylmp diff {name}</title><style>{_STYLE}</style></head><body>\n" + "\n".join(part for part in parts if part) + "\n</body></html>\n"
    )


def _list(lines: Iterable[str]) -> str:
    items = "".join(f"<li>{escape(line)}</li>" for line in lines)
    return f"<ul>{items}</ul>" if items else ""


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    if not rows:
        return ""
    top = "".join(f"<th>{escape(cell)}</th>" for cell in head)
    body = "".join(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def _curve(title: str, compared: Compared) -> Series:
    return Series(title, [(point.step, point.x) for run in compared.runs for point in run.curve])


def _growth(report: Report) -> str:
    series = [_curve(f"{report.mine} and {report.theirs}", report.found)]
    if report.shadow:
        series.append(_curve(f"{report.theirs} and its shadow", report.shadow))
    series += [_curve(f"{report.theirs} and {name}", one) for name, one in report.noise.items() if isinstance(one, Compared)]
    drawn = chart(series, "step", "largest distance of an atom")
    if not drawn:
        return ""
    said = [f"{report.mine} and {report.theirs} part {text.rate(report.growth)}"] if report.growth else []
    said += [f"{report.theirs} and its shadow part {text.rate(report.shadow_growth)}"] if report.shadow_growth else []
    return f"<h2>How far they part</h2>{drawn}{_list(said)}"


def _windows(report: Report) -> str:
    if not report.resync:
        return ""
    windows = report.resync.windows
    drawn = chart(
        [Series("positions", [(w.step, w.x) for w in windows]), Series("velocities", [(w.step, w.v) for w in windows])],
        "step at which the window begins", f"largest difference after {report.resync.every} steps",
    )  # fmt: skip
    same = "" if drawn else "<p>Equal at the end of every window.</p>"
    rows = [[str(w.step), f"{w.x:.3g}", f"{w.v:.3g}", str(w.bonds)] for w in windows]
    table = _table(["from step", "positions", "velocities", "bonds that differ"], rows)
    return f"<h2>Windows of {report.resync.every} steps, each from the same state</h2>{drawn}{same}{table}"


def _run(run: Run, report: Report) -> str:
    parts = [f"<h2>Run {run.number}: steps {run.first} to {run.last}, {run.atoms[1]} atoms</h2>"]
    names = {"x": "positions", "v": "velocities", "f": "forces", "box": "box"}
    rows = [
        [f"{names[key]}, {when}", f"{gap.largest:.3g}", f"{gap.relative:.2g}", f"{gap.scale:.4g}"]
        for when, gaps in (("first step", run.start), ("end", run.end))
        for key, gap in gaps.items()
    ]
    parts.append(_table(["", "largest difference", "of the largest", "largest value"], rows))
    if run.flags:
        parts.append(f"<p>Image flags of {run.flags} atoms differ at the end.</p>")
    if run.ulps:
        parts.append("<h3>Forces at the first step, last places</h3>")
        parts.append(_table(["at most apart", "numbers"], [[str(bin), str(count)] for bin, count in run.ulps]))
    apart = [column for column in run.columns if column.first is not None]
    if apart:
        cells = [[c.name, str(c.first), f"{c.gap.largest:.3g}", f"{c.gap.relative:.2g}", f"{c.means[0]:.8g}", f"{c.means[1]:.8g}"] for c in apart]
        parts.append("<h3>Thermo columns that differ</h3>")
        parts.append(_table(["column", "first step", "largest", "relative", f"mean, {report.mine}", f"mean, {report.theirs}"], cells))
    parts.append(_list(line.strip() for line in text.ledger(run, report.mine, report.theirs)))
    return "\n".join(part for part in parts if part)


def _noise(report: Report) -> str:
    rows = [[f"{report.theirs} against its shadow", text.summary(report.shadow)]] if report.shadow else []
    rows += [[f"{report.theirs} against {name}", one if isinstance(one, str) else text.summary(one)] for name, one in report.noise.items()]
    return f"<h2>The reference against itself</h2>{_table(['', ''], rows)}" if rows else ""


def _cells(report: Report) -> str:
    rows = []
    for part in report.found.parts.parts:
        first = f"{part.first.place}: {part.first.pylmp} and {part.first.lammps}" if part.first else ""
        rows.append([part.name, str(part.cells), str(part.differing), first])
    return f"<h2>Cell by cell</h2>{_table(['', 'compared', 'differ', 'first difference'], rows)}"
