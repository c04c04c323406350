"""A sweep as text, as one JSON object, as a picture, and as one page for a browser."""

from __future__ import annotations

import io
import math
import os
from html import escape
from pathlib import Path
from typing import Any

from pylmp.io.whole_file import write_whole
from pylmp.text.diagnostic import ScriptError
from pylmp.tools.bench.sweep import Point, Sweep, front, order, seconds_within
from pylmp.tools.bench.table import NOTHING, grid

HEAD = (
    "engine", "dt", "skin", "steps/s", "Matom-step/s", "time/day", "outside loops, s", "s per time", "sd(E)/atom", "drift, kT/time/dof", "force error",
    "first break", "remarks",
)  # fmt: skip
_COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")  # told apart by color-blind eyes
_MARKS = "os^Dv<"


def target(swept: Sweep, given: float | None) -> float:
    """The error within which engines are compared: given, or the largest of the runs with the timestep nearest to the script's."""
    good = [p for p in swept.points if p.good and p.spread > 0.0]
    if given is not None or not good:
        return given if given is not None else math.nan
    nearest = min(abs(math.log(p.dt)) for p in good)
    return max(p.spread for p in good if abs(math.log(p.dt)) == nearest)


def headlines(swept: Sweep, error: float) -> list[tuple[str, float | None, float | None]]:
    """(engine, seconds to simulate the script's last run within the error, order of convergence)."""
    return [
        (f"{title}, skin {skin:g}" if skin is not None else title, seconds_within(points, error, swept.time), order(points))
        for (title, skin), points in swept.curves().items()
    ]


def text(swept: Sweep, error: float) -> str:
    best = {id(p) for p in front(swept.points)}
    rows = [HEAD, *(_row(p, id(p) in best) for p in swept.points)]
    lines = [f"{swept.script.name}: the last run, {swept.time:g} units of time", *grid(rows), ""]
    for title, seconds, slope in headlines(swept, error):
        reached = f"{seconds:.3g} s" if seconds is not None else "not reached"
        fitted = f"; sd(E) ~ dt^{slope:.2f} (velocity Verlet: 2)" if slope is not None else ""
        lines.append(f"  {title}: {reached} to simulate {swept.time:g} within sd(E)/atom {error:.2g}{fitted}")
    return "\n".join([*lines, "  * nobody beats it in both time and error"])


def _row(point: Point, best: bool) -> tuple[str, ...]:
    name = ("* " if best else "") + point.contender.title
    start = (name, f"{point.tau:g}" if math.isfinite(point.tau) else f"{point.dt:g} x", NOTHING if point.skin is None else f"{point.skin:g}")
    loop = point.loop
    if loop is None:
        said = point.said.splitlines()[0] if point.said else f"blew up after time {point.blew:g}"
        return (*start, *[NOTHING] * (len(HEAD) - 4), said)
    rate = loop.steps / loop.seconds
    return (
        *start, f"{rate:.0f}", f"{rate * loop.atoms / 1e6:.2f}", f"{86400.0 * rate * point.tau:.0f}", f"{point.around:.2f}", f"{point.per_time:.3g}",
        f"{point.spread:.2e}", f"{point.drift:.1e}", f"{point.force:.1e}", NOTHING if point.breaks is None else f"{point.breaks:g}",
        f"ran on {loop.instead}" if loop.instead else "",
    )  # fmt: skip


def as_dict(swept: Sweep, error: float, machine: dict[str, Any]) -> dict[str, Any]:
    best = {id(p) for p in front(swept.points)}
    points = [
        {
            "engine": p.contender.name, "dt": p.tau, "times_dt": p.dt, "skin": p.skin, "failed": p.said, "blew_up_after": p.blew,
            "steps": p.loop.steps if p.loop else None, "atoms": p.loop.atoms if p.loop else None, "loop": p.loop.seconds if p.loop else None,
            "outside_loops": p.around, "seconds_per_time": p.per_time, "sd_energy_per_atom": p.spread, "drift_kT_per_time_per_dof": p.drift,
            "force_error": p.force, "first_break": p.breaks, "front": id(p) in best,
        }
        for p in swept.points
    ]  # fmt: skip
    points = [{k: None if isinstance(v, float) and not math.isfinite(v) else v for k, v in p.items()} for p in points]
    within = [{"curve": title, "seconds": seconds, "order": slope} for title, seconds, slope in headlines(swept, error)]
    return {"schema": 1, "machine": machine, "script": swept.script.name, "time": swept.time, "error": error, "within": within, "points": points}


def picture(swept: Sweep, error: float, form: str) -> bytes:
    """Seconds per unit of simulated time against error; form: svg or png. Wants matplotlib."""
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    out = io.BytesIO()
    with rc_context({"svg.hashsalt": "pylmp", "svg.fonttype": "none", "font.size": 10}):
        figure = Figure(figsize=(7.5, 4.8), layout="constrained")
        axes = figure.add_subplot()
        for k, ((title, skin), points) in enumerate(swept.curves().items()):
            name = title if skin is None else f"{title}, skin {skin:g}"
            x, y = [p.spread for p in points], [p.per_time for p in points]
            axes.plot(x, y, marker=_MARKS[k % len(_MARKS)], color=_COLORS[k % len(_COLORS)], label=name)
            for p in points:
                axes.annotate(f"{p.tau:g}", (p.spread, p.per_time), textcoords="offset points", xytext=(5, 4), fontsize=7)
        best = front(swept.points)
        axes.plot([p.spread for p in best], [p.per_time for p in best], "o", ms=13, mfc="none", mec="black", label="nobody better in both")
        axes.axvline(error, color="gray", ls=":", label=f"error {error:.2g}")
        axes.margins(0.12)
        axes.set(xscale="log", yscale="log", xlabel="standard deviation of the conserved energy per atom (energy)", ylabel="seconds per unit of simulated time")
        axes.set_title(f"{swept.script.name}: time against error; numbers are timesteps", fontsize=10)
        axes.legend(fontsize=8)
        figure.savefig(out, format=form, dpi=150, metadata={"Date": None} if form == "svg" else None)
    return out.getvalue()


def save(path: Path, swept: Sweep, error: float, said: str) -> None:
    """A picture (.svg, .png) or a page with it (.html). Raises ScriptError where it cannot be written, or the ending says neither."""
    form = path.suffix.lstrip(".").lower()
    try:
        if form == "html":
            drawn = picture(swept, error, "svg").decode()
            title = escape(swept.script.name)
            write_whole(
                path,
                f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>body {{ font: 15px system-ui, sans-serif;'
                " margin: 2rem auto; max-width: 80rem; padding: 0 1rem; color: #1d1d1f; background: #fff } pre { overflow-x: auto; font-size: 12px }"
                f"</style></head><body>\n<h1>Time against error: {title}</h1>\n{drawn[drawn.index('<svg'):]}\n<pre>{escape(said)}</pre>\n</body></html>\n",
            )
            return
        beside = path.with_name(path.name + ".new")
        beside.write_bytes(picture(swept, error, form))
        os.replace(beside, path)
    except OSError as wrong:
        raise ScriptError(f"Cannot write {path}: {wrong.strerror}") from None
