"""pylmp bench --dt, --skin: what is bought with time, what is paid with error.

The last run of the script is made with several timesteps (and skins) on several engines, each for the same simulated time. What should be
conserved is LAMMPS's econserve (energy without what thermostats put in) plus U0 of every quartic bond broken so far.
"""

from __future__ import annotations

import math
import shutil
import statistics
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pylmp.model.atoms import Floats
from pylmp.tools.bench import child, variant
from pylmp.tools.bench.contenders import Contender, contender
from pylmp.tools.bench.log import Loop, complaint, loops
from pylmp.tools.diff import read
from pylmp.tools.diff.dialect import translate


@dataclass(frozen=True)
class Point:
    """One run. dt: in units of the script's. tau: the timestep itself. per_time: seconds of the loop per unit of simulated time.

    spread: standard deviation of the conserved quantity around its drift, per atom. drift: its slope in kT per time and degree of freedom.
    force: rms deviation of the forces ten steps after the script's first run began from the exact engine's, over their rms. breaks: time of the first broken
    bond. blew: time of the last finite energy, if a later one is not. said: why there is nothing of all this.
    """

    contender: Contender
    dt: float
    skin: float | None
    tau: float = math.nan
    loop: Loop | None = None
    around: float = math.nan
    per_time: float = math.nan
    spread: float = math.nan
    drift: float = math.nan
    force: float = math.nan
    breaks: float | None = None
    blew: float | None = None
    said: str | None = None

    @property
    def good(self) -> bool:
        return self.said is None and self.blew is None


@dataclass(frozen=True)
class Sweep:
    """All points of a script. order: of convergence, by engine and skin, where it can be fitted. time: that every run simulates."""

    script: Path
    points: list[Point]
    time: float

    def curves(self) -> dict[tuple[str, float | None], list[Point]]:
        """Points of one engine and skin that went well, by timestep."""
        found: dict[tuple[str, float | None], list[Point]] = {}
        for point in sorted(self.points, key=lambda p: p.dt):
            if point.good and point.spread > 0.0:
                found.setdefault((point.contender.title, point.skin), []).append(point)
        return found


