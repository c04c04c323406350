"""Writing a page: the table between two marks of it, and a plot beside it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from pylmp.io.whole_file import write_whole
from pylmp.text.diagnostic import ScriptError
from pylmp.tools.bench import scaling
from pylmp.tools.bench.contenders import SERIAL
from pylmp.tools.bench.measure import Result

END = "<!-- end -->"


def needs_matplotlib() -> None:
    """Raises ScriptError when there is nothing to draw with: better before the measurement than after."""
    if find_spec("matplotlib") is None:
        raise ScriptError("--write draws a plot and matplotlib is not installed", hint='pip install "pylmp[plot]" brings it')


def write(page: Path, name: str, said: str, results: Sequence[Result]) -> Path:
    """Put `said` between `<!-- NAME -->` and `<!-- end -->` of page (a new page if there is none); the plot's path.

    Raises ScriptError when the page has no such marks or cannot be written.
    """
    start = f"<!-- {name} -->"
    plot = page.with_name(f"{page.stem}-{name}.svg")
    block = f"{start}\n\n{said}\n\n![{name}]({plot.name})\n\n{END}"
    try:
        old = page.read_text() if page.exists() else f"# Performance\n\n{start}\n{END}\n"
        before, found, rest = old.partition(start)
        _, ended, after = rest.partition(END)
        if not found or not ended:
            raise ScriptError(f"{page} has no lines {start} and {END}", hint="the table goes between them")
        _draw(plot, name, results)
        write_whole(page, before + block + after)
    except OSError as error:
        raise ScriptError(f"Cannot write {page}: {error.strerror}") from None
    return plot


def _draw(path: Path, name: str, results: Sequence[Result]) -> None:
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    beside = path.with_suffix(".new")
    with rc_context({"svg.hashsalt": "pylmp", "svg.fonttype": "none", "font.size": 9}):
        figure = Figure(figsize=(7.0, 3.6), layout="constrained")
        axes = figure.add_subplot()
        (_sizes if name == "scaling" else _ratios)(axes, results)
        figure.savefig(beside, format="svg", metadata={"Date": None})
    os.replace(beside, path)


def _ratios(axes: Any, results: Sequence[Result]) -> None:
    """A group of bars a script: how many times as fast as LAMMPS serial each engine is, by processor time if it has one thread."""
    names = [result.script.name.removeprefix("in.").split("_")[0] for result in results]
    several = {n for n in names if names.count(n) > 1}
    names = [r.script.name.removeprefix("in.").replace("_", "\n") if n in several else n for n, r in zip(names, results, strict=True)]
    titles = list(dict.fromkeys(row.contender.title for r in results for row in r.rows if row.contender.name != SERIAL))
    wide = 0.8 / max(1, len(titles))
    for k, title in enumerate(titles):
        found = [
            (x, ratio)
            for x, result in enumerate(results)
            for row in result.rows
            if row.contender.title == title and (ratio := row.by_cpu or row.ratio) is not None
        ]
        axes.bar([x + (k - 0.5 * (len(titles) - 1)) * wide for x, _ in found], [y for _, y in found], wide, label=title)
    axes.axhline(1.0, color="black", linewidth=0.8)
    axes.set_xticks(range(len(names)), names, fontsize=8)
    axes.set_ylabel("LAMMPS serial's time / its own")
    if titles:
        axes.legend(fontsize=8, ncols=2)


def _sizes(axes: Any, results: Sequence[Result]) -> None:
    """Nanoseconds per atom and step over the number of atoms."""
    for k, row in enumerate(results[0].rows):
        found = [(r.rows[k].samples[0].loop.atoms, c) for r in results if (c := scaling.cost(r, k)) is not None]
        axes.plot([x for x, _ in found], [y for _, y in found], "o-", label=row.contender.title)
    axes.set_xscale("log")
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel("atoms")
    axes.set_ylabel("ns of CPU time per atom and step")
    axes.legend(fontsize=8)
