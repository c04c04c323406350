"""The verdict on two runs: identical, round-off, drift or different, and why.

What round-off can do is measured, not assumed: the reference runs once more as its own shadow, every atom moved by 1e-14 of the largest
coordinate. Differences up to FACTOR times what separates the shadow from the reference by then are explained.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from pylmp.tools.diff.compare import ANSWERS, LISTS, Comparison, Part
from pylmp.tools.diff.instrument import NUDGE
from pylmp.tools.diff.measure import Column, Gap, Point, Run

IDENTICAL, ROUND_OFF, DRIFT, DIFFERENT = "identical", "round-off", "drift", "different"
EXIT = {IDENTICAL: 0, ROUND_OFF: 0, DRIFT: 4, DIFFERENT: 4}
START = 1e-12  # of the largest: what x, v and f may differ by before a step is made
FLOOR = 1e-11  # of the largest: what a sum over atoms may differ by at any time
FACTOR = 100.0
SIGMAS = 6.0
ROWS = 8  # of half a table, for its mean to be judged
_OWN = "file pylmp-diff."  # judged by curve, end and ledger instead


@dataclass
class Verdict:
    word: str
    reasons: list[str] = field(default_factory=list)

    @property
    def code(self) -> int:
        return EXIT[self.word]


@dataclass
class Compared:
    """Everything measured between two runs of a script."""

    parts: Comparison
    runs: list[Run]


def judge(found: Compared, shadow: Compared | None, told: bool = True) -> Verdict:
    """shadow: the reference's shadow against the reference; None: nothing but the floors explains a difference.

    told: what commands say must be the same too (of two scripts it need not).
    """
    if found.parts.identical:
        return Verdict(IDENTICAL)
    tie = _tie(found.runs)
    different = [*_start(found.runs, shadow), *_curves(found.runs, shadow, tie)]
    if tie is None:
        different += [*_bonds(found.runs, shadow), *_parts(found.parts, shadow, told)]
    if different:
        return Verdict(DIFFERENT, different)
    drift = _columns(found.runs, shadow, tie)
    if drift:
        return Verdict(DRIFT, drift)
    said = ["every difference is one that the reference shows against itself after a nudge of 1e-14"]
    if tie is not None:
        said = [f"a tie at step {tie}: a bond at its limit to within 1e-10 broke in one program only; what follows is not judged"]
    return Verdict(ROUND_OFF, said)


def _tie(runs: Sequence[Run]) -> int | None:
    """The step of the first disagreement on a bond, if it is a tie."""
    for run in runs:
        if run.ledger is not None and run.ledger.first is not None:
            return run.ledger.first.step if run.ledger.first.tie else None
    return None


def _start(runs: Sequence[Run], shadow: Compared | None) -> list[str]:
    if not runs or not runs[0].start:
        return []
    own = shadow.runs[0].start if shadow and shadow.runs else {}
    names = {"x": "positions", "v": "velocities", "f": "forces"}
    return [
        f"{names[key]} differ by {gap.largest:.3g} before the first step ({gap.relative:.2g} of the largest)"
        for key, gap in runs[0].start.items()
        if gap.largest > START * gap.scale + FACTOR * own.get(key, Gap(0.0, 0.0)).largest
    ]


def _curves(runs: Sequence[Run], shadow: Compared | None, tie: int | None) -> list[str]:
    """The first point of the curve that growth from the nudge does not explain."""
    reached = NUDGE * max((run.start["x"].scale for run in runs if run.start), default=0.0)
    for run in runs:
        if run.atoms[0] != run.atoms[1] and tie is None:
            return [f"run {run.number} ends with {run.atoms[0]} and {run.atoms[1]} atoms"]
        own = {point.step: point.x for point in _of(shadow, run.number).curve}
        for point in run.curve:
            if tie is not None and point.step >= tie:
                return []
            reached = max(reached, own.get(point.step, 0.0))
            if point.x > FACTOR * reached:
                return [f"at step {point.step} atoms are {point.x:.3g} apart, where a nudge of 1e-14 explains {reached:.2g}"]
    return []


def _bonds(runs: Sequence[Run], shadow: Compared | None) -> list[str]:
    for run in runs:
        if run.ledger is not None and run.ledger.first_count is not None:
            own = _of(shadow, run.number).ledger
            if own is None or own.first_count is None:
                return [f"another number of bonds from step {run.ledger.first_count} on"]
    return []


def _parts(parts: Comparison, shadow: Compared | None, told: bool) -> list[str]:
    own = {part.name: part for part in shadow.parts.parts} if shadow else {}
    result = []
    for part in parts.parts:
        if part.name.startswith(_OWN) or part.name == LISTS or part.first is None or (part.name == ANSWERS and not told):
            continue
        other = own.get(part.name, Part(part.name))
        if part.words and not other.words:
            result.append(f"{part.name}: {part.words} words differ or are missing, first at {part.first.place}")
        elif part.name != "thermo" and part.largest > FACTOR * other.largest + FLOOR * part.scale and not other.words:
            result.append(f"{part.name}: numbers differ by {part.largest:.3g}")
    return result


def _columns(runs: Sequence[Run], shadow: Compared | None, tie: int | None) -> list[str]:
    reached: dict[str, float] = {}
    result: dict[str, str] = {}
    for run in runs:
        own = {column.name: column for column in _of(shadow, run.number).columns}
        for column in run.columns:
            other = own.get(column.name)
            steps = dict(other.rows) if other else {}
            for step, apart in column.rows:
                if tie is not None and step >= tie:
                    break
                reached[column.name] = max(reached.get(column.name, 0.0), steps.get(step, 0.0))
                if apart > FACTOR * reached[column.name] + FLOOR * column.gap.scale:
                    explained = f"where a nudge explains {reached[column.name]:.2g}"
                    result.setdefault(column.name, f"{column.name} differs by {apart:.3g} at step {step}, {explained}")
                    break
            if tie is None and (said := _mean(run, column, other)):
                result.setdefault(column.name, said)
    return list(result.values())


def _mean(run: Run, column: Column, other: Column | None) -> str:
    """Whether the mean over the second half of a table is another one."""
    apart = abs(column.means[0] - column.means[1])
    own = abs(other.means[0] - other.means[1]) if other else 0.0
    if len(column.rows) < 2 * ROWS or not apart > SIGMAS * column.spread + 10 * own + FLOOR * column.gap.scale:
        return ""
    return f"the mean of {column.name} over the second half of run {run.number} is {column.means[0]:.8g} and {column.means[1]:.8g} (error {column.spread:.2g})"


def _of(compared: Compared | None, number: int) -> Run:
    return next((run for run in compared.runs if run.number == number), Run(number)) if compared else Run(number)


@dataclass
class Growth:
    """An exponential through a curve: start * exp(rate * (step - first)), rate per step."""

    rate: float
    start: float
    first: int
    points: int


def growth(runs: Sequence[Run]) -> Growth | None:
    """Fitted where the curve grows: above its noise, below a hundredth of the largest coordinate; None if there are fewer than 4 such points."""
    scale = max((run.start["x"].scale for run in runs if run.start), default=0.0)
    points: list[Point] = [point for run in runs for point in run.curve if 0.0 < point.x < 1e-2 * scale]
    steps = np.array([point.step for point in points], dtype=float)
    if len(points) < 4 or steps.max() == steps.min() or points[-1].x <= points[0].x:
        return None
    rate, at = np.polyfit(steps - steps[0], np.log([point.x for point in points]), 1)
    return Growth(float(rate), float(np.exp(at)), int(steps[0]), len(points))