def sweep(
    script: Path, contenders: Sequence[Contender], steps: Sequence[float], skins: Sequence[float | None], switches: Sequence[str],
    timeout: float | None, repeat: int, tell: Callable[[str], None],
) -> Sweep:  # fmt: skip
    """Every engine with every timestep and skin, `repeat` times in turn; of the times the median.

    Raises ScriptError when the script is not there or has no run.
    """
    lines = script.read_text(errors="surrogateescape").splitlines()
    variant.last_run(lines)
    forces = {}
    for one in [contender("exact"), *contenders]:
        tell(f"{script.name}: {one.title}, forces")
        if one.name not in forces:
            forces[one.name] = _forces(script, lines, one, switches, timeout)
    tries = [(one, dt, skin) for skin in skins for dt in steps for one in contenders]
    found: dict[int, list[Point]] = {}
    for one in contenders:
        if one.native:  # compiles what is not in the store
            _point(script, lines, one, steps[0], skins[0], switches, timeout, 0.0)
    for k in range(repeat):
        for at, (one, dt, skin) in enumerate(tries):
            tell(f"{script.name}: {one.title}, {dt:g} times the timestep, round {k + 1} of {repeat}")
            error = _apart(forces["exact"], forces[one.name])
            found.setdefault(at, []).append(_point(script, lines, one, dt, skin, switches, timeout, error))
    points = [sorted(some, key=lambda p: p.per_time)[(len(some) - 1) // 2] for some in found.values()]
    spans = [p.tau * p.loop.steps for p in points if p.loop is not None and p.good]
    return Sweep(script, points, statistics.median(spans) if spans else math.nan)


def order(points: Sequence[Point]) -> float | None:
    """Slope of the spread over the timestep, both logarithmic: 2 for velocity Verlet."""
    good = [p for p in points if p.spread > 0.0]
    if len({p.dt for p in good}) < 2:
        return None
    return float(np.polyfit(np.log([p.tau for p in good]), np.log([p.spread for p in good]), 1)[0])


def seconds_within(points: Sequence[Point], error: float, time: float) -> float | None:
    """Seconds to simulate that time with a spread of no more than error: between measured timesteps by a power law; None: not reached."""
    curve = sorted((p for p in points if p.spread > 0.0), key=lambda p: p.spread)
    if not curve or curve[0].spread > error:
        return None
    below = [p for p in curve if p.spread <= error]
    above = [p for p in curve if p.spread > error]
    if not above:
        return time * min(p.per_time for p in below)
    a, b = below[-1], above[0]
    share = math.log(error / a.spread) / math.log(b.spread / a.spread)
    return time * math.exp((1.0 - share) * math.log(a.per_time) + share * math.log(b.per_time))


def front(points: Sequence[Point]) -> list[Point]:
    """Those that nobody beats in both time and error."""
    best: list[Point] = []
    for point in sorted((p for p in points if p.good and p.spread > 0.0), key=lambda p: (p.per_time, p.spread)):
        if not best or point.spread < best[-1].spread:
            best.append(point)
    return best


def _launch(
    script: Path, lines: list[str], one: Contender, switches: Sequence[str], timeout: float | None, folder: Path
) -> tuple[child.Child | None, str]:
    """(how it ended, its log); None: it took too long."""
    for path in script.parent.iterdir():
        if path.is_file() and path.name != "log.lammps":
            shutil.copy2(path, folder / path.name)
    text = lines if one.native else translate(lines).rewritten
    (folder / script.name).write_text("\n".join(text) + "\n", errors="surrogateescape")
    try:
        done = child.run(one.command(script.name, switches), folder, one.environment, timeout)
    except subprocess.TimeoutExpired:
        return None, ""
    log = folder / "log.lammps"
    return done, log.read_text(errors="replace") if log.is_file() else ""


def _forces(script: Path, lines: list[str], one: Contender, switches: Sequence[str], timeout: float | None) -> Floats | None:
    with tempfile.TemporaryDirectory(prefix="pylmp-bench-") as place:
        done, _ = _launch(script, variant.first_forces(lines), one, switches, timeout, Path(place))
        path = Path(place) / variant.FORCES
        if done is None or done.code or not path.is_file():
            return None
        rows = path.read_text().split("ITEM: ATOMS")[-1].splitlines()[1:]
        return np.array([[float(word) for word in row.split()] for row in rows])


def _apart(true: Floats | None, found: Floats | None) -> float:
    if true is None or found is None or true.shape != found.shape:
        return math.nan
    size = float(np.sqrt((true[:, 1:] ** 2).mean()))
    return float(np.sqrt(((found - true)[:, 1:] ** 2).mean())) / size if size else 0.0


def _point(
    script: Path, lines: list[str], one: Contender, dt: float, skin: float | None, switches: Sequence[str], timeout: float | None, force: float
) -> Point:
    with tempfile.TemporaryDirectory(prefix="pylmp-bench-") as place:
        done, log = _launch(script, variant.changed(lines, dt, skin), one, switches, timeout, Path(place))
    if done is None:
        return Point(one, dt, skin, said=f"no end after {timeout:g} s; --timeout gives it longer")
    tables, runs = read.tables(log), loops(log)
    mine = next((t for t in reversed(tables) if [c.lower() for c in t.columns][:3] == ["step", "time", "dt"]), None)
    if mine is None or len(mine.rows) < 2:
        return Point(one, dt, skin, said=complaint(log if "ERROR" in log else log + done.said) or f"exit code {done.code}")
    cells = np.array([[float(cell) for cell in row] for row in mine.rows])
    time, kinetic, energy = cells[:, 1], cells[:, 3], cells[:, 5]
    finite = np.isfinite(cells).all(axis=1)
    tau = float(cells[0, 2])
    if done.code or not finite.all():
        return Point(one, dt, skin, tau, force=force, blew=float(time[np.flatnonzero(finite)[-1]] if finite.any() else time[0]))
    u0, breaks = variant.depth(lines), None
    if u0 is not None:
        broken = cells[0, 6] - cells[:, 6]
        energy = energy + u0 * broken
        breaks = float(time[np.argmax(broken > 0)]) if (broken > 0).any() else None
    loop = runs[-1]
    slope, start = np.polyfit(time - time[0], energy, 1)
    rest = energy - start - slope * (time - time[0])
    heat = 2.0 * float(kinetic.mean())  # kT times the degrees of freedom
    return Point(
        one, dt, skin, tau, loop, done.seconds - sum(run.seconds for run in runs), loop.seconds / (tau * loop.steps), float(rest.std()) / loop.atoms,
        float(slope) / heat if heat else math.nan, force, breaks,
    )  # fmt: skip
