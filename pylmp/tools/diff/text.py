"""A report as text: the verdict first, then one block a run command, then what was compared cell by cell."""

from __future__ import annotations

import math
from collections.abc import Iterable

from pylmp.tools.diff.compare import Comparison
from pylmp.tools.diff.measure import Run
from pylmp.tools.diff.report import Report
from pylmp.tools.diff.verdict import Compared, Growth

_NAMES = {"x": "positions", "v": "velocities", "f": "forces", "box": "box"}


def as_text(report: Report) -> str:
    lines = [f"{report.script}: {report.verdict.word}"]
    lines += [f"  {reason}" for reason in report.verdict.reasons]
    lines += [f"  for LAMMPS, {note}" for note in report.dialect]
    if not report.exact_dialect:
        lines.append("  the rewritten bond law is the same function with other roundings: the last bits may differ")
    for run in report.commands:
        lines += _run(run, report)
    if report.growth:
        lines.append(f"  positions part {rate(report.growth)}")
    if report.shadow:
        lines.append(f"  {report.theirs} against its shadow: {summary(report.shadow)}")
        if report.shadow_growth:
            lines.append(f"    they part {rate(report.shadow_growth)}")
    for name, one in report.noise.items():
        lines.append(f"  {report.theirs} against {name}: {one if isinstance(one, str) else summary(one)}")
    if report.resync:
        lines += _resync(report)
    return "\n".join([*lines, *parts(report.found.parts, report.mine, report.theirs)])


def rate(growth: Growth) -> str:
    if growth.rate <= 0.0:
        return "without growth"
    return f"as exp({growth.rate:.3g} per step), ten times as far every {math.log(10.0) / growth.rate:.0f} steps"


def summary(compared: Compared) -> str:
    """One line on all runs of a comparison."""
    if compared.parts.identical:
        return "identical"
    apart = [point.x for run in compared.runs for point in run.curve]
    columns = {c.name: c.gap.relative for run in compared.runs for c in run.columns if c.first is not None}
    worst = max(columns, key=lambda name: columns[name]) if columns else ""
    first = next((f", bonds from step {run.ledger.first_count} on" for run in compared.runs if run.ledger and run.ledger.first_count is not None), "")
    largest = f"positions up to {max(apart):.3g} apart" if apart else "no positions"
    return largest + (f", thermo up to {columns[worst]:.2g} ({worst})" if worst else "") + first


def _run(run: Run, report: Report) -> list[str]:
    lines = [f"  run {run.number}, steps {run.first} to {run.last}, {run.atoms[1]} atoms"]
    for when, gaps in (("first step", run.start), ("end", run.end)):
        if gaps:
            told = ", ".join(f"{_NAMES[key]} {gap.largest:.3g} ({gap.relative:.2g})" for key, gap in gaps.items() if gap.largest)
            lines.append(f"    {when}: {told or 'equal in x v f' + (' and box' if 'box' in gaps else '')}")
        if when == "first step" and run.number == 1 and [bin for bin, _ in run.ulps if bin]:  # later runs begin apart
            lines.append(f"      forces, last places: {', '.join(f'{count} at most {bin}' if bin else f'{count} equal' for bin, count in run.ulps)}")
    if run.flags:
        lines.append(f"    image flags of {run.flags} atoms differ at the end")
    apart = [column for column in run.columns if column.first is not None]
    if apart:
        lines += table(
            ["column", "first step", "largest", "relative"],
            [[c.name, str(c.first), f"{c.gap.largest:.3g}", f"{c.gap.relative:.2g}"] for c in apart],
        )
    lines += [f"    {line}" for line in ledger(run, report.mine, report.theirs)]
    return lines


def ledger(run: Run, mine: str, theirs: str) -> list[str]:
    """Sentences on bonds that broke or yielded."""
    lines = []
    found = run.ledger
    if found is not None and any(found.counts):
        same = "as many at every step" if found.first_count is None else f"other numbers from step {found.first_count} on"
        lines.append(f"bonds broken: {found.counts[0]} in {mine}, {found.counts[1]} in {theirs}, {same}")
        if found.bonds is not None:
            lines.append(f"  {found.same} of them at the same step in both")
    if found is not None and found.first is not None:
        one = found.first
        steps = [f"at step {step}" if step is not None else "not" for step in (one.mine, one.theirs)]
        lines.append(f"  first disagreement: bond {one.ends[0]}-{one.ends[1]} of type {one.type} broke {steps[0]} in {mine}, {steps[1]} in {theirs}")
        if one.margin is not None:
            lines.append(f"  it was {one.margin:.3g} of its limit away from it where it held{': a tie, not a bug' if one.tie else ''}")
    if run.yielded is not None and any(run.yielded):
        apart = f", {run.yielded_apart} in only one of them" if run.yielded_apart else ", the same ones"
        lines.append(f"bonds yielded: {run.yielded[0]} in {mine}, {run.yielded[1]} in {theirs}{apart}")
    return lines


def table(head: list[str], rows: Iterable[list[str]]) -> list[str]:
    """Aligned columns, the first to the left."""
    whole = [head, *rows]
    wide = [max(len(row[k]) for row in whole) for k in range(len(head))]
    return ["    " + "  ".join(c.ljust(w) if k == 0 else c.rjust(w) for k, (c, w) in enumerate(zip(row, wide, strict=True))) for row in whole]


def parts(comparison: Comparison, mine: str, theirs: str) -> list[str]:
    lines = []
    for part in comparison.parts:
        state = "identical" if part.first is None else f"{part.differing} differ"
        lines.append(f"  {part.name}: {part.cells} compared, {state}")
        if part.first is not None:
            apart = f" ({part.first.ulps} ulps)" if part.first.ulps is not None else ""
            lines.append(f"    first: {part.first.place}: {mine} {part.first.pylmp}, {theirs} {part.first.lammps}{apart}")
    return lines


def _resync(report: Report) -> list[str]:
    assert report.resync is not None
    lines = [f"  windows of {report.resync.every} steps, each from the same state:"]
    rows = [[str(w.step), f"{w.x:.3g}", f"{w.v:.3g}", str(w.bonds)] for w in report.resync.windows]
    return lines + table(["from step", "positions", "velocities", "bonds that differ"], rows)
