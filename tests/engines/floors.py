"""Writes the floors of docs/performance.md: what the loop over pairs would cost if it only fetched positions, or only calculated.

usage: python -m tests.engines.floors [ROUNDS]
"""

from __future__ import annotations

import io
import os
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from pylmp.engines.fast import Fast
from pylmp.interpreter import run_text
from pylmp.kernels.fast import blocks
from pylmp.kernels.fast.forces import force_loop
from pylmp.kernels.fast.terms import PairTerm
from pylmp.kernels.simd import LANES
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "performance.md"
DECKS = ("in.A_melt", "in.B_melt_long", "in.F_liquid")
START, END = "<!-- floors -->", "<!-- end -->"
HEAD = ["| script | neighbors of an atom | as it is | fetching alone | calculating alone |", "| --- | ---: | ---: | ---: | ---: |"]


def nothing(r2: Any, dot: Any, factor: Any, c: Any) -> tuple[Any, Any]:
    """A law that costs nothing."""
    return r2, r2


def loops(sim: Simulation) -> list[Callable[[], float]]:
    """The loop over pairs as it is, with a law that costs nothing, and with all neighbors next door."""
    forces, scrap, sums = sim.lists.forces, np.zeros_like(sim.atoms.f), np.zeros((16, 16))
    part, lists = forces.parts[0], forces.lists
    whole = force_loop(PairTerm(part.law, part.width, False, 1), None, sim.box.periodic, 0)
    bare = force_loop(PairTerm(nothing, part.width, False, 1), None, sim.box.periodic, 0)
    bonds, forces.bonds = forces.bonds, []
    calls = [forces.bound(sim, 0, function, 0, sums, scrap) for function in (whole, bare)]
    count, entries = blocks(sim.atoms.n), lists.neighbors.copy()
    block = np.repeat(np.arange(count), lists.depth[:count])
    beside = np.where(block + 1 < count, block + 1, 0)
    near = (3 * (LANES * beside[:, None] + np.arange(LANES))).astype(np.int32).ravel()
    lists.neighbors = np.concatenate([near, entries[len(near) :]])
    calls.append(forces.bound(sim, 0, whole, 0, sums, scrap))
    lists.neighbors, forces.bonds = entries, bonds
    return calls


def row(deck: str, rounds: int) -> str:
    sim = Simulation(Console(io.StringIO(), None), Fast())
    os.chdir(ROOT / "inputs" / "bench")
    text = Path(deck).read_text()
    run_text(sim, text.replace("variable        steps index 300", "variable        steps index 2"))
    calls = loops(sim)
    taken: list[list[float]] = [[] for _ in calls]
    for _ in range(rounds):
        for call, times in zip(calls, taken, strict=True):
            before = time.perf_counter()
            call()
            times.append(time.perf_counter() - before)
    per_atom = [1e9 * statistics.median(times) / sim.atoms.n for times in taken]
    entries = LANES * int(sim.lists.forces.lists.depth.sum()) / sim.atoms.n
    return f"| `{deck}` | {entries:.1f} | " + " | ".join(f"{cost:.1f}" for cost in per_atom) + " |"


def main() -> None:
    os.environ["OMP_NUM_THREADS"] = "1"
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    table = "\n".join([*HEAD, *(row(deck, rounds) for deck in DECKS)])
    before, _, rest = PAGE.read_text().partition(START)
    _, _, after = rest.partition(END)
    PAGE.write_text(f"{before}{START}\n\n{table}\n\n{END}{after}")


if __name__ == "__main__":
    main()
