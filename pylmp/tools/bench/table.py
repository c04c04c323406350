"""Results as a table: for the terminal and, the same, for a page of Markdown."""

from __future__ import annotations

import statistics
from collections.abc import Sequence

from pylmp.tools.bench.contenders import PAIRED
from pylmp.tools.bench.measure import Result, Row

HEAD = ("engine", "ns/atom/step", "least", "most", "CPU ns", "steps/s", "LAMMPS/it", "by CPU time", "CPU use", "outside loops, s", "first run, s")
NOTHING = "-"
PARTS = ("Pair", "Bond", "Neigh", "Comm", "Modify", "Output", "Other")


def text(results: Sequence[Result]) -> str:
    """One block a script: what it is, a table, remarks."""
    return "\n\n".join(_block(result) for result in results)


def markdown(results: Sequence[Result]) -> str:
    """One table of all scripts, one of the parts of their loops, and the remarks."""
    rows = [(f"`{result.script.name}`", *cells(row)) for result in results for row in result.rows]
    lines = grid([("script", *HEAD), *rows], bars=True)
    lines += ["", "Where the time goes, in ns of CPU time per atom and step, medians:", "", *grid(parts(results), bars=True)]
    notes = [f"- `{result.script.name}`: {note}" for result in results for note in remarks(result)]
    return "\n".join([*lines, *(["", *notes] if notes else [])])


def cells(row: Row) -> tuple[str, ...]:
    """A row of the table: the measured loop per atom and step, then the process around it."""
    title = row.contender.title
    if not row.samples or row.said is not None:
        return (title, "failed", *[NOTHING] * (len(HEAD) - 2))
    if instead := row.samples[-1].loop.instead:
        title += f" (ran on {instead})"
    unit, shares = 1e9 / row.work, [sample.loop.share for sample in row.samples]
    middle = row.median(lambda s: s.loop.seconds)
    return (
        title,
        _short(middle * unit), _short(min(row.seconds) * unit), _short(max(row.seconds) * unit),
        _short(row.median(lambda s: s.cpu) * unit) if row.contender.threads == 1 else NOTHING,
        _short(row.samples[0].loop.steps / middle),
        NOTHING if row.ratio is None else f"{row.ratio:.2f}",
        NOTHING if row.by_cpu is None else f"{row.by_cpu:.2f}",
        NOTHING if None in shares else f"{100.0 * row.median(lambda s: s.loop.share or 0.0):.0f}%",
        f"{row.median(lambda s: s.rest):.2f}",
        NOTHING if row.first is None else f"{row.first.whole:.2f}",
    )  # fmt: skip


def parts(results: Sequence[Result]) -> list[tuple[str, ...]]:
    """Head and a row for each script and engine of one thread: the parts of the loop, without the time it was kept waiting."""
    table: list[tuple[str, ...]] = [("script", "engine", *PARTS)]
    for result in results:
        for row in result.rows:
            if row.samples and row.said is None and row.contender.threads == 1:
                table.append((f"`{result.script.name}`", row.contender.title, *(_short(_part(row, name)) for name in PARTS)))
    return table


def _part(row: Row, name: str) -> float:
    """Nanoseconds: the log's seconds of this part, by the share of the loop in which the program had a processor."""
    return 1e9 / row.work * row.median(lambda s: s.loop.sections.get(name, 0.0) * s.cpu / s.loop.seconds)


def remarks(result: Result) -> list[str]:
    """What the table cannot hold: who stepped in, who failed and with which words, what was changed for LAMMPS."""
    found = [*(f"for LAMMPS, {note}" for note in result.notes), *_paired(result)]
    for row in result.rows:
        if row.said is not None:
            found.append(f"{row.contender.title} failed: {row.said}")
        elif row.samples[-1].loop.why:
            found.append(f"{row.contender.title} ran on {row.samples[-1].loop.instead}: {row.samples[-1].loop.why}")
    return found


def _paired(result: Result) -> list[str]:
    """Two threads of pylmp's against the best that LAMMPS does with two processors, round by round."""
    good = [row for row in result.rows if row.samples and row.said is None]
    pairs = [row for row in good if row.contender.name in PAIRED]
    if not pairs:
        return []
    best = min(pairs, key=lambda row: statistics.median(row.seconds))
    ratios = {
        row.contender.title: statistics.median(a / b for a, b in zip(best.seconds, row.seconds, strict=True))
        for row in good
        if row.contender.native and row.contender.threads == 2
    }
    return [f"{title}: {ratio:.2f} times as fast as {best.contender.title}, LAMMPS's best on two processors" for title, ratio in ratios.items()]


def grid(rows: Sequence[Sequence[str]], bars: bool = False) -> list[str]:
    """Rows in columns of equal width, the first row their heads: words to the left, numbers to the right."""
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    words = [all(not row[k][:1].isdigit() for row in rows[1:]) for k in range(len(widths))]
    padded = [
        [cell.ljust(width) if left else cell.rjust(width) for cell, width, left in zip(row, widths, words, strict=True)]
        for row in rows
    ]
    if not bars:
        return ["  " + "  ".join(row).rstrip() for row in padded]
    rule = ["-" * width if left else "-" * (width - 1) + ":" for width, left in zip(widths, words, strict=True)]
    return [f"| {' | '.join(row)} |" for row in (padded[0], rule, *padded[1:])]


def _block(result: Result) -> str:
    good = next((row for row in result.rows if row.samples), None)
    size = f": {good.samples[0].loop.atoms} atoms, {good.samples[0].loop.steps} steps, {len(good.samples)} rounds" if good else ""
    title = [f"  {result.title}"] if result.title != result.script.name else []
    lines = [f"{result.script.name}{size}", *title, *grid([HEAD, *(cells(row) for row in result.rows)])]
    return "\n".join([*lines, *(f"  {line}" for note in remarks(result) for line in note.splitlines())])


def _short(value: float) -> str:
    """Three figures."""
    return f"{value:.0f}" if value >= 99.95 else f"{value:.1f}" if value >= 9.995 else f"{value:.2f}"
