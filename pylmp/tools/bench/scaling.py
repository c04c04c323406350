"""pylmp bench --scaling: one liquid from 4 000 to 256 000 atoms and beyond: cost of a step and memory."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from pylmp.tools.bench.contenders import Contender
from pylmp.tools.bench.measure import Result, measure
from pylmp.tools.bench.report import as_dict
from pylmp.tools.bench.table import NOTHING, grid, remarks

LIQUID = "in.F_liquid"  # its variables: cells of four atoms along each edge, steps before and while it is measured
CELLS = (10, 16, 25, 40)
LARGEST = 63  # 1 000 188 atoms
_WORK, _LEAST, _SETTLE = 4_000_000, 40, 50


def scale(
    decks: Path,
    contenders: Sequence[Contender],
    repeat: int,
    switches: Sequence[str],
    timeout: float | None,
    largest: bool,
    tell: Callable[[str], None],
) -> list[Result]:
    """The liquid of each size, smallest first; fewer steps of more atoms. An engine that fails does so for its size alone."""
    results = []
    for size in [*CELLS, *([LARGEST] if largest else [])]:
        steps = max(_LEAST, _WORK // (4 * size**3))
        given = [*switches, "-var", "cells", str(size), "-var", "settle", str(_SETTLE), "-var", "steps", str(steps)]  # the first counts
        results.append(measure(decks / LIQUID, contenders, repeat, given, timeout, tell))
    return results


def rows(results: Sequence[Result]) -> list[tuple[str, ...]]:
    """Head and one row a size: nanoseconds per atom and step of each engine, then megabytes of each."""
    titles = [row.contender.title for row in results[0].rows]
    table: list[tuple[str, ...]] = [("atoms", *(f"{t}, CPU ns/atom/step" for t in titles), *(f"{t}, MB" for t in titles))]
    for result in results:
        atoms = next((row.samples[0].loop.atoms for row in result.rows if row.samples), None)
        costs = [cost(result, k) for k in range(len(titles))]
        peaks = [max((s.peak for s in row.samples), default=None) for row in result.rows]
        table.append(
            (
                NOTHING if atoms is None else str(atoms),
                *("failed" if c is None else f"{c:.1f}" for c in costs),
                *(NOTHING if p is None else f"{p / 1e6:.0f}" for p in peaks),
            )
        )
    return table


def cost(result: Result, k: int) -> float | None:
    """Nanoseconds per atom and step of the k-th engine, of processor time if it has one thread; None if it failed."""
    row = result.rows[k]
    if not row.samples or row.said is not None:
        return None
    return 1e9 / row.work * row.median(lambda s: s.cpu if row.contender.threads == 1 else s.loop.seconds)


def growth(results: Sequence[Result]) -> list[str]:
    """How much dearer an atom is in the largest system than in the smallest, a sentence an engine; and what failed."""
    said = []
    for k, row in enumerate(results[0].rows):
        small, large = cost(results[0], k), cost(results[-1], k)
        if small and large:
            said.append(f"{row.contender.title}: an atom's step of the largest takes {large / small:.2f} times that of the smallest")
    return said + [note for result in results for note in remarks(result)]


def text(results: Sequence[Result], bars: bool = False) -> str:
    """The table and its sentences."""
    lines = [f"- {line}" if bars else f"  {line}" for line in growth(results)]
    return "\n".join([*grid(rows(results), bars), *([""] if bars else []), *lines])


def report(results: Sequence[Result], machine: dict[str, Any]) -> dict[str, Any]:
    """The same object as of a bench of scripts: each size is one of them."""
    return as_dict(results, machine) | {"scaling": True}
