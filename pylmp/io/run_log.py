"""What the log says after a run: loop time, performance, where the time went, neighbors.

Layout as LAMMPS 22 Jul 2025 prints it on one process. Tools that read logs rely on `Per MPI rank memory allocation`
before a table and on `Loop time` after it.
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from pylmp.model.engine import RunReport
from pylmp.model.minimize import MinReport
from pylmp.model.simulation import Simulation
from pylmp.text.number import eight

# a unit of time in nanoseconds; of electron in femtoseconds
_NANOSECONDS = {"real": 1.0e-6, "metal": 1.0e-3, "electron": 1.0, "micro": 1.0e3, "nano": 1.0}
_TABLE = (
    "\nMPI task timing breakdown:\nSection |  min time  |  avg time  |  max time  |%varavg| %total\n"
    "---------------------------------------------------------------\n"
)


def memory_line(sim: Simulation) -> str:
    """Megabytes in arrays of atoms and neighbor lists."""
    megabytes = sum(_bytes(owner) for owner in (sim.atoms, getattr(sim.lists, "forces", None), sim.lists)) / 1024 / 1024
    text = f"{megabytes:.4g}"
    return f"Per MPI rank memory allocation (min/avg/max) = {text} | {text} | {text} Mbytes\n"


def _bytes(owner: Any) -> int:
    """Bytes in numpy arrays that owner, or a part of it, holds directly."""
    parts = [owner, *(part for part in vars(owner).values() if hasattr(part, "__dict__"))] if owner is not None else []
    return sum(a.nbytes for part in parts for a in vars(part).values() if isinstance(a, np.ndarray))


def loop_time(sim: Simulation, report: RunReport) -> str:
    """The line below the table; timer off leaves it out."""
    if sim.timer.style == "off":
        return ""
    return f"Loop time of {report.seconds:g} on 1 procs for {report.steps} steps with {sim.natoms} atoms\n\n"


def footer(sim: Simulation, report: RunReport) -> str:
    """Everything below the loop time."""
    timed = sim.timer.style != "off"
    said = _performance(sim, report) + _processor(sim, report) if timed else ""
    return said + _timings(sim, report) + "\n" + _neighbors(sim, report)


def minimized(sim: Simulation, report: RunReport, result: MinReport) -> str:
    """Everything below the loop time of a minimization."""
    energies = " ".join(f"{energy:18.15g}" for energy in result.energies)
    stats = (
        "\nMinimization stats:\n"
        f"  Stopping criterion = {result.criterion}\n"
        f"  Energy initial, next-to-last, final = \n    {energies}\n"
        f"  Force two-norm initial, final = {result.norms[0]:.8g} {result.norms[1]:.8g}\n"
        f"  Force max component initial, final = {result.largest[0]:.8g} {result.largest[1]:.8g}\n"
        f"  Final line search alpha, max atom move = {result.alpha:.8g} {result.alpha * result.largest[1]:.8g}\n"
        f"  Iterations, force evaluations = {result.iterations} {result.evaluations}\n"
    )
    return _processor(sim, report) + stats + _timings(sim, report) + "\n" + _neighbors(sim, report)


def _performance(sim: Simulation, report: RunReport) -> str:
    text = ""
    if report.steps and report.seconds > 0.0:
        rate = report.steps / report.seconds
        per_day = 24.0 * 3600.0 * rate * sim.dt
        atoms, prefix = _scaled(rate * sim.natoms)
        speed = f"{per_day:.3f} tau/day"
        if sim.units.name in _NANOSECONDS:
            unit = "fs" if sim.units.name == "electron" else "ns"
            size = _NANOSECONDS[sim.units.name]
            speed = f"{per_day * size:.3f} {unit}/day, {24.0 / (per_day * size) if per_day else 0.0:.3f} hours/{unit}"
        if sim.units.name not in ("si", "cgs"):
            text = f"Performance: {speed}, {rate:.3f} timesteps/s, {atoms:.3f} {prefix}atom-step/s\n"
    return text


def _processor(sim: Simulation, report: RunReport) -> str:
    spent = time.process_time() - sim.output.started[1]
    share = 100.0 * spent / report.seconds if report.seconds > 0.0 else 0.0
    return f"{share:.1f}% CPU use with 1 MPI tasks x 1 OpenMP threads\n"


def _scaled(value: float) -> tuple[float, str]:
    """value and its prefix, chosen as LAMMPS does."""
    for limit, prefix in ((1.0e9, "G"), (1.0e6, "M"), (1.0e3, "k")):
        if value > limit:
            return value / limit, prefix
    return value, ""


def _timings(sim: Simulation, report: RunReport) -> str:
    """The table of sections, with the processor's share under timer full."""
    style = sim.timer.style
    if style in ("off", "loop"):
        return ""
    full = style == "full"
    whole = report.seconds
    known = {name: seconds for name, seconds in report.sections.items() if name != "Bond" or sim.has_bonds}
    rows = ""
    for name, seconds in known.items():
        share = 100.0 * seconds / whole if whole > 0.0 else 0.0
        spent = report.processor.get(name, 0.0)
        busy = f"{100.0 * spent / seconds if seconds > 0.0 else 0.0:6.1f} |" if full else ""
        rows += f"{name:<8}| {seconds:<10.5g} | {seconds:<10.5g} | {seconds:<10.5g} |{0.0:6.1f} |{busy}{share:6.2f}\n"
    other = max(0.0, whole - sum(known.values()))
    share = 100.0 * other / whole if whole > 0.0 else 0.0
    head = _TABLE.replace("| %total", "|  %CPU | %total").rstrip("\n") + "--------\n" if full else _TABLE
    blank = "       |" if full else ""
    return head + rows + f"{'Other':<8}|            | {other:<10.4g} |            |       |{blank}{share:6.2f}\n"


def _neighbors(sim: Simulation, report: RunReport) -> str:
    atoms = sim.atoms.n
    text = ""
    counts = [("Nlocal:", atoms), ("Nghost:", report.ghosts), ("Neighs:", report.neighbors)]
    neighbors = report.neighbors
    if report.full_neighbors is not None:
        neighbors = report.full_neighbors
        counts.append(("FullNghs:", neighbors))
    for name, count in counts:
        value = eight(count)
        text += f"{name:<8}   {value:>11} ave {value:>11} max {value:>11} min\nHistogram: 1 0 0 0 0 0 0 0 0 0\n"
    text += f"\nTotal # of neighbors = {neighbors}\n"
    if atoms:
        text += f"Ave neighs/atom = {eight(neighbors / atoms)}\n"
        if sim.has_bonds:
            special = int(sim.atoms.num_special[:atoms, 2].sum())
            text += f"Ave special neighs/atom = {eight(special / atoms)}\n"
    text += f"Neighbor list builds = {report.builds}\n"
    return text + (
        f"Dangerous builds = {report.dangerous}\n" if sim.neighbor.check else "Dangerous builds not checked\n"
    )
