"""How far two runs of a script are apart, run command by run command: forces at its first step, thermo columns, states, a curve over time."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pylmp.tools.diff import read
from pylmp.tools.diff.compare import reals
from pylmp.tools.diff.instrument import ATOMS, BONDS, CURVE, YIELD
from pylmp.tools.diff.ledger import Ledger
from pylmp.tools.diff.read import Numbers, Table

Floats = NDArray[np.float64]


@dataclass
class Gap:
    """Largest difference of some numbers. scale: the largest of the reference's numbers; relative: largest / scale."""

    largest: float
    scale: float

    @property
    def relative(self) -> float:
        return self.largest / self.scale if self.scale else (0.0 if self.largest == 0.0 else float("inf"))


@dataclass
class Column:
    """A thermo column. first: the first step whose numbers differ, None if none does. rows: (step, difference) of all."""

    name: str
    gap: Gap
    first: int | None
    rows: list[tuple[int, float]]
    means: tuple[float, float]  # over the second half of the table
    spread: float  # the standard error of their difference


@dataclass
class Point:
    """One step of the curve: largest distance between the two programs' places of an atom."""

    step: int
    x: float
    v: float


@dataclass
class Run:
    """One run command in two programs. start: x, v and f at its first step; end: x v f, box; both empty if there are no frames."""

    number: int
    first: int = 0
    last: int = 0
    start: dict[str, Gap] = field(default_factory=dict)
    ulps: list[tuple[int, int]] = field(default_factory=list)  # (at most so many, count) of the forces at the first step
    end: dict[str, Gap] = field(default_factory=dict)
    atoms: tuple[int, int] = (0, 0)
    flags: int = 0  # atoms whose image flags differ at the end
    columns: list[Column] = field(default_factory=list)
    curve: list[Point] = field(default_factory=list)
    yielded: tuple[int, int] | None = None
    yielded_apart: int = 0
    ledger: Ledger | None = None


def compare_runs(mine: Path, theirs: Path) -> list[Run]:
    """All run commands of two folders in which instrumented copies ran."""
    tables = [
        {table.run: table for table in read.tables((folder / "log.lammps").read_text()) if table.run} for folder in (mine, theirs)
    ]
    ends = [read.numbers(folder / ATOMS) for folder in (mine, theirs)]
    count = max((int(path.suffix[1:]) for folder in (mine, theirs) for path in folder.glob(f"{CURVE}*")), default=0)
    result = []
    for k in range(1, count + 1):
        run = Run(k)
        _curve(run, *(read.numbers(folder / f"{CURVE}{k}") for folder in (mine, theirs)))
        if all(k <= len(frames) for frames in ends):
            _end(run, ends[0][k - 1], ends[1][k - 1])
        if all(k in found for found in tables):
            run.columns = columns(tables[0][k], tables[1][k])
        result.append(run)
    _yielded(result, mine, theirs)
    return result


def _curve(run: Run, mine: list[Numbers], theirs: list[Numbers]) -> None:
    others = {frame.step: frame for frame in theirs}
    pairs = [(frame, others[frame.step]) for frame in mine if frame.step in others]
    if not pairs:
        return
    run.first, run.last = pairs[0][0].step, pairs[-1][0].step
    for a, b in pairs:
        run.curve.append(Point(a.step, *apart(a, b)))
    first, second = _matched(*pairs[0])
    run.start = _gaps(first, second, pairs[0][1].box)
    run.ulps = histogram(first["f"], second["f"])


def _end(run: Run, a: Numbers, b: Numbers) -> None:
    run.atoms = (len(a.values), len(b.values))
    run.last = max(run.last, a.step)
    x, y = _matched(a, b)
    run.end = _gaps(x, y, b.box) | {"box": _gap(a.box, b.box)}
    run.flags = int(np.any(x["i"] != y["i"], axis=1).sum())


_GROUPS = {"x": "x y z", "v": "vx vy vz", "f": "fx fy fz", "i": "ix iy iz"}


def _matched(a: Numbers, b: Numbers) -> tuple[dict[str, Floats], dict[str, Floats]]:
    """Quantities of the atoms that both frames have, in one order."""
    ids = [frame["id"][:, 0] for frame in (a, b)]
    _, i, j = np.intersect1d(ids[0], ids[1], return_indices=True)
    there = [key for key, names in _GROUPS.items() if names.split()[0] in a.columns]
    return {key: a[_GROUPS[key]][i] for key in there}, {key: b[_GROUPS[key]][j] for key in there}


def apart(a: Numbers, b: Numbers) -> tuple[float, float]:
    """Largest differences of positions and velocities."""
    x, y = _matched(a, b)
    return _most(_short(x["x"] - y["x"], b.box)), _most(x["v"] - y["v"])


def _gaps(a: dict[str, Floats], b: dict[str, Floats], box: Floats) -> dict[str, Gap]:
    result = {key: _gap(a[key], b[key]) for key in ("v", "f")}
    return {"x": Gap(_most(_short(a["x"] - b["x"], box)), _most(b["x"]))} | result


