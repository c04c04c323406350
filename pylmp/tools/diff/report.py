"""A comparison as one JSON object. Its fields and their meanings: docs/diff.md."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, field
from typing import Any

from pylmp.tools.diff.measure import Run
from pylmp.tools.diff.resync import Resync
from pylmp.tools.diff.verdict import Compared, Growth, Verdict

SCHEMA = 2


@dataclass
class Report:
    """mine and theirs: titles of the two runs. shadow, noise: the reference against itself, by title. resync: a curve over windows."""

    script: str
    mine: str
    theirs: str
    found: Compared
    verdict: Verdict
    dialect: list[str] = field(default_factory=list)
    exact_dialect: bool = True
    growth: Growth | None = None
    shadow: Compared | None = None
    shadow_growth: Growth | None = None
    noise: dict[str, Compared | str] = field(default_factory=dict)  # or why there is none
    resync: Resync | None = None

    @property
    def commands(self) -> list[Run]:
        return self.found.runs


def as_dict(report: Report) -> dict[str, Any]:
    """Plain values only; numbers that JSON has not (inf, nan) are None."""
    noise = {name: {"said": one} if isinstance(one, str) else _compared(one) for name, one in report.noise.items()}
    whole = {
        "schema": SCHEMA, "script": report.script, "programs": [report.mine, report.theirs],
        "verdict": report.verdict.word, "reasons": report.verdict.reasons, "exit": report.verdict.code,
        "dialect": report.dialect, **report.found.parts.as_dict(), "runs": [_run(run) for run in report.commands],
        "growth": asdict(report.growth) if report.growth else None,
        "shadow": _compared(report.shadow) | {"growth": asdict(report.shadow_growth) if report.shadow_growth else None} if report.shadow else None,
        "noise": noise, "resync": asdict(report.resync) if report.resync else None,
    }  # fmt: skip
    cleaned: dict[str, Any] = _clean(whole)
    return cleaned


def _compared(one: Compared) -> dict[str, Any]:
    return {"identical": one.parts.identical, "runs": [_run(run) for run in one.runs]}


def _run(run: Run) -> dict[str, Any]:
    whole = asdict(run)
    for part in ("start", "end"):
        whole[part] = {key: asdict(gap) | {"relative": gap.relative} for key, gap in getattr(run, part).items()}
    whole["columns"] = [
        {"name": c.name, "first": c.first, "largest": c.gap.largest, "relative": c.gap.relative, "means": c.means, "spread": c.spread}
        for c in run.columns
    ]  # fmt: skip
    if run.ledger is not None and run.ledger.first is not None:
        whole["ledger"]["first"]["tie"] = run.ledger.first.tie
    return whole


def _clean(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: _clean(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_clean(one) for one in value]
    return value
