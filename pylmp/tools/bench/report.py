"""Results as one JSON object, and the state of the machine they were measured on."""

from __future__ import annotations

import os
import platform
import statistics
from collections.abc import Sequence
from dataclasses import asdict
from datetime import date
from pathlib import Path
from typing import Any

from pylmp.tools.bench.measure import Result, Row, Sample

SCHEMA = 1


def as_dict(results: Sequence[Result], machine: dict[str, Any]) -> dict[str, Any]:
    """{schema, machine, scripts: [{script, title, notes, engines: [...]}]}: seconds, bytes, and each run by itself."""
    scripts = [
        {"script": result.script.name, "title": result.title, "notes": result.notes, "engines": [_row(row) for row in result.rows]}
        for result in results
    ]
    return {"schema": SCHEMA, "machine": machine, "scripts": scripts}


def _row(row: Row) -> dict[str, Any]:
    about: dict[str, Any] = {
        "engine": row.contender.name, "title": row.contender.title, "threads": row.contender.threads, "failed": row.said,
        "runs": [_sample(sample) for sample in row.samples], "first": _sample(row.first) if row.first else None,
    }  # fmt: skip
    if row.samples:
        loop, middle = row.samples[-1].loop, statistics.median(row.seconds)
        about |= {
            "ran": loop.instead or row.contender.name, "why": loop.why, "atoms": loop.atoms, "steps": loop.steps,
            "median": middle, "least": min(row.seconds), "most": max(row.seconds),
            "ns_per_atom_step": 1e9 * middle / row.work, "steps_per_second": loop.steps / middle,
            "ratio": row.ratio, "ratio_by_cpu": row.by_cpu,
            "outside_loops": row.median(lambda s: s.rest), "compiling": row.compiling, "peak_bytes": max(s.peak for s in row.samples),
        }  # fmt: skip
    return about


def _sample(sample: Sample) -> dict[str, Any]:
    return asdict(sample.loop) | {"whole": sample.whole, "peak_bytes": sample.peak}


class Machine:
    """What is measured on, and how busy it was at the start and the end."""

    def __init__(self) -> None:
        self.before = _load()

    def as_dict(self) -> dict[str, Any]:
        return {
            "date": str(date.today()), "processor": _processor(), "cores": os.cpu_count(), "python": platform.python_version(),
            "load_before": self.before, "load_after": _load(),
        }  # fmt: skip


def sentence(machine: dict[str, Any]) -> str:
    """The machine in words."""
    said = f"{machine['date']}: {machine['processor']}, {machine['cores']} cores, Python {machine['python']}"
    if machine["load_before"] is None:
        return said
    return f"{said}, load average {machine['load_before']:.1f} at the start and {machine['load_after']:.1f} at the end"


def _load() -> float | None:
    try:
        return round(os.getloadavg()[0], 2)
    except OSError:
        return None


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()