def _gap(a: Floats, b: Floats) -> Gap:
    with np.errstate(invalid="ignore"):
        return Gap(_most(np.where(a == b, 0.0, a - b)), _most(b))


def _most(values: Floats) -> float:
    """The largest size; infinite if one is not a number."""
    if not values.size:
        return 0.0
    return float(np.nan_to_num(np.abs(values), nan=np.inf).max())


def _short(d: Floats, box: Floats) -> Floats:
    """Distances without whole boxes between them (a program may have wrapped an atom one rebuild earlier)."""
    tilt = box[:, 2] if box.shape[1] == 3 else np.zeros(3)  # xy xz yz
    low, high = box[:, 0].copy(), box[:, 1].copy()
    low[0] -= min(0.0, tilt[0], tilt[1], tilt[0] + tilt[1])
    high[0] -= max(0.0, tilt[0], tilt[1], tilt[0] + tilt[1])
    low[1] -= min(0.0, tilt[2])
    high[1] -= max(0.0, tilt[2])
    edges = np.array([[high[0] - low[0], 0, 0], [tilt[0], high[1] - low[1], 0], [tilt[1], tilt[2], high[2] - low[2]]])
    d = d.copy()
    for axis in (2, 1, 0):
        if edges[axis, axis] > 0.0:
            d -= np.round(d[:, axis : axis + 1] / edges[axis, axis]) * edges[axis]
    return d


def histogram(a: Floats, b: Floats) -> list[tuple[int, int]]:
    """How many numbers are at most 0, 1, 2, 4, 8 ... doubles apart (each in the first bin that holds it)."""
    x, y = (np.ascontiguousarray(values + 0.0).view(np.int64).ravel() for values in (a, b))
    x, y = (np.where(bits >= 0, bits, -(bits & 0x7FFF_FFFF_FFFF_FFFF)) for bits in (x, y))
    between = np.maximum(x, y).view(np.uint64) - np.minimum(x, y).view(np.uint64)
    exact = np.where(a.ravel() == b.ravel(), 0.0, np.maximum(1.0, between.astype(float)))
    bins = np.where(exact > 0, np.ceil(np.log2(np.maximum(exact, 1.0))).astype(int) + 1, 0)
    return [(0 if k == 0 else 1 << (int(k) - 1), int((bins == k).sum())) for k in np.unique(bins)]


def columns(mine: Table, theirs: Table) -> list[Column]:
    """The columns that both tables have and that hold numbers."""
    result = []
    for name in mine.columns:
        if name in read.CLOCKS or name not in theirs.columns or name.startswith("Step"):
            continue
        at, other = mine.columns.index(name), theirs.columns.index(name)
        steps, pairs = [], []
        lines = {row[0]: row for row in theirs.rows}
        for row in mine.rows:
            if row[0] in lines and len(row) > at and len(lines[row[0]]) > other:
                values = reals(row[at], lines[row[0]][other])
                if values is not None:
                    steps.append(int(row[0]))
                    pairs.append(values)
        if pairs:
            result.append(_column(name, steps, np.array(pairs)))
    return result


def _column(name: str, steps: list[int], pairs: Floats) -> Column:
    a, b = pairs.T
    with np.errstate(invalid="ignore"):
        apart = np.nan_to_num(np.where((a == b) | (np.isnan(a) & np.isnan(b)), 0.0, np.abs(a - b)), nan=np.inf)
        differ = np.flatnonzero(apart)
        half = slice(len(a) // 2, None)
        means = float(a[half].mean()), float(b[half].mean())
        spread = float(np.hypot(_error(a[half]), _error(b[half])))
    rows = list(zip(steps, map(float, apart), strict=True))
    return Column(name, Gap(float(apart.max()), _most(b)), steps[differ[0]] if len(differ) else None, rows, means, spread)


def _error(values: Floats) -> float:
    """Standard error of a mean, from means of up to 8 blocks (neighbors in time know of each other)."""
    blocks = [block.mean() for block in np.array_split(values, min(8, len(values)))]
    return float(np.std(blocks, ddof=1) / np.sqrt(len(blocks))) if len(blocks) > 1 else 0.0


def _yielded(runs: list[Run], mine: Path, theirs: Path) -> None:
    """Bonds that have yielded at the end of each run, and how many of them only in one program."""
    found = [read.numbers(folder / BONDS) for folder in (mine, theirs)]
    by_step: list[dict[int, Numbers]] = [{frame.step: frame for frame in frames} for frames in found]
    for run in runs:
        frames = [frames.get(run.last) for frames in by_step]
        if any(frame is None or YIELD not in frame.columns for frame in frames):
            continue
        sets = []
        for frame in frames:
            assert frame is not None
            rows = frame[f"c_pylmp_ends[1] c_pylmp_ends[2] {YIELD}"]
            sets.append({(int(min(i, j)), int(max(i, j))) for i, j, ep in rows if ep != 0.0})
        run.yielded = len(sets[0]), len(sets[1])
        run.yielded_apart = len(sets[0] ^ sets[1])
